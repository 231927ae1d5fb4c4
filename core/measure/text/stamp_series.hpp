#pragma once

#include <vector>

#include "core/measure/text/stamp.hpp"

namespace analogon {

/// The stamps of one column, in a third of the memory: what no stamp has takes none.
class StampSeries {
public:
    std::size_t size() const { return marks_.size(); }
    Stamp operator[](std::size_t row) const;
    void push_back(const Stamp& stamp);
    void put(std::size_t row, const Stamp& stamp);
    void reserve(std::size_t rows);

    class Iterator {
    public:
        Iterator(const StampSeries& series, std::size_t row) : series_(&series), row_(row) {}
        Stamp operator*() const { return (*series_)[row_]; }
        Iterator& operator++() {
            ++row_;
            return *this;
        }
        bool operator!=(const Iterator& other) const { return row_ != other.row_; }

    private:
        const StampSeries* series_;
        std::size_t row_;
    };
    Iterator begin() const { return {*this, 0}; }
    Iterator end() const { return {*this, size()}; }

private:
    std::vector<std::uint8_t> marks_;  // orders and what the clock has, by row
    // empty while every stamp has what a new one has
    std::vector<std::int64_t> nanoseconds_;
    std::vector<std::array<std::int16_t, 3>> dates_;
    std::vector<std::int16_t> zones_;
    std::size_t room_{};
};

}  // namespace analogon
