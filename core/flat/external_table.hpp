#pragma once

#include <string>
#include <vector>

#include "core/base/outcome.hpp"
#include "core/flat/external_functions.hpp"
#include "core/flat/table_file.hpp"

namespace analogon {

/// As the enumerations Modelica.Blocks.Types.Smoothness, Extrapolation and TimeEvents count.
enum class Smoothness { Linear = 1, Akima, Constant, FritschButland, Steffen, ModifiedAkima };
enum class TableExtrapolation { Hold = 1, LastTwoPoints, Periodic, None };
enum class TimeEvents { Always = 1, AtDiscontinuities, Never };

/// Slopes of cubic pieces at the nodes: Akima (J. ACM 17 (1970) 589-602); the modified Akima weights of MATLAB's
/// makima; Fritsch & Butland (SIAM J. Sci. Stat. Comput. 5 (1984) 300-304); Steffen (Astron. Astrophys. 239 (1990)
/// 443-450). x strictly increasing.
std::vector<double> cubicSlopes(const std::vector<double>& x, const std::vector<double>& y, Smoothness smoothness);

/// y(x) of a table with its abscissas in the first column; `columns` count from 1.
Outcome<ExternalTable> oneDimensional(const Matrix& table, const std::vector<int>& columns, Smoothness smoothness,
                                      TableExtrapolation extrapolation);
Outcome<ExternalTable> twoDimensional(const Matrix& table, Smoothness smoothness, TableExtrapolation extrapolation);
Outcome<ExternalTable> timeTable(const Matrix& table, const std::vector<int>& columns, Smoothness smoothness,
                                 TableExtrapolation extrapolation, double start, double shift, TimeEvents events);

}  // namespace analogon
