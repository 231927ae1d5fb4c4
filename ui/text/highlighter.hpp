#pragma once

#include <QPalette>
#include <QSyntaxHighlighter>
#include <map>

namespace analogon::ui {

/// Colours for Modelica: keywords, strings, comments, numbers; annotations step back.
class Highlighter : public QSyntaxHighlighter {
public:
    explicit Highlighter(QTextDocument* document) : QSyntaxHighlighter(document) {}
    void setPalette(const QPalette& palette) {
        palette_ = palette;
        rehighlight();
    }
    /// Parts of lines, by the number of the line: first character and how many. The first of each keep their room,
    /// without being seen, for a mark in their place (AnnotationFolds::markWidth); the others take none.
    using HiddenParts = std::map<int, QList<std::pair<int, int>>>;
    void hide(HiddenParts parts);

protected:
    void highlightBlock(const QString& text) override;

private:
    void colour(const QString& text);

    QPalette palette_;
    HiddenParts hidden_;
};

}  // namespace analogon::ui
