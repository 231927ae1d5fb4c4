#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/base/unit.hpp"
#include "core/flat/flattening.hpp"

namespace analogon {

/// Whether the units of an equation agree: both sides, the terms of each sum, the arguments of functions. What has no
/// unit agrees with everything, and so does a number that may carry one (273.15, 9.81); only dimensions are compared,
/// an angle counting as 1. What does not agree is a warning that names both units.
class UnitCheck {
public:
    explicit UnitCheck(Flattening& work) : work_(work) {}
    void check();

private:
    using Unit = std::optional<Dimension>;  // empty: agrees with everything

    void judge(std::uint32_t node);
    Unit unitOf(std::uint32_t node);
    Unit agreed(std::uint32_t node, ExpressionId a, ExpressionId b, const char* what);
    void plain(std::uint32_t node, ExpressionId argument, const char* function);
    Unit product(ExpressionId a, ExpressionId b, double sign) const;
    Unit power(ExpressionId base, ExpressionId exponent) const;
    Unit ofVariable(VariableId id);
    std::string name(ExpressionId id) const;
    std::string unitText(ExpressionId id) const;
    void blame(std::uint32_t node, Text message);
    void report(ExpressionId left, ExpressionId right, const Span& span);

    Flattening& work_;
    std::vector<Unit> units_;                          // by node
    std::vector<std::uint32_t> fault_;                 // by node: the node at fault below it; 0xffffffff: none
    std::unordered_map<std::uint32_t, Text> message_;  // by node at fault
};

}  // namespace analogon
