#include "ui/signals/chart_axis.hpp"

#include <QFont>
#include <QPalette>
#include <QPen>
#include <QValueAxis>

#include "ui/signals/log_axis.hpp"
#include "ui/style/style.hpp"

namespace analogon::ui {

namespace {

QFont smaller(QFont font) {
    font.setPointSizeF(font.pointSizeF() * 0.85);
    return font;
}

QColor labelColour(const QPalette& palette) {
    return style::mix(palette.color(QPalette::Text), palette.color(QPalette::Base), 0.35);
}

}  // namespace

void styleAxis(QAbstractAxis& axis, const QFont& font, const QPalette& palette) {
    const QColor base = palette.color(QPalette::Base), text = palette.color(QPalette::Text);
    axis.setLabelsFont(smaller(font));
    axis.setLabelsColor(labelColour(palette));
    axis.setGridLinePen(QPen(style::mix(base, text, 0.10), 1));
    axis.setLinePen(QPen(style::mix(base, text, 0.25), 1));
}

QAbstractAxis* makeAxis(const QString& title, bool isLogarithmic, const QString& linearFormat, const QFont& font,
                        const QPalette& palette) {
    QAbstractAxis* axis = nullptr;
    if (isLogarithmic) {
        axis = new LogAxis;
    } else {
        auto* linear = new QValueAxis;
        linear->setLabelFormat(linearFormat);
        axis = linear;
    }
    axis->setTitleText(title);
    axis->setTitleFont(smaller(font));
    axis->setTitleBrush(labelColour(palette));
    styleAxis(*axis, font, palette);
    return axis;
}

}  // namespace analogon::ui
