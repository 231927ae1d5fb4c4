#include "ui/measurement/read_fields.hpp"

#include <QComboBox>
#include <QGridLayout>
#include <QIntValidator>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QToolButton>

#include "core/measure/text/time_format.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

namespace {

constexpr int columns = 3, inSight = 3;

std::optional<char> markIn(const QComboBox* box) {
    const QString text = box->currentData().toString();
    return text.isEmpty() ? std::nullopt : std::optional(text.front().toLatin1());
}

void showMark(QComboBox* box, std::optional<char> mark) {
    box->setCurrentIndex(mark ? std::max(0, box->findData(QString(QLatin1Char(*mark)))) : 0);
}

std::optional<std::size_t> countIn(const QLineEdit* line) {
    bool isCount = false;
    const auto count = line->text().trimmed().toUInt(&isCount);
    return isCount ? std::optional<std::size_t>(count) : std::nullopt;
}

void showCount(QLineEdit* line, std::optional<std::size_t> count) {
    line->setText(count ? QString::number(*count) : QString());
}

}  // namespace

std::optional<std::string> typedInterval(const QString& text) {
    std::string step = text.trimmed().replace(',', '.').toStdString();
    return intervalOf(step) ? std::optional(std::move(step)) : std::nullopt;
}

ReadFields::ReadFields(QWidget* parent) : QWidget(parent), grid_(new QGridLayout(this)), more_(new QToolButton(this)) {
    grid_->setContentsMargins(0, 0, 0, 0);
    grid_->setHorizontalSpacing(3 * style::unit);
    grid_->setVerticalSpacing(style::unit / 2);
    separator_ = addChoice(tr("Separator"), {});
    for (const auto& [text, sign] :
         {std::pair{tr("comma"), ","}, {tr("semicolon"), ";"}, {tr("tab"), "\t"}, {tr("space"), " "}, {tr("bar"), "|"}})
        separator_->addItem(text, QString(sign));
    decimal_ = addChoice(tr("Decimal sign"), {});
    for (const auto& [text, sign] : {std::pair{tr("point"), "."}, {tr("comma"), ","}})
        decimal_->addItem(text, QString(sign));
    units_ = addChoice(tr("Row of units"), {});
    units_->addItem(tr("yes"), QStringLiteral("1"));
    units_->addItem(tr("no"), QStringLiteral("0"));
    thousands_ = addChoice(tr("Sign between thousands"), tr("1 234 567.8 has blanks between thousands"));
    for (const auto& [text, sign] :
         {std::pair{tr("point"), "."}, {tr("comma"), ","}, {tr("apostrophe"), "'"}, {tr("space"), " "}})
        thousands_->addItem(text, QString(sign));
    skip_ = addLine(tr("Lines to skip"), tr("automatic"), tr("Lines in front of the header that are not looked at"));
    header_ = addLine(tr("Rows of the header"), tr("automatic"), tr("The row of units included; 0: there is none"));
    for (QLineEdit* line : {skip_, header_}) line->setValidator(new QIntValidator(0, 1'000'000, line));
    timeFormat_ =
        addLine(tr("Form of the time"), QStringLiteral("%d.%m.%Y %H:%M:%S"),
                tr("How dates and clocks are written: %d.%m.%Y %H:%M:%S. Of rows without a time the step from "
                   "one to the next: 0.001 s or 1 kHz. Of a time without a unit the unit: ms"));
    timeZone_ = addLine(tr("Time zone"), QStringLiteral("Europe/Berlin"), tr("Of stamps that do not tell it"));
    times_ = addChoice(tr("Several times"), tr("Where several columns are times: which of them a channel has"));
    times_->addItem(tr("the first for all"), static_cast<int>(TimeColumns::One));
    times_->addItem(tr("the one on the left"), static_cast<int>(TimeColumns::Left));
    times_->addItem(tr("the one on the right"), static_cast<int>(TimeColumns::Right));
    encoding_ = addChoice(tr("Letters"), tr("How the bytes of the file are letters"));
    for (const char* name : {"utf-8", "windows-1252", "iso-8859-1", "utf-16le", "utf-16be", "utf-32le", "utf-32be"})
        encoding_->addItem(QString(name), QString(name));
    more_->setCheckable(true);
    more_->setAutoRaise(true);
    more_->setText(tr("More about how it is written"));
    more_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    more_->setArrowType(Qt::RightArrow);
    grid_->addWidget(more_, 2 * ((cells_ + columns - 1) / columns), 0, 1, columns, Qt::AlignLeft);
    connect(more_, &QToolButton::toggled, this, &ReadFields::showRest);
    showRest(false);
}

