#include <algorithm>

#include "core/structure/index_reduction.hpp"

namespace analogon {
namespace {

constexpr std::size_t mostNamed = 6;

Text listOf(const std::vector<Text>& items, const char* separator) {
    Text text;
    for (std::size_t i = 0; i < std::min(items.size(), mostNamed); ++i) {
        if (i > 0) text += separator;
        text += items[i];
    }
    if (items.size() > mostNamed) text += separator + phrase("and {} more", items.size() - mostNamed);
    return text;
}

}  // namespace

Diagnostic singularSystem(const EquationSystem& system, const std::vector<Equation>& allEquations,
                          const std::vector<int>& surplusEquations, const std::vector<int>& undeterminedUnknowns,
                          const std::vector<Equation>& redundant) {
    std::vector<Text> equations, unknowns, repeated;
    Span place;
    for (const int e : surplusEquations) {
        const Equation& equation = allEquations[static_cast<std::size_t>(e)];
        equations.push_back(system.textOf(equation));
        if (!place.valid()) place = equation.span;
    }
    for (const Equation& equation : redundant) {
        repeated.push_back(system.textOf(equation));
        if (!place.valid()) place = equation.span;
    }
    for (const int u : undeterminedUnknowns) {
        unknowns.push_back(system.nameOf(u));
        if (!place.valid()) place = system.unknowns[static_cast<std::size_t>(u)].declared;
    }
    Text message = phrase("The model is singular.");
    if (!unknowns.empty()) message += phrase(" No equation determines {}.", listOf(unknowns, ", "));
    if (!equations.empty())
        message += phrase(" These equations have too few unknowns of their own: {}.", listOf(equations, "; "));
    if (equations.empty() && !repeated.empty())
        message += phrase(" These equations repeat what others say: {}.", listOf(repeated, "; "));
    return error(
        message, place,
        phrase("Look for a part that nothing holds (an open circuit, a loop without a fixed point), or for two "
               "sources that impose the same quantity."));
}

}  // namespace analogon
