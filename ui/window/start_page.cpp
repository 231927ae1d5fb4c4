#include "ui/window/start_page.hpp"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QTextStream>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/style/ink.hpp"
#include "ui/style/style.hpp"
#include "ui/window/recovered_line.hpp"

namespace analogon::ui {

namespace {

QDir examplesDirectory() {
    const QStringList places{qEnvironmentVariable("ANALOGON_EXAMPLES"),
                             QCoreApplication::applicationDirPath() + "/../share/analogon/examples",
                             QStringLiteral(ANALOGON_SOURCE_EXAMPLES)};
    for (const QString& place : places)
        if (!place.isEmpty() && QDir(place).exists()) return QDir(place);
    return QDir();
}

/// Heading and first paragraph of a README.
void describe(const QString& readme, Example& example) {
    QFile file(readme);
    if (!file.open(QIODevice::ReadOnly | QIODevice::Text)) return;
    QTextStream stream(&file);
    QString paragraph;
    while (!stream.atEnd()) {
        const QString line = stream.readLine().trimmed();
        if (line.startsWith("# ") && paragraph.isEmpty())
            example.title = line.mid(2);
        else if (line.isEmpty() && !paragraph.isEmpty())
            break;
        else if (!line.isEmpty() && !line.startsWith('#'))
            paragraph += (paragraph.isEmpty() ? "" : " ") + line;
    }
    paragraph.remove('`');
    const auto translated = [](const QString& text) {
        return QCoreApplication::translate("Examples", text.toUtf8().constData());
    };
    example.title = translated(example.title);
    example.description = translated(paragraph);
}

/// An example as a card: the whole of it is the button.
class Card : public QAbstractButton {
public:
    Card(const Example& example, QWidget* parent) : QAbstractButton(parent), example_(example) {
        setText(example.title);
        setAccessibleDescription(example.description);
        setCursor(Qt::PointingHandCursor);
        setFocusPolicy(Qt::StrongFocus);
        setAttribute(Qt::WA_Hover);
        setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    }
    QSize sizeHint() const override {
        const int line = fontMetrics().height();
        return {440, 3 * line + 2 * style::margin + style::unit};
    }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        const bool isActive = underMouse() || hasFocus();
        const QPalette& p = palette();
        painter.setPen(QPen(isActive ? style::accent(p) : style::hairline(p), 1));
        painter.setBrush(isDown() ? p.color(QPalette::AlternateBase) : p.color(QPalette::Base));
        painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);
        const int icon = 28;
        const QRect iconBox(style::margin + style::unit, (height() - icon) / 2, icon, icon);
        style::icon(example_.icon).paint(&painter, iconBox);
        const QRect box = rect().adjusted(iconBox.right() + style::margin + style::unit, style::margin, -style::margin,
                                          -style::margin);
        QFont bold = font();
        bold.setWeight(QFont::DemiBold);
        painter.setFont(bold);
        painter.setPen(p.color(QPalette::Text));
        painter.drawText(box, Qt::AlignLeft | Qt::AlignTop, example_.title);
        painter.setFont(font());
        painter.setPen(style::mutedText(p));
        const QRect below = box.adjusted(0, fontMetrics().height() + style::unit / 2, 0, 0);
        const QString text = shortened(example_.description, below.width());
        painter.drawText(below, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, text);
    }

private:
    /// As many of its sentences as two lines hold; where not even one goes in, as many words.
    QString shortened(const QString& text, int width) const {
        const QFontMetrics metrics(font());
        const auto fits = [&](const QString& part) {
            return metrics.boundingRect(QRect(0, 0, width, 1000), Qt::TextWordWrap, part).height() <=
                   2 * metrics.lineSpacing() + 2;
        };
        if (fits(text)) return text;
        for (qsizetype end = text.lastIndexOf(". "); end > 0; end = text.lastIndexOf(". ", end - 1))
            if (fits(text.left(end + 1))) return text.left(end + 1);
        QString result = text;
        while (!fits(result) && result.size() > 8)
            result = result.left(result.lastIndexOf(' ', -3)) + QStringLiteral(" …");
        return result;
    }
    Example example_;
};

}  // namespace

std::vector<Example> findExamples() {
    std::vector<Example> examples;
    const QDir directory = examplesDirectory();
    for (const QFileInfo& entry : directory.entryInfoList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name)) {
        Example example;
        for (const QString& place : {entry.filePath() + "/study", entry.filePath()})
            if (QFile::exists(place + "/study.json")) example.path = place;
        if (example.path.isEmpty()) continue;
        example.title = entry.fileName();
        example.icon = "example-" + entry.fileName();
        if (!QFile::exists(":/icons/" + example.icon + ".svg")) example.icon = "example";
        describe(entry.filePath() + "/README.md", example);
        examples.push_back(example);
    }
    return examples;
}

