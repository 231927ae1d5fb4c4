#pragma once

#include <functional>
#include <string>

#include "core/base/outcome.hpp"

namespace analogon {

/// The texts of an effect annotation ("0.002*maxabs(w)", "8*sample"): arithmetic over named quantities and
/// functions of one variable. `quantity` gives sample and duration; `statistic` gives range(v), maxabs(v), …
struct ShapeContext {
    std::function<double(const std::string& name)> quantity;                                    // NaN: unknown
    std::function<double(const std::string& function, const std::string& variable)> statistic;  // NaN: unknown
};

Outcome<double> shapeValue(const std::string& text, const ShapeContext& context);

/// Variables that the text mentions inside functions.
std::vector<std::string> shapeVariables(const std::string& text);

}  // namespace analogon
