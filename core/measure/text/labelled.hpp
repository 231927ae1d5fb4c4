#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/measure/text/layout.hpp"

namespace analogon {

/// A text without what programs write around its numbers, with blanks in its place so that every number stays where it
/// is: names in front of them ("T1:20.5, T2:21", "T=23.4 P=7"), an arrow behind a stamp ("10:00:01.250 -> 20.5"), and
/// brackets around one ("[2024-03-05 10:00:01] T=23.4").
struct LabelledText {
    std::string text;
    std::vector<std::string> names{};  // the same in each row; empty: only stamps have something around them
};

/// None: nearly every of the first lines would have to look so.
std::optional<LabelledText> withoutLabels(std::string_view text);

/// The names in front of the numbers become those of the columns; `original`: the text as it was.
void nameByLabels(Layout& layout, const LabelledText& labelled, std::string_view original);

}  // namespace analogon
