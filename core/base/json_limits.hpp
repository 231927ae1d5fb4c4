#pragma once

#include "core/base/limits.hpp"

namespace analogon {

/// Whether a text of JSON may be parsed: as large, as deep and of as many values as limits.hpp allows. Looks at
/// brackets and commas outside of texts alone, once from begin to end; what else is wrong the parser tells.
Outcome<Done> checkJsonLimits(const Source& json);

}  // namespace analogon
