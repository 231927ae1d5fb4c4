#pragma once

#include <string>
#include <vector>

#include "core/base/text.hpp"

namespace analogon {

/// What a time without a unit counts, where it is not plainly seconds since the start.
struct CountedTime {
    std::string unit{};  // "ms", "us", "ns" since 1970; empty: seconds, or nobody can tell
    bool mayBeDays{};    // days since 1900 or since the year 0, as spreadsheets and MATLAB count, or seconds
};
CountedTime countedTime(const std::vector<double>& values);

/// That the numbers of a column are taken for such a unit since 1970.
Text toldSince1970(const std::string& name, const std::string& unit);

/// The unit that is taken, and what is doubtful about it, in the notes; empty: nothing was found.
std::string takenTimeUnit(const std::string& name, const std::vector<double>& values, std::vector<Text>& notes);

}  // namespace analogon
