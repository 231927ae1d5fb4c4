#pragma once

#include <QPlainTextEdit>
#include <QTextBlock>
#include <QTimer>

namespace analogon::ui {

class AnnotationFolds;
class Document;
class FindBar;
class NamePopup;
struct Message;

/// The model's text, with line numbers. What is typed here is seen in the diagram a moment later, and the other way
/// round; both are steps of one undo list. Ctrl+F finds in it, names are offered while one types; what messages speak
/// of is underlined. Long annotations are folded away (ui/text/annotation_folds).
class TextView : public QPlainTextEdit {
    Q_OBJECT

public:
    explicit TextView(Document& document, QWidget* parent = nullptr);

    /// Goes to a place and marks it. Lines and columns start at 1; a column counts bytes of UTF-8.
    void showPlace(int line, int column, int length);
    FindBar* findBar() const { return find_; }
    NamePopup* names() const { return names_; }
    AnnotationFolds& folds() const { return *folds_; }
    /// Where one clicks to fold a line or to open it, in the coordinates of the margin.
    QRect foldMark(int line) const;
    QWidget* margin() const;

protected:
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    class LineNumbers;
    void refresh();
    void recolour();
    void commit();
    QTextCursor cursorAt(int line, int column, int length) const;
    void underline();
    void showMarks();
    void paintLineNumbers(QPaintEvent* event);
    void paintFoldMark(QPainter& painter, const QTextBlock& block, const QRectF& line) const;
    int lineNumberWidth() const;
    void updateMargins();
    void updateFolds();
    bool foldAt(const QPointF& inMargin);
    QRectF foldRect(int position) const;
    bool foldBy(const QKeyEvent& key);

    Document& document_;
    LineNumbers* lineNumbers_;
    FindBar* find_;
    NamePopup* names_;
    AnnotationFolds* folds_{};
    QList<QTextEdit::ExtraSelection> faults_, shown_;  // that messages speak of; the place that was asked for
    QTimer typing_;
    bool isRefreshing_{}, isStale_{};
};

}  // namespace analogon::ui
