#pragma once

#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/outcome.hpp"
#include "core/syntax/ast.hpp"

namespace analogon {

/// A signal that a formula uses. Values: one per time stamp of the formula.
struct FormulaOperand {
    std::string unit;  // empty: not known, agrees with every other
    std::span<const double> values;
};

struct DerivedValues {
    std::string unit;  // coherent, of the SI; empty: not known
    std::vector<double> values;
};

/// A signal worked out from others: a Modelica expression of their names, `motor.v*motor.i`, with numbers, + - * / ^,
/// abs, sqrt, exp, log, log10, sin, cos, tan, min, max, and over the time der (central differences) and integral
/// (trapezoids). A name that is no word of Modelica stands in single quotes: 'T Wasser'.
///
/// Operands are taken in coherent units of the SI (degC as K, rpm as rad/s): the unit of the result follows from them.
class Formula {
public:
    /// Faults: no expression; a function or an operator that has no place here.
    static Outcome<Formula> parse(const std::string& text);

    /// The signals it uses, each once, in the order of the text.
    const std::vector<std::string>& names() const { return names_; }

    /// Faults: an operand that is not given; a unit that is not known; units that do not agree (both are named).
    Outcome<DerivedValues> evaluate(const std::vector<double>& time,
                                    const std::map<std::string, FormulaOperand>& operands) const;

private:
    Formula() = default;
    SourcePtr source_;  // which the places in the expression point into
    syntax::Expression expression_;
    std::vector<std::string> names_;
};

/// The values of a signal at other times, on straight lines between its samples; NaN before the first and after the
/// last. Both times rise.
std::vector<double> valuesAt(std::span<const double> time, std::span<const double> values,
                             std::span<const double> wanted);

}  // namespace analogon
