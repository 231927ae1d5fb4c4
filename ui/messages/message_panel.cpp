#include "ui/messages/message_panel.hpp"

#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QStackedLayout>
#include <algorithm>
#include <set>
#include <tuple>

#include "ui/document/document.hpp"
#include "ui/document/mention.hpp"
#include "ui/document/unfinished.hpp"
#include "ui/style/ink.hpp"
#include "ui/style/style.hpp"
#include "ui/words/words.hpp"

namespace analogon::ui {

namespace {

QString iconName(Severity severity) {
    switch (severity) {
        case Severity::Error:
            return QStringLiteral("error");
        case Severity::Warning:
            return QStringLiteral("warning");
        case Severity::Note:
            break;
    }
    return QStringLiteral("note");
}

/// Faults of a study that is open are mended in the panels, and its file is no place to go to; when it is read, it is.
bool isWithoutPlace(const Message& message) {
    const QFileInfo file(QString::fromStdString(message.diagnostic.place.file));
    return message.origin != Message::Origin::Study && file.fileName() == QLatin1String("study.json");
}

bool hasPlace(const Message& message) { return message.diagnostic.place.line > 0 && !isWithoutPlace(message); }

QString placeText(const Message& message) {
    if (isWithoutPlace(message)) return {};
    const Place& place = message.diagnostic.place;
    QString text = QFileInfo(QString::fromStdString(place.file)).fileName();
    if (place.line > 0) text += QStringLiteral(":%1").arg(place.line);
    if (place.column > 0) text += QStringLiteral(":%1").arg(place.column);
    return text;
}

}  // namespace

MessagePanel::MessagePanel(Document& document, QWidget* parent)
    : QWidget(parent), document_(document), list_(new QListWidget(this)), pages_(new QStackedLayout(this)) {
    auto* empty =
        new QLabel(tr("No messages. What is wrong or worth knowing is listed here; a click leads to the place."), this);
    empty->setAlignment(Qt::AlignCenter);
    empty->setWordWrap(true);
    style::makeCaption(empty);
    list_->setFrameShape(QFrame::NoFrame);
    list_->setWordWrap(true);
    list_->setSpacing(style::unit / 2);
    list_->setIconSize({18, 18});
    list_->setAccessibleName(tr("Messages"));
    style::followTheme(*list_);
    pages_->addWidget(empty);
    pages_->addWidget(list_);
    connect(&document, &Document::messagesChanged, this, &MessagePanel::refresh);
    const auto choose = [this](QListWidgetItem* item) {
        const auto row = item->data(Qt::UserRole).toUInt();
        if (row >= document_.messages().size()) return;
        const Diagnostic& d = document_.messages()[row].diagnostic;
        if (hasPlace(document_.messages()[row])) return Q_EMIT placeChosen(d.place);
        if (const auto mention = mentionIn(document_, d.message)) Q_EMIT mentionChosen(*mention);
    };
    connect(list_, &QListWidget::itemClicked, this, choose);
    connect(list_, &QListWidget::itemActivated, this, choose);
}

void MessagePanel::pointAtError() {
    isRunAsked_ = true;
    refresh();
    for (int row = 0; row < list_->count(); ++row) {
        const auto message = list_->item(row)->data(Qt::UserRole).toUInt();
        if (message >= document_.messages().size() ||
            document_.messages()[message].diagnostic.severity != Severity::Error)
            continue;
        list_->setCurrentRow(row);
        return list_->setFocus();
    }
}

/// What is not connected yet is no error before a run is asked for.
bool MessagePanel::isHint(const Message& message) const {
    const auto isSaidByRun = [&](const Message& other) {
        return other.origin == Message::Origin::Run && other.diagnostic.message == message.diagnostic.message;
    };
    return isUnfinished(message.diagnostic) && !isRunAsked_ &&
           std::none_of(document_.messages().begin(), document_.messages().end(), isSaidByRun);
}

void MessagePanel::refresh() {
    list_->clear();
    const auto isOpen = [](const Message& message) { return isUnfinished(message.diagnostic); };
    if (std::none_of(document_.messages().begin(), document_.messages().end(), isOpen)) isRunAsked_ = false;
    int errors = 0;
    std::set<std::tuple<std::string, int, int>> told;  // reading and running the model find the same fault
    for (std::size_t i = 0; i < document_.messages().size(); ++i) {
        const Diagnostic& d = document_.messages()[i].diagnostic;
        if (!told.emplace(d.message.english(), d.place.line, d.place.column).second) continue;
        QString text = inWords(d.message);
        const QString place = placeText(document_.messages()[i]);
        if (!place.isEmpty()) text = place + "  " + text;
        if (!d.hint.empty()) text += "\n" + inWords(d.hint);
        const bool hint = isHint(document_.messages()[i]);
        auto* item =
            new QListWidgetItem(style::icon(hint ? QStringLiteral("note") : iconName(d.severity)), text, list_);
        item->setData(Qt::UserRole, static_cast<unsigned>(i));
        if (hint) {
            style::tint(*item, style::mutedText, palette());
        } else if (d.severity == Severity::Error) {
            ++errors;
            style::tint(*item, style::fault, palette());
        }
        if (hasPlace(document_.messages()[i]))
            item->setToolTip(QString::fromStdString(d.place.file) + "\n" + tr("Click to see the place"));
        else if (const auto mention = mentionIn(document_, d.message))
            item->setToolTip(tr("Click to see %1").arg(mention->name));
    }
    const int count = list_->count();
    pages_->setCurrentIndex(count > 0 ? 1 : 0);
    Q_EMIT countChanged(errors, count - errors);
}

}  // namespace analogon::ui
