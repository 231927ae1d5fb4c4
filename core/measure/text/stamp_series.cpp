#include "core/measure/text/stamp_series.hpp"

namespace analogon {

namespace {

constexpr std::uint8_t clock = 1 << 3, twoFields = 1 << 4, fraction = 1 << 5, mayCount = 1 << 6,
                       counts = 1 << 7;  // behind the three orders

std::uint8_t marksOf(const Stamp& stamp) {
    return static_cast<std::uint8_t>(stamp.orders | (stamp.hasClock ? clock : 0) |
                                     (stamp.hasTwoFields ? twoFields : 0) | (stamp.hasFraction ? fraction : 0) |
                                     (stamp.mayCountDays ? mayCount : 0) | (stamp.countsDays ? counts : 0));
}

/// A value of a row; the list comes to be with the first that is not the usual one.
template <class Value>
void putIn(std::vector<Value>& list, std::size_t row, const Value& value, const Value& usual, std::size_t room) {
    if (list.empty() && value == usual) return;
    if (list.empty()) list.reserve(room);
    if (list.size() < row) list.resize(row, usual);
    if (list.size() == row)
        list.push_back(value);
    else
        list[row] = value;
}

}  // namespace

Stamp StampSeries::operator[](std::size_t row) const {
    const std::uint8_t marks = marks_[row];
    Stamp stamp;
    stamp.orders = marks & 7;
    stamp.hasClock = (marks & clock) != 0;
    stamp.hasTwoFields = (marks & twoFields) != 0;
    stamp.hasFraction = (marks & fraction) != 0;
    stamp.mayCountDays = (marks & mayCount) != 0;
    stamp.countsDays = (marks & counts) != 0;
    if (row < nanoseconds_.size()) stamp.nanoseconds = nanoseconds_[row];
    if (row < dates_.size()) stamp.date = dates_[row];
    if (row < zones_.size()) stamp.zone = zones_[row];
    return stamp;
}

void StampSeries::push_back(const Stamp& stamp) {
    marks_.push_back(0);
    put(marks_.size() - 1, stamp);
}

void StampSeries::put(std::size_t row, const Stamp& stamp) {
    const Stamp usual;
    marks_[row] = marksOf(stamp);
    putIn(nanoseconds_, row, stamp.nanoseconds, usual.nanoseconds, room_);
    putIn(dates_, row, stamp.date, usual.date, room_);
    putIn(zones_, row, stamp.zone, usual.zone, room_);
}

void StampSeries::reserve(std::size_t rows) {
    room_ = rows;
    marks_.reserve(rows);
}

}  // namespace analogon
