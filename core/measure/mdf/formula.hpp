#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace analogon::mdf {

/// A formula of one variable, X or X1: + - * / ^ **, brackets, numbers, pi, sin cos tan asin acos atan sinh cosh tanh
/// exp log (natural) log10 sqrt abs pow.
class Formula {
public:
    /// Nothing where it says something else.
    static std::optional<Formula> parse(std::string_view text);
    void evaluate(std::span<double> values) const;

private:
    friend class FormulaParser;
    enum class Operation { Constant, Variable, Add, Subtract, Multiply, Divide, Power, Negate, Function };
    struct Step {
        Operation operation{Operation::Constant};
        double constant{};
        double (*function)(double){};
    };
    std::vector<Step> steps_;  // operands first
    std::size_t depth_{};      // values that wait at most
};

}  // namespace analogon::mdf
