#pragma once

#include "core/study/study.hpp"
#include "ui/document/commands.hpp"

namespace analogon::ui {

/// Whether a run of either would give the same: texts, parameters and recordings, not what is shown of them.
bool isSameModel(const Study& a, const Study& b);
bool isSameModel(const Study& a, const StudySettings& b);

}  // namespace analogon::ui
