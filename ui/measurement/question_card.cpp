#include "ui/measurement/question_card.hpp"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "core/base/unit.hpp"
#include "ui/measurement/read_fields.hpp"
#include "ui/style/style.hpp"
#include "ui/words/words.hpp"

namespace analogon::ui {

namespace {

enum ReadingColumn { Line, InTheFile, FirstReading };

QTableWidgetItem* cellOf(const QString& text, bool isNumber) {
    auto* item = new QTableWidgetItem(text);
    item->setFlags(Qt::ItemIsEnabled);
    item->setTextAlignment((isNumber ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    item->setToolTip(text);
    return item;
}

}  // namespace

QuestionCard::QuestionCard(QWidget* parent)
    : QFrame(parent),
      text_(new QLabel(this)),
      note_(new QLabel(this)),
      table_(new QTableWidget(this)),
      typed_(new QLineEdit(this)),
      answers_(new QGridLayout),
      typedRow_(new QHBoxLayout) {
    setFrameShape(QFrame::StyledPanel);
    style::makeHeading(text_, 1.05);
    style::makeCaption(note_);
    for (QLabel* label : {text_, note_}) label->setWordWrap(true);
    table_->setFrameShape(QFrame::NoFrame);
    table_->verticalHeader()->hide();
    table_->setSelectionMode(QAbstractItemView::NoSelection);
    table_->setFocusPolicy(Qt::NoFocus);
    table_->setWordWrap(false);
    table_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table_->setAccessibleName(tr("The rows under each reading"));
    typed_->setMaximumWidth(200);
    connect(typed_, &QLineEdit::returnPressed, this, &QuestionCard::takeTyped);
    connect(typed_, &QLineEdit::textChanged, this, [this] {
        if (take_) take_->setEnabled(typed().has_value());
    });
    answers_->setSpacing(2 * style::unit);
    answers_->setColumnStretch(2, 1);
    typedRow_->setSpacing(2 * style::unit);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(style::margin, style::margin, style::margin, style::margin);
    layout->setSpacing(2 * style::unit);
    layout->addWidget(text_);
    layout->addWidget(table_);
    layout->addLayout(answers_);
    layout->addLayout(typedRow_);
    layout->addWidget(note_);
}

void QuestionCard::ask(const Question& question, const QuestionRows& rows, const ReadOptions& read) {
    read_ = read;
    kind_ = question.kind;
    unit_ = question.unit;
    text_->setText(inWords(question.text));
    clear(answers_);
    clear(typedRow_);
    buttons_.clear();
    take_ = nullptr;
    typed_->clear();
    typed_->setVisible(kind_ != Question::Kind::Choice);
    table_->setVisible(kind_ != Question::Kind::Interval && !rows.rows.empty());
    if (kind_ != Question::Kind::Interval) fill(question, rows);
    for (const Reading& reading : question.readings) {
        QPushButton* const button = addButton(inWords(reading.label));
        const auto place = static_cast<int>(buttons_.size()) - 1;
        answers_->addWidget(button, place / 2, place % 2);  // more beside each other do not fit a narrow window
        connect(button, &QPushButton::clicked, this, [this, options = reading.options] { Q_EMIT answered(options); });
    }
    if (kind_ == Question::Kind::Interval) {
        addTyped(tr("0.001 s, or 1 kHz"), tr("Time between two rows"), tr("Take this time"));
        note_->setText(tr("Or choose the column that is the time above. The time is counted from the first row."));
    } else {
        if (kind_ == Question::Kind::Unit) addTyped(tr("another unit"), tr("Unit"), tr("Take this unit"));
        note_->setText(tr("The file does not tell. What you choose is kept with the study."));
    }
    typedRow_->addStretch(1);
    fitTexts();
}

void QuestionCard::resizeEvent(QResizeEvent* event) {
    QFrame::resizeEvent(event);
    fitTexts();
}

/// A text that breaks asks for one line of height at least: in a page that scrolls the answers would lie over the rows.
void QuestionCard::fitTexts() {
    for (QLabel* label : {text_, note_}) label->setMinimumHeight(std::max(0, label->heightForWidth(label->width())));
}

void QuestionCard::clear(QLayout* row) {
    while (QLayoutItem* item = row->takeAt(0)) {
        if (item->widget() && item->widget() != typed_) item->widget()->deleteLater();
        delete item;
    }
}

void QuestionCard::addTyped(const QString& example, const QString& name, const QString& take) {
    typed_->setPlaceholderText(example);
    typed_->setAccessibleName(name);
    typedRow_->addWidget(typed_);
    take_ = addButton(take);
    typedRow_->addWidget(take_);
    take_->setEnabled(false);
    connect(take_, &QPushButton::clicked, this, &QuestionCard::takeTyped);
}

void QuestionCard::fill(const Question& question, const QuestionRows& rows) {
    const int readings = static_cast<int>(question.readings.size());
    QStringList header{tr("Line"), tr("In the file")};
    for (const Reading& reading : question.readings) header << inWords(reading.label);
    table_->setColumnCount(FirstReading + readings);
    table_->setHorizontalHeaderLabels(header);
    table_->setRowCount(static_cast<int>(rows.rows.size()));
    for (int row = 0; row < table_->rowCount(); ++row) {
        const QuestionRow& shown = rows.rows[static_cast<std::size_t>(row)];
        table_->setItem(row, Line, cellOf(QString::number(shown.line), true));
        table_->setItem(row, InTheFile, cellOf(QString::fromStdString(shown.text), false));
        for (int i = 0; i < readings; ++i)
            table_->setItem(row, FirstReading + i, cellOf(inWords(shown.values[static_cast<std::size_t>(i)]), true));
    }
    QHeaderView* const columns = table_->horizontalHeader();
    columns->setSectionResizeMode(QHeaderView::ResizeToContents);
    columns->setSectionResizeMode(InTheFile, QHeaderView::Stretch);
    // the rows of the file need the room: a long label breaks over its values
    columns->setDefaultAlignment(Qt::AlignCenter | static_cast<Qt::Alignment>(Qt::TextWordWrap));
    columns->setFixedHeight(2 * fontMetrics().height() + 2 * style::unit);
    const QAbstractItemView* const cells = table_;
    for (int i = FirstReading; i < table_->columnCount(); ++i) {
        columns->setSectionResizeMode(i, QHeaderView::Fixed);
        columns->resizeSection(i, std::max(cells->sizeHintForColumn(i), 30 * style::unit));
    }
    const int line = fontMetrics().height() + style::unit;
    table_->verticalHeader()->setDefaultSectionSize(line);
    table_->setFixedHeight(columns->height() + table_->verticalHeader()->length() + 2);
}

QPushButton* QuestionCard::addButton(const QString& text) {
    auto* button = new QPushButton(text, this);
    buttons_ << button;
    return button;
}

/// How the file is read by what is typed; none: it is no time, or no unit.
std::optional<ReadOptions> QuestionCard::typed() const {
    ReadOptions options = read_;
    if (kind_ == Question::Kind::Unit) {
        const std::string unit = typed_->text().trimmed().toStdString();
        if (unit.empty() || !isKnownUnit(unit)) return std::nullopt;
        options.unitNames[unit_] = unit;
    } else {
        const std::optional<std::string> interval = typedInterval(typed_->text());
        if (!interval) return std::nullopt;
        options.timeFormat = *interval;
    }
    return options;
}

void QuestionCard::takeTyped() {
    if (const std::optional<ReadOptions> options = typed()) Q_EMIT answered(*options);
}

}  // namespace analogon::ui
