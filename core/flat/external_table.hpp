#pragma once

#include <map>
#include <vector>

#include "core/base/outcome.hpp"
#include "core/flat/cubic_slopes.hpp"
#include "core/flat/external_functions.hpp"
#include "core/flat/table_file.hpp"

namespace analogon {

/// As the enumerations Modelica.Blocks.Types.Extrapolation and TimeEvents count.
enum class TableExtrapolation { Hold = 1, LastTwoPoints, Periodic, None };
enum class TimeEvents { Always = 1, AtDiscontinuities, Never };

/// Entries of a matrix that are expressions of parameters, row-major from 0; no abscissas, and none of a surface that
/// is interpolated by Akima's method.
struct OpenEntries {
    ExpressionPool* pool{};
    std::map<std::size_t, ExpressionId> entries;
};

/// y(x) of a table with its abscissas in the first column; `columns` count from 1.
Outcome<ExternalTable> oneDimensional(const Matrix& table, const std::vector<int>& columns, Smoothness smoothness,
                                      TableExtrapolation extrapolation, const OpenEntries& open = {});
Outcome<ExternalTable> twoDimensional(const Matrix& table, Smoothness smoothness, TableExtrapolation extrapolation,
                                      const OpenEntries& open = {});
Outcome<ExternalTable> timeTable(const Matrix& table, const std::vector<int>& columns, Smoothness smoothness,
                                 TableExtrapolation extrapolation, double start, double shift, TimeEvents events,
                                 const OpenEntries& open = {});

}  // namespace analogon
