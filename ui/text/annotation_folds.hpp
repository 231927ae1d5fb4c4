#pragma once

#include <QObject>
#include <QTextBlock>
#include <QTextCursor>
#include <vector>

class QPlainTextEdit;

namespace analogon::ui {

class Highlighter;

/// What stands between the brackets of an annotation: characters of the whole text, the end excluded.
struct AnnotationRange {
    int begin{}, end{};

    friend bool operator==(const AnnotationRange&, const AnnotationRange&) = default;
};

/// The annotations of a Modelica text, in order; one within another belongs to the outer one. Texts and comments hold
/// none, and one whose bracket is not closed is none yet.
std::vector<AnnotationRange> annotationsIn(const QString& text);

/// Folds annotations of a text away: on their first line there is room for a mark, the rest takes none. Long ones are
/// folded until they are opened; the caret opens what it comes into. The text stays whole: it is copied, found and
/// saved with what is folded.
class AnnotationFolds : public QObject {
    Q_OBJECT

public:
    AnnotationFolds(QPlainTextEdit& text, Highlighter& colours);

    /// The text is another one.
    void update();
    /// Opens all that begin on this line, or folds them where all are open.
    void toggle(const QTextBlock& line);
    void setAllFolded(bool areFolded);
    /// Opens what is folded about this character.
    void reveal(int position);

    enum class Line { Plain, Folded, Open };
    Line lineAt(const QTextBlock& block) const;
    /// Where the mark of each fold of a line stands: the first character that is not to be read.
    std::vector<int> marksOf(const QTextBlock& block) const;
    int folded() const;

    static constexpr int markWidth = 3;  // characters

Q_SIGNALS:
    void changed();

private:
    struct Fold {
        AnnotationRange range;
        bool isFolded{};
    };
    void apply();
    QTextCursor cursorAt(int position) const;
    void takeCaretOut();
    std::vector<Fold>::const_iterator firstOf(const QTextBlock& block) const;

    QPlainTextEdit& text_;
    Highlighter& colours_;
    std::vector<Fold> folds_;
    int blocks_{};                        // as they were told apart last
    QList<QTextCursor> opened_, closed_;  // by the user: their first characters, wherever these move
};

}  // namespace analogon::ui
