#include "core/flat/unit_check.hpp"

#include <fmt/format.h>

#include <cmath>

namespace analogon {
namespace {

constexpr std::uint32_t none = 0xffffffffu;

bool differ(const Dimension& a, const Dimension& b) {
    for (std::size_t i = 0; i < a.size(); ++i)
        if (std::fabs(a[i] - b[i]) > 1e-9) return true;
    return false;
}

/// 2, 1/2, 3/4: a pure number; 9.81 or 0.78 may well carry a unit.
bool isPlainNumber(double value) {
    const double twelfths = value * 12;
    return std::fabs(value) <= 1000 && twelfths == std::round(twelfths);
}

const Dimension seconds{0, 0, 1, 0, 0, 0, 0};

}  // namespace

UnitCheck::Unit UnitCheck::ofVariable(VariableId id) {
    const FlatVariable& variable = work_.variable(id);
    if (variable.type != FlatType::Real || variable.unit.empty()) return {};
    return dimensionOf(variable.unit);
}

std::string UnitCheck::name(ExpressionId id) const {
    constexpr std::size_t most = 60;
    std::string text = work_.pool.print(id, [this](VariableId v) { return work_.variable(v).name; });
    return text.size() > most ? text.substr(0, most) + "…" : text;
}

/// As it was written where it is a variable's own, else in base units.
std::string UnitCheck::unitText(ExpressionId id) const {
    const ExpressionNode& node = work_.pool[id];
    if (node.operation == Operation::Variable) return work_.variable(node.variable).unit;
    return text(*units_[id.value]);
}

void UnitCheck::blame(std::uint32_t node, Text message) {
    if (fault_[node] != none) return;
    fault_[node] = node;
    message_.emplace(node, std::move(message));
}

UnitCheck::Unit UnitCheck::agreed(std::uint32_t node, ExpressionId a, ExpressionId b, const char* what) {
    const Unit &x = units_[a.value], &y = units_[b.value];
    if (x && y && differ(*x, *y))
        blame(node, phrase("{} of different units: '{}' is in {}, '{}' in {}", Text(what, {}, what), name(a),
                           unitText(a), name(b), unitText(b)));
    return x ? x : y;
}

void UnitCheck::plain(std::uint32_t node, ExpressionId argument, const char* function) {
    const Unit& unit = units_[argument.value];
    if (unit && differ(*unit, {}))
        blame(node,
              phrase("{} of a quantity with a unit: '{}' is in {}", function, name(argument), unitText(argument)));
}

UnitCheck::Unit UnitCheck::product(ExpressionId a, ExpressionId b, double sign) const {
    const auto factor = [this](ExpressionId id) -> Unit {
        const ExpressionNode& node = work_.pool[id];
        if (node.operation == Operation::Constant && isPlainNumber(node.value)) return Dimension{};
        return units_[id.value];
    };
    const Unit x = factor(a), y = factor(b);
    if (!x || !y) return {};
    Dimension result = *x;
    for (std::size_t i = 0; i < result.size(); ++i) result[i] += sign * (*y)[i];
    return result;
}

/// Empirical laws raise quantities to powers such as 0.78: their constants take up the unit.
UnitCheck::Unit UnitCheck::power(ExpressionId base, ExpressionId exponent) const {
    const Unit& unit = units_[base.value];
    if (!unit) return {};
    if (!differ(*unit, {})) return unit;
    const ExpressionNode& node = work_.pool[exponent];
    if (node.operation != Operation::Constant || node.value * 2 != std::round(node.value * 2)) return {};
    Dimension result = *unit;
    for (double& p : result) p *= node.value;
    return result;
}

UnitCheck::Unit UnitCheck::unitOf(std::uint32_t index) {
    const ExpressionNode node = work_.pool[ExpressionId{index}];
    switch (node.operation) {
        case Operation::Variable:
            return ofVariable(node.variable);
        case Operation::Derivative: {
            Unit unit = ofVariable(node.variable);
            if (unit) (*unit)[2] -= 1;
            return unit;
        }
        case Operation::Time:
            return seconds;
        case Operation::Negate:
        case Operation::Abs:
        case Operation::NoEvent:
        case Operation::Smooth:
        case Operation::Delay:
            return units_[node.a.value];
        case Operation::Add:
            return agreed(index, node.a, node.b, "a sum");
        case Operation::Subtract:
            return agreed(index, node.a, node.b, "a difference");
        case Operation::Min:
            return agreed(index, node.a, node.b, "a minimum");
        case Operation::Max:
            return agreed(index, node.a, node.b, "a maximum");
        case Operation::If:
            return agreed(index, node.b, node.c, "branches");
        case Operation::Less:
        case Operation::LessEqual:
        case Operation::Greater:
        case Operation::GreaterEqual:
        case Operation::Equal:
        case Operation::NotEqual:
            agreed(index, node.a, node.b, "a comparison");
            return {};
        case Operation::Atan2:
            agreed(index, node.a, node.b, "atan2");
            return Dimension{};
        case Operation::Multiply:
            return product(node.a, node.b, 1);
        case Operation::Divide:
            return product(node.a, node.b, -1);
        case Operation::Power:
            return power(node.a, node.b);
        case Operation::Sqrt: {
            Unit unit = units_[node.a.value];
            if (unit)
                for (double& p : *unit) p /= 2;
            return unit;
        }
        case Operation::Sign:
            return Dimension{};
        case Operation::Exp:
            plain(index, node.a, "exp");
            return Dimension{};
        case Operation::Log:
            plain(index, node.a, "log");
            return Dimension{};
        case Operation::Log10:
            plain(index, node.a, "log10");
            return Dimension{};
        case Operation::Sin:
            plain(index, node.a, "sin");
            return Dimension{};
        case Operation::Cos:
            plain(index, node.a, "cos");
            return Dimension{};
        case Operation::Tan:
            plain(index, node.a, "tan");
            return Dimension{};
        case Operation::Tanh:
            plain(index, node.a, "tanh");
            return Dimension{};
        default:
            return {};
    }
}

void UnitCheck::judge(std::uint32_t index) {
    const ExpressionNode& node = work_.pool[ExpressionId{index}];
    for (const ExpressionId child : {node.a, node.b, node.c})
        if (child.valid() && fault_[index] == none) fault_[index] = fault_[child.value];
    units_[index] = unitOf(index);
}

void UnitCheck::report(ExpressionId left, ExpressionId right, const Span& span) {
    const Text hint = phrase("check the equation, or the units of what stands in it");
    for (const ExpressionId side : {left, right})
        if (const std::uint32_t at = fault_[side.value]; at != none) {
            work_.messages.warning(message_.at(at), span, hint);
            return;
        }
    const Unit &x = units_[left.value], &y = units_[right.value];
    if (!x || !y || !differ(*x, *y)) return;
    work_.messages.warning(phrase("the units of both sides differ: '{}' is in {}, '{}' in {}", name(left),
                                  unitText(left), name(right), unitText(right)),
                           span, hint);
}

/// Children come before their parents in the pool: one pass judges every node once.
void UnitCheck::check() {
    const auto count = static_cast<std::uint32_t>(work_.pool.size());
    units_.resize(count);
    fault_.assign(count, none);
    for (std::uint32_t i = 0; i < count; ++i) judge(i);
    for (const auto* equations : {&work_.model.equations, &work_.model.initialEquations})
        for (const FlatEquation& equation : *equations) {
            if (work_.messages.full()) return;
            if (!equation.fromConnection) report(equation.left, equation.right, equation.span);
        }
    for (std::uint32_t i = 0; i < work_.model.variables.size() && !work_.messages.full(); ++i) {
        const FlatVariable& variable = work_.model.variables[i];
        if (!variable.binding.valid() || !variable.value.valid()) continue;
        const Unit own = ofVariable({i}), &given = units_[variable.binding.value];
        if (!own || !given || !differ(*own, *given)) continue;
        work_.messages.warning(phrase("'{}' is in {}, its value '{}' in {}", variable.name, variable.unit,
                                      name(variable.binding), unitText(variable.binding)),
                               variable.value, phrase("check the value, or the unit of one of them"));
    }
}

}  // namespace analogon
