#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/base/unit.hpp"
#include "core/effect/catalogue/finding.hpp"
#include "core/study/study.hpp"

namespace analogon {

/// From the unit of a time column to seconds; as it stands where the unit is wrong: readTime says so.
UnitConversion secondsOf(const Column& time);

/// The rows of a recording that are used: [first, last), those within its range; the times of the others are not looked
/// at. All where it has none. The table must have its time column.
std::pair<std::size_t, std::size_t> usedRows(const Table& table, const StudyExperiment& experiment);

/// The columns that the model uses in an experiment: its time and what is mapped.
std::set<std::size_t> mappedColumns(const Table& table, const StudyExperiment& experiment);

/// The same, and those with whose first values it begins.
std::set<std::size_t> usedColumns(const Table& table, const StudyExperiment& experiment);

/// Rows first … last-1 of these columns alone.
Table cutTo(const Table& table, std::size_t first, std::size_t last, const std::set<std::size_t>& columns);

/// What the recordings of a study hold of its outputs, as long as no model says anything of them: times within the
/// range that is used [s], and measured values in the unit of the file (NaN: not measured); nothing is simulated.
/// Recordings and columns that cannot be read are left out; estimationTask tells why.
std::vector<ExperimentState> measuredExperiments(const Study& study);

}  // namespace analogon
