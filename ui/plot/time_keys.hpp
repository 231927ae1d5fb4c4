#pragma once

#include <QObject>
#include <optional>

class QKeyEvent;

namespace analogon::ui {

/// What is seen of the time, and where the pointer of the keys is in it.
struct TimeView {
    double from{}, to{};
    std::optional<double> cursor{};  // may be outside

    double span() const { return to - from; }
    /// The cursor, or the middle where it is not seen.
    double pointer() const;
    /// The range that is seen when it is drawn together about a time.
    TimeView zoomed(double about, double factor) const;
};

/// What a key asks of a plot over time: Left and Right move the pointer, with Ctrl the range; Plus and Minus zoom about
/// the pointer, Enter marks it, Home shows all.
struct TimeKey {
    enum class Wish { None, Range, Point, Mark, All };
    Wish wish{Wish::None};
    TimeView range{};  // of Range
    double time{};     // of Point and Mark
};
TimeKey timeKeyOf(const QKeyEvent& event, const TimeView& view);

/// Asks for it by the signals of the plot; false: the key is none of these.
template <class Plot>
bool answerTimeKey(Plot& plot, const QKeyEvent& event, const TimeView& view) {
    const TimeKey key = timeKeyOf(event, view);
    switch (key.wish) {
        case TimeKey::Wish::Range:
            Q_EMIT plot.timeRangeWanted(key.range.from, key.range.to);
            return true;
        case TimeKey::Wish::Point:
            Q_EMIT plot.pointedAt(key.time);
            return true;
        case TimeKey::Wish::Mark:
            Q_EMIT plot.markWanted(key.time);
            return true;
        case TimeKey::Wish::All:
            Q_EMIT plot.allWanted();
            return true;
        case TimeKey::Wish::None:
            break;
    }
    return false;
}

}  // namespace analogon::ui
