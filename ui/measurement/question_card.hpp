#pragma once

#include <QFrame>

#include "core/measure/text/question_rows.hpp"

class QHBoxLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace analogon::ui {

/// What a file does not tell, with its rows under each of the readings. It answers with how the file is to be read.
class QuestionCard : public QFrame {
    Q_OBJECT

public:
    explicit QuestionCard(QWidget* parent = nullptr);

    /// `read`: how the file was read when this came up.
    void ask(const Question& question, const QuestionRows& rows, const ReadOptions& read);
    QTableWidget* table() const { return table_; }
    QLineEdit* intervalField() const { return interval_; }
    /// One for each reading.
    QList<QPushButton*> buttons() const { return buttons_; }

Q_SIGNALS:
    void answered(const analogon::ReadOptions& options);

private:
    void fill(const Question& question, const QuestionRows& rows);
    void addButton(const QString& text, const ReadOptions& options);
    void takeInterval();

    ReadOptions read_;
    QLabel *text_, *note_;
    QTableWidget* table_;
    QLineEdit* interval_;
    QHBoxLayout* answers_;
    QList<QPushButton*> buttons_;
};

}  // namespace analogon::ui
