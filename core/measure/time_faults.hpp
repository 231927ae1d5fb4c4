#pragma once

#include <optional>
#include <vector>

#include "core/base/diagnostic.hpp"
#include "core/measure/table.hpp"

namespace analogon {

/// What is wrong with the stamps of a recording; empty: they rise from row to row. One fault: how many repeat or go
/// back, the first three of them, what that may mean, and for each meaning what to do. Private to readTime.
std::optional<Diagnostic> timeFault(const Table& table, const Column& column, const std::vector<double>& seconds);

}  // namespace analogon
