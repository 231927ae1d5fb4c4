#pragma once

#include <string>

#include "core/measure/mat/mat_check.hpp"

namespace analogon::mat {

/// Level 7.3 is HDF5: whether that library can open it, and which variables are objects.
Check checkLevel73(const std::string& file);

}  // namespace analogon::mat
