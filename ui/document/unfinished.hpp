#pragma once

#include "core/base/diagnostic.hpp"

namespace analogon::ui {

/// Whether a fault only says that the work is not finished: what is not connected, or has no column yet. It keeps a run
/// from beginning, and is no mistake as long as none is asked for.
bool isUnfinished(const Diagnostic& fault);

}  // namespace analogon::ui
