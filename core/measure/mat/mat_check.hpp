#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/text.hpp"
#include "core/measure/byte_view.hpp"

namespace analogon::mat {

/// A variable that only MATLAB itself can read.
struct OpaqueVariable {
    std::string name;
    std::string className;
};

/// What a look at the lengths of a file says, before a library that trusts them reads it.
struct Check {
    std::optional<Text> fault;  // why it cannot be read
    std::vector<OpaqueVariable> opaque;
};

/// Levels 4 and 5 (to 7): every length within what holds it, dimensions no larger than their data.
Check checkLevel4(ByteView file);
Check checkLevel5(ByteView file);

/// Level 4 has no mark of its own: whether the first variable makes sense.
bool looksLikeLevel4(ByteView file);

}  // namespace analogon::mat
