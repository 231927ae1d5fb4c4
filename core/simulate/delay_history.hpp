#pragma once

#include <cstddef>
#include <vector>

namespace analogon {

/// What a delayed signal was, in a run with events: pieces without jumps, each of points that straight lines join.
/// delay(u, T) is u(t - T); before the begin of the run, u at the begin (Modelica 3.6, section 3.7.4.1).
class DelayHistory {
public:
    explicit DelayHistory(double delay) : delay_(delay) {}

    double delay() const { return delay_; }  // [s], above 0
    bool isEmpty() const { return pieces_.empty(); }
    /// A point of the signal, later than those before.
    void add(double time, double value);
    /// The signal behind an event: where it has jumped, a piece begins.
    void addBehindEvent(double time, double value);

    /// All jumps that arrive up to this time have arrived; later ones have not.
    void arriveUpTo(double time);
    /// When the next jump arrives; infinite: none is under way.
    double nextArrival() const;
    /// The delayed signal and its slope, on the piece that has arrived.
    double at(double time) const;
    double slopeAt(double time) const;

private:
    struct Point {
        double time{}, value{};
    };
    /// Before which point of the piece that has arrived this time of the signal lies; at least 1.
    std::size_t lineOf(double time) const;

    double delay_;
    std::vector<std::vector<Point>> pieces_;
    std::size_t arrived_{};  // piece
};

}  // namespace analogon