void ReadFields::add(const QString& text, QWidget* field) {
    auto* label = new QLabel(text, this);
    label->setBuddy(field);
    if (cells_ >= columns)
        label->setContentsMargins(0, 2 * style::unit, 0, 0);  // nearer to its own field than to the upper
    field->setMinimumWidth(110);
    // the label above its field: three columns fit into a narrow panel in any language
    grid_->addWidget(label, cells_ / columns * 2, cells_ % columns, Qt::AlignLeft | Qt::AlignBottom);
    grid_->addWidget(field, cells_ / columns * 2 + 1, cells_ % columns);
    grid_->setColumnStretch(cells_ % columns, 1);
    ++cells_;
}

QLineEdit* ReadFields::addLine(const QString& text, const QString& example, const QString& tip) {
    auto* line = new QLineEdit(this);
    line->setPlaceholderText(example);
    line->setToolTip(tip);
    connect(line, &QLineEdit::editingFinished, this, [this, line] {
        if (line->isModified()) Q_EMIT changed();
        line->setModified(false);
    });
    add(text, line);
    return line;
}

QComboBox* ReadFields::addChoice(const QString& text, const QString& tip) {
    auto* box = new QComboBox(this);
    box->addItem(tr("automatic"), QString());
    box->setToolTip(tip);
    connect(box, &QComboBox::activated, this, &ReadFields::changed);
    add(text, box);
    return box;
}

void ReadFields::showRest(bool isShown) {
    more_->setArrowType(isShown ? Qt::DownArrow : Qt::RightArrow);
    for (int i = 0; i < grid_->count(); ++i) {
        int row = 0, column = 0, rows = 0, width = 0;
        grid_->getItemPosition(i, &row, &column, &rows, &width);
        QWidget* const widget = grid_->itemAt(i)->widget();
        if (row >= 2 * (inSight / columns) && widget != more_) widget->setVisible(isShown);
    }
}

ReadOptions ReadFields::options() const {
    ReadOptions options;
    options.separator = markIn(separator_);
    options.decimal = markIn(decimal_);
    options.thousands = markIn(thousands_);
    options.skip = countIn(skip_);
    options.header = countIn(header_);
    if (const QString units = units_->currentData().toString(); !units.isEmpty()) options.hasUnitsRow = units == "1";
    const QString time = timeFormat_->text().trimmed();
    options.timeFormat = typedInterval(time).value_or(time.toStdString());
    options.timeZone = timeZone_->text().trimmed().toStdString();
    options.times = static_cast<TimeColumns>(times_->currentData().toInt());  // 0: automatic
    options.encoding = encoding_->currentData().toString().toStdString();
    options.unitNames = unitNames_;
    return options;
}

void ReadFields::show(const ReadOptions& options) {
    showMark(separator_, options.separator);
    showMark(decimal_, options.decimal);
    showMark(thousands_, options.thousands);
    showCount(skip_, options.skip);
    showCount(header_, options.header);
    units_->setCurrentIndex(!options.hasUnitsRow ? 0 : *options.hasUnitsRow ? 1 : 2);
    timeFormat_->setText(QString::fromStdString(options.timeFormat));
    timeZone_->setText(QString::fromStdString(options.timeZone));
    times_->setCurrentIndex(options.times == TimeColumns::Found ? 0
                                                                : times_->findData(static_cast<int>(options.times)));
    encoding_->setCurrentIndex(std::max(0, encoding_->findData(QString::fromStdString(options.encoding))));
    unitNames_ = options.unitNames;
    ReadOptions rest = options;
    rest.unitNames.clear();
    rest.separator = rest.decimal = std::nullopt;
    rest.hasUnitsRow.reset();
    if (rest != ReadOptions{}) more_->setChecked(true);  // what was told is in sight
}

}  // namespace analogon::ui
