#include "ui/plot/time_keys.hpp"

#include <QKeyEvent>
#include <algorithm>

namespace analogon::ui {

double TimeView::pointer() const { return cursor && *cursor >= from && *cursor <= to ? *cursor : (from + to) / 2; }

TimeView TimeView::zoomed(double about, double factor) const {
    return {about - (about - from) * factor, about + (to - about) * factor, cursor};
}

TimeKey timeKeyOf(const QKeyEvent& event, const TimeView& view) {
    using Wish = TimeKey::Wish;
    constexpr double step = 0.01, shift = 0.1, closer = 0.8;  // parts of the range
    const double pointer = view.pointer();
    switch (event.key()) {
        case Qt::Key_Left:
        case Qt::Key_Right: {
            const double sign = event.key() == Qt::Key_Left ? -1 : 1, along = sign * view.span();
            if (event.modifiers() & Qt::ControlModifier)
                return {Wish::Range, {view.from + along * shift, view.to + along * shift}};
            return {Wish::Point, {}, std::clamp(pointer + along * step, view.from, view.to)};
        }
        case Qt::Key_Plus:
        case Qt::Key_Minus:
            return {Wish::Range, view.zoomed(pointer, event.key() == Qt::Key_Plus ? closer : 1 / closer)};
        case Qt::Key_Return:
        case Qt::Key_Enter:
            return {Wish::Mark, {}, pointer};
        case Qt::Key_Home:
            return {Wish::All};
        default:
            return {};
    }
}

}  // namespace analogon::ui
