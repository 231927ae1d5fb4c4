#pragma once

#include "core/base/diagnostic.hpp"

namespace analogon {

/// Each message once, the first time it is said at its place; faults before what is only worth knowing.
Diagnostics distinct(Diagnostics diagnostics);

/// What has not been said yet, each once.
Diagnostics notYetTold(Diagnostics diagnostics, const Diagnostics& told);

/// Whether both say the same of the same place.
bool isSame(const Diagnostic& a, const Diagnostic& b);

}  // namespace analogon
