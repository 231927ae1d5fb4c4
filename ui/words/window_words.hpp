#pragma once

#include <string>

namespace analogon::ui {

/// What the window says in the place of a sentence that tells how a study is written down: which field, menu or panel
/// it is done with. The pattern has the same arguments; null: the sentence is said as it is.
const char* windowPattern(const std::string& pattern);

}  // namespace analogon::ui
