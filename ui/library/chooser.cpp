#include "ui/library/chooser.hpp"

#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/library/search_words.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

namespace {

int widthIn(const QSize& room) { return std::min(520, room.width() - 2 * style::margin); }

}  // namespace

Chooser::Chooser(QWidget* parent)
    : QFrame(parent), title_(new QLabel(this)), field_(new QLineEdit(this)), list_(new QListWidget(this)) {
    setFrameShape(QFrame::NoFrame);
    style::makeCaption(title_);
    title_->setWordWrap(true);
    list_->setFrameShape(QFrame::NoFrame);
    list_->setIconSize({24, 24});
    list_->setFocusPolicy(Qt::NoFocus);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setWordWrap(true);
    field_->setClearButtonEnabled(true);
    field_->installEventFilter(this);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(style::margin, style::margin, style::margin, style::margin);
    layout->setSpacing(2 * style::unit);
    layout->addWidget(title_);
    layout->addWidget(field_);
    layout->addWidget(list_, 1);
    connect(field_, &QLineEdit::textChanged, this, &Chooser::filter);
    connect(list_, &QListWidget::itemClicked, this, &Chooser::take);
    hide();
}

void Chooser::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    // filled, not drawn: between whole scales a line at the edge is cut
    painter.fillRect(rect(), style::mix(palette().color(QPalette::Window), style::accent(palette()), 0.6));
    painter.fillRect(rect().adjusted(1, 1, -1, -1), palette().color(QPalette::Window));
}

void Chooser::place() {
    const QSize room = parentWidget()->size();
    const bool isInPlace = !inPlaceOf_.isEmpty();
    const int around = isInPlace ? style::unit : style::margin;
    layout()->setContentsMargins(around, around, around, around);
    title_->setVisible(!isInPlace);
    field_->setToolTip(isInPlace ? title_->text() : QString());
    if (isInPlace) {
        const QSize size(std::max(140, inPlaceOf_.width() + 16 * style::unit), sizeHint().height());
        const QRect inside(QPoint(), room - size);
        const QPoint corner = inPlaceOf_.center() - QPoint(size.width() / 2, size.height() / 2);
        setGeometry({QPoint(std::clamp(corner.x(), 0, std::max(0, inside.width())),
                            std::clamp(corner.y(), 0, std::max(0, inside.height()))),
                     size});
    } else {
        const int width = widthIn(room);
        const int height = isAsking_ ? sizeHint().height() : std::min(400, room.height() - 2 * style::margin);
        setGeometry((room.width() - width) / 2, std::max(0, (room.height() - height) / 3), width, height);
    }
    show();
    raise();
    field_->setFocus(Qt::PopupFocusReason);
}

void Chooser::choose(const QString& title, std::vector<Choice> choices, const QString& typed,
                     std::function<void(const QString&)> chosen) {
    isAsking_ = false;
    inPlaceOf_ = {};
    title_->setText(title);
    choices_ = std::move(choices);
    chosen_ = std::move(chosen);
    list_->show();
    field_->setText(typed);
    filter();
    place();
    field_->setCursorPosition(static_cast<int>(typed.size()));
}

void Chooser::ask(const QString& title, const QString& text, std::function<void(const QString&)> entered) {
    askInPlace({}, title, text, std::move(entered));
}

void Chooser::askInPlace(const QRect& textRect, const QString& title, const QString& text,
                         std::function<void(const QString&)> entered) {
    inPlaceOf_ = textRect;
    isAsking_ = true;
    title_->setText(title);
    choices_.clear();
    chosen_ = std::move(entered);
    list_->hide();
    field_->setText(text);
    place();
    field_->selectAll();
}

void Chooser::filter() {
    if (isAsking_) return;
    list_->clear();
    const int textWidth = widthIn(parentWidget()->size()) - 2 * style::margin - list_->iconSize().width() -
                          style()->pixelMetric(QStyle::PM_ScrollBarExtent) - 6 * style::unit;
    const QStringList words = field_->text().split(' ', Qt::SkipEmptyParts);
    const QString first = words.isEmpty() ? QString() : words.front();
    std::vector<const Choice*> found;
    for (const Choice& choice : choices_)
        if (isFoundIn(QStringList{choice.text, choice.detail, choice.further}.join(u' '), field_->text()))
            found.push_back(&choice);
    // Names that begin with what was typed first, then names that hold it, then descriptions and words that mean it.
    for (int rank = 0; rank < 3; ++rank)
        for (const Choice* one : found) {
            const Choice& choice = *one;
            const int own = choice.text.startsWith(first, Qt::CaseInsensitive) ? 0
                            : choice.text.contains(first, Qt::CaseInsensitive) ? 1
                                                                               : 2;
            if (own != rank) continue;
            const QString text = choice.detail.isEmpty() ? choice.text : choice.text + "  –  " + choice.detail;
            auto* item = new QListWidgetItem(choice.icon, text, list_);
            item->setData(Qt::UserRole, choice.key);
            item->setToolTip(choice.detail);
            // As wide as the list, as high as the text needs there.
            const QRect needed = list_->fontMetrics().boundingRect(QRect(0, 0, textWidth, 400), Qt::TextWordWrap, text);
            item->setSizeHint({10, std::max(30, needed.height() + 2 * style::unit)});
        }
    list_->setCurrentRow(0);
    if (list_->count() > 0) return;
    auto* nothing = new QListWidgetItem(tr("Nothing is called “%1” or described so.").arg(field_->text()), list_);
    nothing->setFlags(Qt::NoItemFlags);
}

void Chooser::take() {
    const QString key = isAsking_              ? field_->text().trimmed()
                        : list_->currentItem() ? list_->currentItem()->data(Qt::UserRole).toString()
                                               : QString();
    if (key.isEmpty()) return;
    const auto chosen = std::move(chosen_);
    leave();
    if (chosen) chosen(key);
}

void Chooser::leave() {
    hide();
    chosen_ = nullptr;
    parentWidget()->setFocus();
}

bool Chooser::eventFilter(QObject* watched, QEvent* event) {
    if (watched != field_) return QFrame::eventFilter(watched, event);
    if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
        event->accept();  // leaves this list, whatever else Escape does in the window
        return true;
    }
    if (event->type() == QEvent::FocusOut && isVisible() &&
        static_cast<QFocusEvent*>(event)->reason() != Qt::ActiveWindowFocusReason &&
        static_cast<QFocusEvent*>(event)->reason() != Qt::PopupFocusReason) {
        hide();
        return false;
    }
    if (event->type() != QEvent::KeyPress) return false;
    switch (static_cast<QKeyEvent*>(event)->key()) {
        case Qt::Key_Escape:
            leave();
            return true;
        case Qt::Key_Return:
        case Qt::Key_Enter:
            take();
            return true;
        case Qt::Key_Down:
            list_->setCurrentRow(std::min(list_->currentRow() + 1, list_->count() - 1));
            return true;
        case Qt::Key_Up:
            list_->setCurrentRow(std::max(list_->currentRow() - 1, 0));
            return true;
        default:
            return false;
    }
}

}  // namespace analogon::ui
