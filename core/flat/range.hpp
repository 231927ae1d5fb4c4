#pragma once

#include "core/flat/flat_model.hpp"

namespace analogon {

/// Whether a value lies between the min and the max of a declaration, but for its last digits.
bool isWithinRange(const FlatVariable& variable, double value);

/// The parameters whose values lie outside the min and max of their declarations, each as a fault where its value
/// stands (section 4.8.1 of the Modelica specification: the range shall hold).
Diagnostics outsideRange(const FlatModel& model);

}  // namespace analogon