bool isExample(const QString& path) {
    const QString whole = QFileInfo(path).canonicalFilePath(), place = examplesDirectory().canonicalPath();
    return !place.isEmpty() && whole.startsWith(place + "/");
}

StartPage::StartPage(std::vector<Example> examples, QWidget* parent)
    : QWidget(parent), fault_(new QLabel(this)), work_(new QVBoxLayout) {
    auto* title = new QLabel(QStringLiteral("Analogon"), this);
    style::makeHeading(title, 2.4);
    auto* subtitle =
        new QLabel(tr("Physical models from test-bench measurements: fit the parameters, find the effect the "
                      "model lacks, see the evidence."),
                   this);
    subtitle->setWordWrap(true);
    auto* open = new QPushButton(tr("Open a study …"), this);
    open->setIcon(style::icon("open"));
    open->setDefault(true);
    open->setMinimumHeight(8 * style::unit);
    auto* fresh = new QPushButton(tr("New study"), this);
    fresh->setIcon(style::icon("new"));
    fresh->setMinimumHeight(8 * style::unit);
    connect(fresh, &QPushButton::clicked, this, &StartPage::newWanted);
    auto* generate = new QPushButton(tr("Generate from measurement …"), this);
    generate->setIcon(style::icon("recording"));
    generate->setMinimumHeight(8 * style::unit);
    connect(generate, &QPushButton::clicked, this, &StartPage::generateWanted);
    auto* hint =
        new QLabel(tr("Or drop a study (a directory, its study.json, an .analogon file) or recordings here"), this);
    style::makeCaption(hint);
    fault_->setWordWrap(true);
    fault_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    fault_->hide();

    auto* column = new QVBoxLayout;
    column->setSpacing(2 * style::unit);
    column->addStretch(2);
    column->addWidget(title);
    column->addWidget(subtitle);
    column->addSpacing(3 * style::unit);
    auto* row = new QHBoxLayout;
    row->setSpacing(3 * style::unit);
    row->addWidget(open);
    row->addWidget(fresh);
    row->addWidget(generate);
    row->addStretch(1);
    column->addLayout(row);
    column->addWidget(hint);
    column->addWidget(fault_);
    work_->setSpacing(style::unit);
    column->addLayout(work_);
    column->addSpacing(4 * style::unit);
    auto* heading = new QLabel(examples.empty() ? QString() : tr("Examples"), this);
    style::makeHeading(heading);
    column->addWidget(heading);
    for (const Example& example : examples) {
        auto* card = new Card(example, this);
        connect(card, &QAbstractButton::clicked, this, [this, path = example.path] { Q_EMIT exampleChosen(path); });
        column->addWidget(card);
    }
    column->addStretch(3);
    auto* outer = new QHBoxLayout(this);
    outer->addStretch(1);
    auto* holder = new QWidget(this);
    holder->setMaximumWidth(640);
    holder->setMinimumWidth(360);
    column->setContentsMargins(0, 0, 0, 0);
    holder->setLayout(column);
    outer->addWidget(holder, 8);
    outer->addStretch(1);
    connect(open, &QPushButton::clicked, this, &StartPage::openWanted);
}

void StartPage::showWork(const QStringList& recent, const std::vector<Recovered>& recovered) {
    while (QLayoutItem* item = work_->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    const auto addHeading = [&](const QString& text) {
        work_->addSpacing(3 * style::unit);
        auto* label = new QLabel(text, this);
        style::makeHeading(label);
        work_->addWidget(label);
    };
    if (!recovered.empty()) addHeading(tr("Recovered work"));
    for (const Recovered& r : recovered) {
        auto* line = new RecoveredLine(r, this);
        connect(line, &RecoveredLine::chosen, this, &StartPage::recoveryChosen);
        work_->addWidget(line);
    }
    bool isFirst = true;
    for (const QString& path : recent.mid(0, 4)) {
        if (!QFileInfo::exists(path)) continue;
        if (std::exchange(isFirst, false)) addHeading(tr("Recent"));
        auto* link = new QLabel(this);
        const auto write = [link, path] {
            link->setText(
                QStringLiteral(
                    "<a href=\"%1\" style=\"text-decoration:none\">%2</a> &nbsp;<span style=\"color:%4\">%3</span>")
                    .arg(path.toHtmlEscaped(), QFileInfo(path).fileName().toHtmlEscaped(),
                         QFileInfo(path).path().toHtmlEscaped(), style::mutedText(link->palette()).name()));
        };
        write();
        style::onThemeChange(*link, write);
        link->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
        connect(link, &QLabel::linkActivated, this, &StartPage::exampleChosen);
        work_->addWidget(link);
    }
}

void StartPage::showFault(const QString& text) {
    fault_->setText(text);
    fault_->setVisible(!text.isEmpty());
    style::tint(*fault_, style::fault);
}

}  // namespace analogon::ui
