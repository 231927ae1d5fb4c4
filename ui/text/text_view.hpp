#pragma once

#include <QPlainTextEdit>

namespace analogon::ui {

class Document;

/// The model's text, with line numbers. Read only: changes are made on the diagram and in the tables.
class TextView : public QPlainTextEdit {
    Q_OBJECT

public:
    explicit TextView(Document& document, QWidget* parent = nullptr);

    /// Goes to a place and marks it. Lines and columns start at 1; a column counts bytes of UTF-8.
    void showPlace(int line, int column, int length);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    class LineNumbers;
    void refresh();
    void paintLineNumbers(QPaintEvent* event);
    int lineNumberWidth() const;
    void updateMargins();

    Document& document_;
    LineNumbers* lineNumbers_;
};

}  // namespace analogon::ui
