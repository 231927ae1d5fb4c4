#pragma once

#include <QPalette>
#include <QSyntaxHighlighter>

namespace analogon::ui {

/// Colours for Modelica: keywords, strings, comments, numbers; annotations step back.
class Highlighter : public QSyntaxHighlighter {
public:
    explicit Highlighter(QTextDocument* document) : QSyntaxHighlighter(document) {}
    void setPalette(const QPalette& palette) {
        palette_ = palette;
        rehighlight();
    }

protected:
    void highlightBlock(const QString& text) override;

private:
    QPalette palette_;
};

}  // namespace analogon::ui
