#include "ui/text/highlighter.hpp"

#include <QRegularExpression>
#include <QSet>
#include <QTextDocument>
#include <utility>

#include "ui/style/style.hpp"
#include "ui/text/annotation_folds.hpp"

namespace analogon::ui {

namespace {

const QSet<QString>& keywords() {
    static const QSet<QString> words{"within",    "package",  "model",      "block",         "connector", "type",
                                     "record",    "partial",  "final",      "extends",       "redeclare", "replaceable",
                                     "protected", "public",   "parameter",  "constant",      "input",     "output",
                                     "flow",      "equation", "initial",    "connect",       "if",        "then",
                                     "else",      "elseif",   "for",        "loop",          "in",        "end",
                                     "der",       "time",     "annotation", "constrainedby", "each",      "import"};
    return words;
}

enum State { Normal = 0, InComment = 1 };

}  // namespace

void Highlighter::hide(HiddenParts parts) {
    const HiddenParts before = std::exchange(hidden_, std::move(parts));
    QSet<int> lines;
    for (const auto& [line, now] : hidden_)
        if (const auto same = before.find(line); same == before.end() || same->second != now) lines.insert(line);
    for (const auto& [line, was] : before)
        if (!hidden_.contains(line)) lines.insert(line);
    for (const int line : lines)
        if (const QTextBlock block = document()->findBlockByNumber(line); block.isValid()) rehighlightBlock(block);
}

void Highlighter::highlightBlock(const QString& text) {
    colour(text);
    const auto parts = hidden_.find(currentBlock().blockNumber());
    if (parts == hidden_.end()) return;
    QTextCharFormat unseen;
    unseen.setForeground(Qt::transparent);
    QTextCharFormat gone = unseen;
    gone.setProperty(QTextFormat::FontPixelSize, 1);
    gone.setFontLetterSpacingType(QFont::PercentageSpacing);
    gone.setFontLetterSpacing(1);
    for (const auto& [first, count] : parts->second) {
        const int kept = std::min(count, AnnotationFolds::markWidth);
        setFormat(first, kept, unseen);
        setFormat(first + kept, count - kept, gone);
    }
}

void Highlighter::colour(const QString& text) {
    static const QRegularExpression token(
        R"re((?<comment>//.*$)|(?<open>/\*)|(?<string>"(?:\\.|[^"\\])*"?)|(?<number>\b\d+(?:\.\d*)?(?:[eE][+-]?\d+)?)|(?<word>[A-Za-z_][A-Za-z0-9_]*))re");
    const QColor comment = style::mix(palette_.color(QPalette::Text), palette_.color(QPalette::Base), 0.36);
    const QColor string = style::good(palette_);
    const QColor number = style::caution(palette_);
    QTextCharFormat keyword;
    keyword.setForeground(style::accentText(palette_));
    keyword.setFontWeight(QFont::DemiBold);

    setCurrentBlockState(Normal);
    qsizetype at = 0;
    const auto comments = [&](qsizetype from) {  // to the end of a /* comment */, which may lie on a later line
        const qsizetype close = text.indexOf("*/", from);
        const qsizetype end = close < 0 ? text.size() : close + 2;
        setFormat(static_cast<int>(from), static_cast<int>(end - from), comment);
        if (close < 0) setCurrentBlockState(InComment);
        return end;
    };
    if (previousBlockState() == InComment) at = comments(0);
    while (at < text.size()) {
        const QRegularExpressionMatch match = token.match(text, at);
        if (!match.hasMatch()) return;
        const int begin = static_cast<int>(match.capturedStart()), length = static_cast<int>(match.capturedLength());
        at = match.capturedEnd();
        if (match.hasCaptured("comment")) setFormat(begin, length, comment);
        if (match.hasCaptured("open")) at = comments(begin);
        if (match.hasCaptured("string")) setFormat(begin, length, string);
        if (match.hasCaptured("number")) setFormat(begin, length, number);
        if (match.hasCaptured("word") && keywords().contains(match.captured())) setFormat(begin, length, keyword);
        if (match.captured() == "annotation") {  // drawing data: kept in view, but quiet
            setFormat(begin, static_cast<int>(text.size()) - begin, comment);
            return;
        }
    }
}

}  // namespace analogon::ui
