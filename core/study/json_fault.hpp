#pragma once

#include <nlohmann/json.hpp>

#include "core/base/diagnostic.hpp"

namespace analogon {

/// Why a text is no JSON: one sentence, with the place as far as the parser or the text tells it.
Diagnostic jsonFault(const SourcePtr& text, const nlohmann::ordered_json::exception& failure);

}  // namespace analogon
