#pragma once

#include <QFrame>
#include <QTextCursor>

class QLabel;
class QLineEdit;
class QPlainTextEdit;

namespace analogon::ui {

/// Finds a word in a text: a small line at the text's upper right corner. Enter and F3 go to the next place, with Shift
/// to the one before, Escape leaves.
class FindBar : public QFrame {
    Q_OBJECT

public:
    explicit FindBar(QPlainTextEdit& text);

    /// With what is selected in the text, if it is within a line.
    void open();
    void next(bool isBackward = false);
    void place();
    /// All places, to be marked; none while the bar is closed.
    const QList<QTextCursor>& places() const { return places_; }
    /// The text is another one.
    void search();
    QLineEdit* field() const { return field_; }
    QLabel* count() const { return count_; }

Q_SIGNALS:
    void placesChanged();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void leave();
    void look();
    void sayCount();

    QPlainTextEdit& text_;
    QLineEdit* field_;
    QLabel* count_;
    QList<QTextCursor> places_;
    int from_{};  // where the search began, so that a longer word does not move on
};

}  // namespace analogon::ui
