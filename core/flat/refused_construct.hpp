#pragma once

#include <optional>
#include <string_view>

#include "core/flat/messages.hpp"

namespace analogon {

/// A construct of Modelica 3.6 that is not carried out, and what does the same.
struct RefusedConstruct {
    Text what, hint;
};

/// By the name of an operator, type or prefix that belongs to it; nothing where the name is none of those.
std::optional<RefusedConstruct> refusedConstruct(std::string_view name);

/// Says so, and nothing more of the model; false where the name is none of those.
bool tellRefused(Messages& messages, std::string_view name, const Span& span);

}  // namespace analogon
