#include "core/flat/range.hpp"

#include <algorithm>
#include <cmath>

#include "core/flat/messages.hpp"
#include "core/syntax/printer.hpp"

namespace analogon {

bool isWithinRange(const FlatVariable& variable, double value) {
    // A value that was fitted to a bound may lie beyond it by the last digit.
    const double slack = 1e-9 * std::abs(value);
    return !(variable.min && value < *variable.min - slack) && !(variable.max && value > *variable.max + slack);
}

Diagnostics outsideRange(const FlatModel& model) {
    Messages found;
    for (std::uint32_t i = 0; i < model.variables.size() && !found.full(); ++i) {
        const FlatVariable& variable = model.variables[i];
        if (variable.variability != FlatVariability::Parameter || (!variable.min && !variable.max)) continue;
        const std::optional<double> value = model.parameterValue({i});
        if (!value || isWithinRange(variable, *value)) continue;
        const bool isBelow = variable.min && *value < *variable.min;
        const Text given = Text::number(syntax::printNumber(*value)),
                   bound = Text::number(syntax::printNumber(isBelow ? *variable.min : *variable.max));
        found.error(isBelow ? phrase("the parameter '{}' is {}, below its min {}", variable.name, given, bound)
                            : phrase("the parameter '{}' is {}, above its max {}", variable.name, given, bound),
                    variable.value.valid() ? variable.value : variable.declared,
                    phrase("change the value, or the range where the parameter is declared"));
    }
    return found.diagnostics();
}

}  // namespace analogon
