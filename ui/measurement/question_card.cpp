#include "ui/measurement/question_card.hpp"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/measurement/read_fields.hpp"
#include "ui/style/style.hpp"
#include "ui/words/words.hpp"

namespace analogon::ui {

namespace {

enum Column { Line, InTheFile, FirstReading };

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
      interval_(new QLineEdit(this)),
      answers_(new QHBoxLayout) {
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
    interval_->setPlaceholderText(tr("0.001 s, or 1 kHz"));
    interval_->setAccessibleName(tr("Time between two rows"));
    interval_->setMaximumWidth(200);
    connect(interval_, &QLineEdit::returnPressed, this, &QuestionCard::takeInterval);
    connect(interval_, &QLineEdit::textChanged, this, [this](const QString& text) {
        if (!buttons_.isEmpty() && !interval_->isHidden())
            buttons_.front()->setEnabled(typedInterval(text).has_value());
    });
    answers_->setSpacing(2 * style::unit);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(style::margin, style::margin, style::margin, style::margin);
    layout->setSpacing(2 * style::unit);
    layout->addWidget(text_);
    layout->addWidget(table_);
    layout->addLayout(answers_);
    layout->addWidget(note_);
}

void QuestionCard::ask(const Question& question, const QuestionRows& rows, const ReadOptions& read) {
    read_ = read;
    text_->setText(inWords(question.text));
    while (QLayoutItem* item = answers_->takeAt(0)) {
        if (item->widget() && item->widget() != interval_) item->widget()->deleteLater();
        delete item;
    }
    buttons_.clear();
    const bool isInterval = question.kind == Question::Kind::Interval;
    interval_->setVisible(isInterval);
    table_->setVisible(!isInterval && !rows.rows.empty());
    if (isInterval) {
        interval_->clear();
        answers_->addWidget(interval_);
        addButton(tr("Take this time"), {});
        buttons_.front()->setEnabled(false);
        note_->setText(tr("Or choose the column that is the time above. The time is counted from the first row."));
    } else {
        fill(question, rows);
        for (const Reading& reading : question.readings) addButton(inWords(reading.label), reading.options);
        note_->setText(tr("The file does not tell. What you choose is kept with the study."));
    }
    answers_->addStretch(1);
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

void QuestionCard::addButton(const QString& text, const ReadOptions& options) {
    auto* button = new QPushButton(text, this);
    answers_->addWidget(button);
    const bool isInterval = !interval_->isHidden();
    connect(button, &QPushButton::clicked, this, [this, options, isInterval] {
        if (isInterval)
            takeInterval();
        else
            Q_EMIT answered(options);
    });
    buttons_ << button;
}

void QuestionCard::takeInterval() {
    const std::optional<std::string> interval = typedInterval(interval_->text());
    if (!interval) return;
    ReadOptions options = read_;
    options.timeFormat = *interval;
    Q_EMIT answered(options);
}

}  // namespace analogon::ui
