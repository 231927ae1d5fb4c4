#pragma once

#include "core/base/limits.hpp"

namespace analogon {

/// How large a text of JSON may be where nothing else is said.
struct JsonSize {
    std::size_t bytes{limits::jsonBytes};
    std::size_t values{limits::jsonValues};
};

/// Whether a text of JSON may be parsed: at most of this size, and as deep as limits.hpp allows. Looks at brackets and
/// commas outside of texts alone, once from begin to end; what else is wrong the parser tells.
Outcome<Done> checkJsonLimits(const Source& json, const JsonSize& most = {});

}  // namespace analogon
