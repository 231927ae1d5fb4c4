#include "ui/text/annotation_folds.hpp"

#include <QPlainTextDocumentLayout>
#include <QPlainTextEdit>
#include <algorithm>

#include "ui/text/highlighter.hpp"

namespace analogon::ui {

namespace {

constexpr int longest = 24;  // characters of an annotation that is not folded by itself

/// Behind a text, a comment or a quoted name that begins here; the same place where none does.
qsizetype behindQuoted(const QString& text, qsizetype at) {
    const QChar c = text[at];
    const auto ends = [&](QLatin1String mark, qsizetype from) {
        const qsizetype found = text.indexOf(mark, from);
        return found < 0 ? text.size() : found + mark.size();
    };
    if (text.mid(at, 2) == QLatin1String("//")) return ends(QLatin1String("\n"), at);
    if (text.mid(at, 2) == QLatin1String("/*")) return ends(QLatin1String("*/"), at + 2);
    if (c != '"' && c != '\'') return at;
    for (qsizetype i = at + 1; i < text.size(); ++i) {
        if (text[i] == '\\')
            ++i;
        else if (text[i] == c)
            return i + 1;
    }
    return text.size();
}

/// The bracket that closes the one before `at`; -1: none does.
qsizetype closing(const QString& text, qsizetype at) {
    for (int depth = 1; at < text.size();) {
        if (const qsizetype next = behindQuoted(text, at); next > at) {
            at = next;
            continue;
        }
        if (text[at] == '(') ++depth;
        if (text[at] == ')' && --depth == 0) return at;
        ++at;
    }
    return -1;
}

bool isOfName(QChar c) { return c.isLetterOrNumber() || c == '_'; }

bool holds(const QList<QTextCursor>& cursors, int position) {
    return std::any_of(cursors.begin(), cursors.end(), [&](const QTextCursor& c) { return c.position() == position; });
}

void forget(QList<QTextCursor>& cursors, int position) {
    cursors.removeIf([&](const QTextCursor& c) { return c.position() == position; });
}

}  // namespace

std::vector<AnnotationRange> annotationsIn(const QString& text) {
    static const QLatin1String keyword("annotation");
    std::vector<AnnotationRange> found;
    for (qsizetype at = 0; at < text.size();) {
        if (const qsizetype next = behindQuoted(text, at); next > at) {
            at = next;
            continue;
        }
        if (!isOfName(text[at])) {
            ++at;
            continue;
        }
        const qsizetype begin = at;
        while (at < text.size() && isOfName(text[at])) ++at;
        if (QStringView(text).sliced(begin, at - begin) != keyword) continue;
        qsizetype open = at;
        while (open < text.size() && text[open].isSpace()) ++open;
        if (open == text.size() || text[open] != '(') continue;
        const qsizetype close = closing(text, open + 1);
        if (close < 0) return found;
        found.push_back({static_cast<int>(open + 1), static_cast<int>(close)});
        at = close + 1;
    }
    return found;
}

AnnotationFolds::AnnotationFolds(QPlainTextEdit& text, Highlighter& colours)
    : QObject(&text), text_(text), colours_(colours) {
    connect(&text, &QPlainTextEdit::cursorPositionChanged, this, [this] { reveal(text_.textCursor().position()); });
}

void AnnotationFolds::update() {
    const std::vector<AnnotationRange> ranges = annotationsIn(text_.toPlainText());
    const bool isSame = std::equal(ranges.begin(), ranges.end(), folds_.begin(), folds_.end(),
                                   [](const AnnotationRange& range, const Fold& fold) { return range == fold.range; });
    if (isSame && blocks_ == text_.blockCount()) return;
    blocks_ = text_.blockCount();
    folds_.clear();
    const int caret = text_.textCursor().position();
    for (const AnnotationRange& range : ranges) {
        const bool isAbout = text_.hasFocus() && caret >= range.begin && caret <= range.end;
        const bool isLong = range.end - range.begin > longest || holds(closed_, range.begin);
        folds_.push_back({range, isLong && !isAbout && !holds(opened_, range.begin)});
    }
    apply();
}

QTextCursor AnnotationFolds::cursorAt(int position) const {
    QTextCursor cursor(text_.document());
    cursor.setPosition(position);
    return cursor;
}

/// A caret within a fold would be where nothing is seen.
void AnnotationFolds::takeCaretOut() {
    const int caret = text_.textCursor().position();
    for (const Fold& fold : folds_)
        if (fold.isFolded && caret >= fold.range.begin && caret <= fold.range.end)
            text_.setTextCursor(cursorAt(std::max(0, fold.range.begin - 1)));
}

void AnnotationFolds::toggle(const QTextBlock& line) {
    const bool isOpening = lineAt(line) == Line::Folded;
    for (Fold& fold : folds_) {
        if (!line.contains(fold.range.begin)) continue;
        fold.isFolded = !isOpening;
        forget(opened_, fold.range.begin);
        forget(closed_, fold.range.begin);
        (isOpening ? opened_ : closed_).push_back(cursorAt(fold.range.begin));
    }
    takeCaretOut();
    apply();
}

void AnnotationFolds::setAllFolded(bool areFolded) {
    opened_.clear();
    closed_.clear();
    for (Fold& fold : folds_) {
        fold.isFolded = areFolded;
        (areFolded ? closed_ : opened_).push_back(cursorAt(fold.range.begin));
    }
    takeCaretOut();
    apply();
}

void AnnotationFolds::reveal(int position) {
    const auto about = std::find_if(folds_.begin(), folds_.end(), [&](const Fold& fold) {
        return fold.isFolded && position >= fold.range.begin && position < fold.range.end;
    });
    if (about == folds_.end()) return;
    about->isFolded = false;
    forget(closed_, about->range.begin);
    opened_.push_back(cursorAt(about->range.begin));
    apply();
}

std::vector<AnnotationFolds::Fold>::const_iterator AnnotationFolds::firstOf(const QTextBlock& block) const {
    return std::lower_bound(folds_.begin(), folds_.end(), block.position(),
                            [](const Fold& fold, int position) { return fold.range.begin < position; });
}

AnnotationFolds::Line AnnotationFolds::lineAt(const QTextBlock& block) const {
    Line line = Line::Plain;
    for (auto fold = firstOf(block); fold != folds_.end() && block.contains(fold->range.begin); ++fold) {
        if (fold->isFolded) return Line::Folded;
        line = Line::Open;
    }
    return line;
}

std::vector<int> AnnotationFolds::marksOf(const QTextBlock& block) const {
    std::vector<int> marks;
    for (auto fold = firstOf(block); fold != folds_.end() && block.contains(fold->range.begin); ++fold)
        if (fold->isFolded) marks.push_back(fold->range.begin);
    return marks;
}

int AnnotationFolds::folded() const {
    return static_cast<int>(
        std::count_if(folds_.begin(), folds_.end(), [](const Fold& fold) { return fold.isFolded; }));
}

/// Lines that lie wholly within a fold take no room; the characters that are left of its first and last line are
/// coloured so that they take none. What was folded before and is not now is seen again.
void AnnotationFolds::apply() {
    QTextDocument* const document = text_.document();
    Highlighter::HiddenParts hidden;
    std::vector<bool> isGone(static_cast<std::size_t>(document->blockCount()));
    for (const Fold& fold : folds_) {
        if (!fold.isFolded) continue;
        const QTextBlock first = document->findBlock(fold.range.begin), last = document->findBlock(fold.range.end);
        for (QTextBlock block = first; block.isValid(); block = block.next()) {
            const int from = std::max(0, fold.range.begin - block.position());
            const int to = std::min(block.length() - 1, fold.range.end - block.position());
            if (block != first && (block != last || QStringView(block.text()).sliced(to).trimmed().size() <= 2))
                isGone[static_cast<std::size_t>(block.blockNumber())] = true;
            else if (to > from)
                hidden[block.blockNumber()].push_back({from, to - from});
            if (block == last) break;
        }
    }
    colours_.hide(std::move(hidden));
    bool isOtherLayout = false;
    for (QTextBlock block = document->begin(); block.isValid(); block = block.next()) {
        const bool isShown = !isGone[static_cast<std::size_t>(block.blockNumber())];
        if (block.isVisible() == isShown) continue;
        block.setVisible(isShown);
        block.setLineCount(isShown ? std::max(1, block.layout()->lineCount()) : 0);
        isOtherLayout = true;
    }
    if (isOtherLayout) {
        auto* layout = qobject_cast<QPlainTextDocumentLayout*>(document->documentLayout());
        layout->requestUpdate();
        Q_EMIT layout->documentSizeChanged(layout->documentSize());
    }
    Q_EMIT changed();
}

}  // namespace analogon::ui
