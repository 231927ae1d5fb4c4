#pragma once

#include <string>

#include "core/base/text.hpp"
#include "core/measure/text/layout.hpp"

/// What to try where a row of a table cannot be read.
namespace analogon {

/// A row of `found` cells below a header of `expected`.
Text hintOfLength(std::size_t found, std::size_t expected, const Layout& layout, LineReader behind);

/// A cell that is no number; `isBehindGap`: the row stands behind an empty line.
Text hintOfWord(const std::string& text, const Layout& layout, bool isBehindGap, LineReader behind);

}  // namespace analogon
