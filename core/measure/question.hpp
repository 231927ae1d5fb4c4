#pragma once

#include <string>
#include <vector>

#include "core/base/text.hpp"
#include "core/measure/read_options.hpp"

namespace analogon {

/// One way to read a text: what is told of it, beside what was told before.
struct Reading {
    Text label;
    ReadOptions options;
};

/// What a text does not tell and nothing in it decides.
struct Question {
    enum class Kind {
        Choice,    // one of the readings
        Interval,  // the time between two rows, which is typed: there are no readings
        Unit       // what a unit means: one of the readings, or one that is typed
    };
    Kind kind{Kind::Choice};
    Text text;
    int line{};  // where it shows first; 0: in every row
    std::vector<Reading> readings{};
    std::string unit{};  // that is asked about, as the file has it
};

using Questions = std::vector<Question>;

}  // namespace analogon
