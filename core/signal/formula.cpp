#include "core/signal/formula.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

#include "core/base/unit.hpp"
#include "core/syntax/parser.hpp"

namespace analogon {

namespace {

using syntax::Expression;
using Kind = Expression::Kind;

constexpr auto missing = std::numeric_limits<double>::quiet_NaN();

/// As the model and the recordings call it: without the quotes of a quoted identifier, with the subscripts.
std::string nameOf(const syntax::Name& name) {
    std::string text;
    for (const syntax::NamePart& part : name.parts) {
        if (!text.empty()) text += '.';
        const std::string& word = part.identifier;
        const bool isQuoted = word.size() > 1 && word.front() == '\'';
        text += isQuoted ? word.substr(1, word.size() - 2) : word;
        std::string subscripts;
        for (const Expression& subscript : part.subscripts)
            subscripts += (subscripts.empty() ? "" : ",") + std::to_string(static_cast<long>(subscript.number));
        if (!subscripts.empty()) text += '[' + subscripts + ']';
    }
    return text;
}

using Function = double (*)(double);
/// Of a pure number to a pure number.
const std::map<std::string, Function>& plainFunctions() {
    static const std::map<std::string, Function> functions{
        {"exp", std::exp}, {"log", std::log}, {"log10", std::log10},
        {"sin", std::sin}, {"cos", std::cos}, {"tan", std::tan},
    };
    return functions;
}

/// How many arguments a function has; 0: there is none of this name.
std::size_t argumentsOf(const std::string& function) {
    if (function == "min" || function == "max") return 2;
    static const std::array<std::string, 4> single{"abs", "sqrt", "der", "integral"};
    return plainFunctions().contains(function) || std::find(single.begin(), single.end(), function) != single.end() ? 1
                                                                                                                    : 0;
}

Diagnostic notHere(const Expression& e) {
    return error(
        phrase("a formula of signals cannot hold this"), e.span,
        phrase("use names of signals, numbers, + - * / ^, abs, sqrt, exp, log, log10, sin, cos, tan, min, max, "
               "der and integral"));
}

/// Collects the names; a fault where something has no place in a formula.
void examine(const Expression& e, std::vector<std::string>& names, Diagnostics& faults) {
    static const std::string operators = "+ - * / ^ .+ .- .* ./ .^";
    const auto isOperator = [&](const std::string& text) {
        return (" " + operators + " ").find(" " + text + " ") != std::string::npos;
    };
    bool isGood = e.kind == Kind::Number || e.kind == Kind::Reference || (e.kind == Kind::Unary && e.text != "not") ||
                  (e.kind == Kind::Binary && isOperator(e.text));
    if (e.kind == Kind::Call)
        isGood = e.named.empty() && argumentsOf(e.name.text()) == e.operands.size() && !e.operands.empty();
    if (!isGood) return faults.push_back(notHere(e));
    if (e.kind == Kind::Reference) {
        for (const syntax::NamePart& part : e.name.parts)
            for (const Expression& subscript : part.subscripts)
                if (subscript.kind != Kind::Number || !subscript.isInteger) faults.push_back(notHere(subscript));
        const std::string name = nameOf(e.name);
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    for (const Expression& operand : e.operands) examine(operand, names, faults);
}

/// A unit of its own name for a dimension, where there is one that people read.
std::string unitText(const Dimension& dimension) {
    for (const char* named : {"W", "N", "Pa", "J", "V", "Ohm", "C", "F", "H", "Wb"})
        if (dimensionOf(named) == dimension) return named;
    return text(dimension);
}

/// A part of the formula: a number, or a value for each time stamp.
struct Part {
    std::vector<double> values;
    std::optional<Dimension> unit;  // empty: agrees with every other
    bool isNumber{};                // that stands in the formula
};

class Evaluation {
public:
    Evaluation(const std::vector<double>& time, const std::map<std::string, FormulaOperand>& operands)
        : time_(time), operands_(operands) {}

    Part of(const Expression& e) {
        switch (e.kind) {
            case Kind::Number:
                return {std::vector<double>(time_.size(), e.number), std::nullopt, true};
            case Kind::Reference:
                return reference(e);
            case Kind::Unary: {
                Part part = of(e.operands[0]);
                if (e.text.back() == '-')
                    for (double& v : part.values) v = -v;
                return part;
            }
            case Kind::Binary:
                return binary(e);
            default:
                return call(e);
        }
    }

    Diagnostics faults;

private:
    Part reference(const Expression& e) {
        const std::string name = nameOf(e.name);
        const auto found = operands_.find(name);
        Part part{std::vector<double>(time_.size(), missing), std::nullopt};
        if (found == operands_.end() || found->second.values.size() != time_.size()) {
            faults.push_back(error(phrase("there is no signal {}", name), e.span));
            return part;
        }
        const FormulaOperand& operand = found->second;
        part.values.assign(operand.values.begin(), operand.values.end());
        if (operand.unit.empty()) return part;
        part.unit = dimensionOf(operand.unit);
        const Outcome<UnitConversion> coherent =
            part.unit ? convertUnit(operand.unit, text(*part.unit)) : Outcome<UnitConversion>(Diagnostic{});
        if (!coherent) {
            faults.push_back(error(phrase("the unit {} of {} is not known", operand.unit, name), e.span));
            return part;
        }
        for (double& v : part.values) v = (*coherent)(v);
        return part;
    }

    void agree(const Expression& e, Part& a, const Part& b) {
        if (a.unit && b.unit && *a.unit != *b.unit)
            faults.push_back(
                error(phrase("the units {} and {} do not agree", unitText(*a.unit), unitText(*b.unit)), e.span));
        if (!a.unit) a.unit = b.unit;
        a.isNumber = a.isNumber && b.isNumber;
    }

    static void combine(Part& a, const Part& b, const std::function<double(double, double)>& f) {
        std::transform(a.values.begin(), a.values.end(), b.values.begin(), a.values.begin(), f);
    }

    Part binary(const Expression& e) {
        Part a = of(e.operands[0]), b = of(e.operands[1]);
        const char operation = e.text.back();
        if (operation == '+' || operation == '-') {
            agree(e, a, b);
            if (operation == '+')
                combine(a, b, std::plus<>());
            else
                combine(a, b, std::minus<>());
        } else if (operation == '^') {
            power(e, a, b);
        } else {
            const double sign = operation == '*' ? 1 : -1;
            a.unit = product(a, b, sign);
            a.isNumber = a.isNumber && b.isNumber;
            if (sign > 0)
                combine(a, b, std::multiplies<>());
            else
                combine(a, b, std::divides<>());
        }
        return a;
    }

    /// A number has no unit; of a signal without one nothing is known, and so nothing of the product.
    static std::optional<Dimension> product(const Part& a, const Part& b, double sign) {
        if ((!a.unit && !a.isNumber) || (!b.unit && !b.isNumber) || (!a.unit && !b.unit)) return std::nullopt;
        Dimension result = a.unit.value_or(Dimension{});
        if (b.unit)
            for (std::size_t i = 0; i < result.size(); ++i) result[i] += sign * (*b.unit)[i];
        return result;
    }

    void power(const Expression& e, Part& base, const Part& exponent) {
        plain(e.operands[1], exponent);
        if (base.unit && *base.unit != Dimension{}) {
            if (!exponent.isNumber)
                faults.push_back(error(phrase("the power of a quantity with a unit must be a number"), e.span));
            else if (!exponent.values.empty())
                for (double& d : *base.unit) d *= exponent.values.front();
        }
        base.isNumber = base.isNumber && exponent.isNumber;
        combine(base, exponent, [](double a, double b) { return std::pow(a, b); });
    }

    void plain(const Expression& e, const Part& part) {
        if (part.unit && *part.unit != Dimension{})
            faults.push_back(error(phrase("a pure number is needed, this is in {}", unitText(*part.unit)), e.span));
    }

    Part call(const Expression& e) {
        const std::string function = e.name.text();
        Part a = of(e.operands[0]);
        if (e.operands.size() == 2) {
            const Part b = of(e.operands[1]);
            agree(e, a, b);
            combine(a, b, [isMin = function == "min"](double x, double y) {
                if (std::isnan(x) || std::isnan(y)) return missing;
                return isMin ? std::min(x, y) : std::max(x, y);
            });
        } else if (function == "der" || function == "integral") {
            overTime(a, function == "der");
        } else if (function == "abs") {
            for (double& v : a.values) v = std::abs(v);
        } else if (function == "sqrt") {
            for (double& v : a.values) v = std::sqrt(v);
            if (a.unit)
                for (double& d : *a.unit) d /= 2;
        } else {
            plain(e.operands[0], a);
            const Function f = plainFunctions().at(function);
            for (double& v : a.values) v = f(v);
        }
        return a;
    }

    void overTime(Part& part, bool isDerivative) {
        constexpr std::size_t seconds = 2;  // in Dimension
        if (part.isNumber) part.unit = Dimension{};
        part.isNumber = false;
        if (part.unit) (*part.unit)[seconds] += isDerivative ? -1 : 1;
        const std::vector<double> values = part.values;
        double sum = 0;
        for (std::size_t i = 0; i < values.size(); ++i) {
            const std::size_t before = i > 0 ? i - 1 : 0, behind = std::min(i + 1, values.size() - 1);
            if (isDerivative) {
                part.values[i] =
                    behind > before ? (values[behind] - values[before]) / (time_[behind] - time_[before]) : missing;
                continue;
            }
            const double area = (values[i] + values[before]) / 2 * (time_[i] - time_[before]);
            if (std::isfinite(area)) sum += area;  // over a gap nothing is known: the sum waits
            part.values[i] = std::isfinite(values[i]) ? sum : missing;
        }
    }

    const std::vector<double>& time_;
    const std::map<std::string, FormulaOperand>& operands_;
};

}  // namespace

Outcome<Formula> Formula::parse(const std::string& text) {
    const SourcePtr source = std::make_shared<Source>("formula", text);
    Outcome<Expression> expression = syntax::parseExpression(source);
    if (!expression) return expression.diagnostics();
    Formula formula;
    formula.source_ = source;
    Diagnostics faults;
    examine(*expression, formula.names_, faults);
    if (!faults.empty()) return faults;
    formula.expression_ = std::move(*expression);
    return formula;
}

Outcome<DerivedValues> Formula::evaluate(const std::vector<double>& time,
                                         const std::map<std::string, FormulaOperand>& operands) const {
    Evaluation evaluation(time, operands);
    Part part = evaluation.of(expression_);
    if (!evaluation.faults.empty()) return evaluation.faults;
    return DerivedValues{part.unit ? unitText(*part.unit) : std::string(), std::move(part.values)};
}

std::vector<double> valuesAt(std::span<const double> time, std::span<const double> values,
                             std::span<const double> wanted) {
    std::vector<double> result(wanted.size(), missing);
    const std::size_t size = std::min(time.size(), values.size());
    std::size_t next = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        while (next < size && time[next] < wanted[i]) ++next;
        if (next == size) break;
        if (time[next] == wanted[i])
            result[i] = values[next];
        else if (next > 0)
            result[i] = values[next - 1] + (wanted[i] - time[next - 1]) / (time[next] - time[next - 1]) *
                                               (values[next] - values[next - 1]);
    }
    return result;
}

}  // namespace analogon
