#pragma once

#include <string>

#include "core/flat/flat_model.hpp"

namespace analogon {

/// Lets a parameter take another value in mid run: p stands for p + p.step * s(t) in every equation, where s rises from
/// 0 to 1 around the time p.moment within `width` [s]. "p.step" and "p.moment" are new parameters of the model (0 and
/// 0: nothing changes). Parameters bound to p follow it. Fault: no such Real parameter.
Outcome<FlatModel> withChange(FlatModel model, const std::string& parameter, double width);

std::string stepOf(const std::string& parameter);
std::string momentOf(const std::string& parameter);

}  // namespace analogon
