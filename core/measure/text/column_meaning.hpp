#pragma once

#include "core/base/outcome.hpp"
#include "core/measure/recording.hpp"
#include "core/measure/text/row_reader.hpp"

/// What columns say about each other, and what words stand for.
namespace analogon {

/// A column of units beside one of numbers ("mV", "V"): the numbers are converted to the largest of them, row by row.
Diagnostics applyUnitColumns(RawTable& raw);

/// "Unit", "CH1 Unit", "Einheit": a column of units.
bool namesUnits(const std::string& name);

/// Words that stand for on and off become 1 and 0; by column, what 0 and 1 are called. Empty: no such column.
std::vector<std::vector<StatusText>> readSwitches(RawTable& raw);

/// Whether a column holds nothing but 0 and 1.
bool isSwitch(const Column& column);

}  // namespace analogon
