#pragma once

#include <string>
#include <vector>

namespace analogon {

/// Whether numbers without a unit that are called a time seem to be clocks written without marks, 103059.5 for half
/// past ten and 59.5 seconds, and would be another time as seconds: none has a sixtieth minute or second, and either
/// they are large or their steps are even only so.
bool seemsWrittenClock(const std::vector<double>& times);

/// How such numbers are written: "%H%M%S", or with the date in front "%Y%m%d%H%M%S", "%Y%m%d%H%M", "%Y%m%d". Empty:
/// they seem to be plain numbers.
std::string writtenFormat(const std::vector<double>& times);

}  // namespace analogon
