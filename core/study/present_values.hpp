#pragma once

#include "core/study/study.hpp"

namespace analogon {

/// The study with the values that study.json holds for its parameters written into the text of its model.
Outcome<Study> withPresentValues(const Study& study);

}  // namespace analogon
