#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/measure/text/text_view.hpp"

namespace analogon {

/// A text without what some programs write around or within each row, with blanks in its place so that everything stays
/// where it is: the settings of a scope beside its first samples ("Sample Interval,0.1,,-1.0,20.0"), quotation marks
/// around whole lines, and a decimal comma in the stamps of a table whose columns are parted by commas
/// ("2024-06-15 10:30:00,123,20.5").
struct UnframedText {
    TextView text;
    std::vector<std::string> pairs{};  // the settings, "key,value"
    char separator{};                  // between key and value
};

/// None: every one of the first lines would have to look so. A text with a supply is changed where it is, line by line
/// as it is loaded; of another one `store` holds the changed copy.
std::optional<UnframedText> withoutFrames(TextView text, std::string& store);

}  // namespace analogon
