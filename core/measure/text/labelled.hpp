#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/measure/text/layout.hpp"
#include "core/measure/text/text_view.hpp"

namespace analogon {

/// A text without what programs write around its numbers, with blanks in its place so that every number stays where it
/// is: names in front of them ("T1:20.5, T2:21", "T=23.4 P=7"), an arrow behind a stamp ("10:00:01.250 -> 20.5"), and
/// brackets around one ("[2024-03-05 10:00:01] T=23.4").
struct LabelledText {
    TextView text;
    std::string head{};                // the first lines as they were
    std::vector<std::string> names{};  // the same in each row; empty: only stamps have something around them
};

/// None: nearly every of the first lines would have to look so. A text with a supply is changed where it is, line by
/// line as it is loaded; of another one `store` holds the changed copy.
std::optional<LabelledText> withoutLabels(TextView text, std::string& store);

/// The names in front of the numbers become those of the columns.
void nameByLabels(Layout& layout, const LabelledText& labelled);

}  // namespace analogon
