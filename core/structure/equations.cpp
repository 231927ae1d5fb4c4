#include "core/structure/equations.hpp"

#include <fmt/format.h>

namespace analogon {

int EquationSystem::addUnknown(Unknown unknown) {
    const std::uint32_t node = unknown.node.value;
    if (node >= unknownOfNode.size()) unknownOfNode.resize(std::max<std::size_t>(pool->size(), node + 1), -1);
    unknownOfNode[node] = static_cast<int>(unknowns.size());
    unknowns.push_back(std::move(unknown));
    return unknownOfNode[node];
}

std::string EquationSystem::nameOf(ExpressionId node) const {
    const ExpressionNode& n = (*pool)[node];
    const std::string& name = (*model)[n.variable].name;
    return n.operation == Operation::Derivative ? fmt::format("der({})", name) : name;
}

Text EquationSystem::textOf(const Equation& equation) const {
    const auto name = [this](VariableId id) { return (*model)[id].name; };
    std::string text = fmt::format("{} = {}", pool->print(equation.left, name), pool->print(equation.right, name));
    constexpr std::size_t longest = 160;
    if (text.size() > longest) text = text.substr(0, longest) + " …";
    return equation.component.empty() ? Text(text) : phrase("{} (in {})", text, equation.component);
}

}  // namespace analogon
