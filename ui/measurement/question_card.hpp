#pragma once

#include <QFrame>
#include <optional>

#include "core/measure/text/question_rows.hpp"

class QGridLayout;
class QHBoxLayout;
class QLayout;
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
    /// Of what is typed: a time between two rows, or a unit.
    QLineEdit* typedField() const { return typed_; }
    Question::Kind kind() const { return kind_; }
    /// One for each reading, and the last for what is typed.
    QList<QPushButton*> buttons() const { return buttons_; }

Q_SIGNALS:
    void answered(const analogon::ReadOptions& options);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void fitTexts();
    void fill(const Question& question, const QuestionRows& rows);
    QPushButton* addButton(const QString& text);
    void clear(QLayout* row);
    void addTyped(const QString& example, const QString& name, const QString& take);
    std::optional<ReadOptions> typed() const;
    void takeTyped();

    ReadOptions read_;
    Question::Kind kind_{};
    std::string unit_;  // that is asked about
    QLabel *text_, *note_;
    QTableWidget* table_;
    QLineEdit* typed_;
    QGridLayout* answers_;
    QHBoxLayout* typedRow_;
    QList<QPushButton*> buttons_;
    QPushButton* take_{};  // what is typed
};

}  // namespace analogon::ui
