#include "core/structure/initial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/structure/rewrite.hpp"

namespace analogon {
namespace {

class InitialConditions {
public:
    InitialConditions(ReducedSystem& reduced, Diagnostics& warnings)
        : reduced_(reduced), system_(reduced.system), pool_(*system_.pool), warnings_(warnings), collect_(pool_) {}

    Outcome<std::vector<SolutionBlock>> run();

private:
    void enter(const Equation& equation);
    Equation startEquation(const Unknown& unknown) const;
    std::vector<SolutionBlock> needed(std::vector<SolutionBlock> blocks);

    ReducedSystem& reduced_;
    EquationSystem& system_;
    ExpressionPool& pool_;
    Diagnostics& warnings_;
    LeafCollector collect_;
    std::vector<Equation> equations_;
    Adjacency incidence_;
};

void InitialConditions::enter(const Equation& equation) {
    equations_.push_back(equation);
    std::vector<int>& row = incidence_.emplace_back();
    const ExpressionId sides[] = {equation.left, equation.right};
    for (const ExpressionId leaf : collect_.leaves(sides))
        if (const int u = system_.unknownOf(leaf); u >= 0) row.push_back(u);
}

Equation InitialConditions::startEquation(const Unknown& unknown) const {
    const ExpressionId start = unknown.start.valid() ? unknown.start : pool_.constant(0);
    return {unknown.node, start, unknown.declared, "", 0};
}

/// Only the blocks from which the states follow.
std::vector<SolutionBlock> InitialConditions::needed(std::vector<SolutionBlock> blocks) {
    std::vector<char> isNeeded(system_.unknowns.size(), 0);
    for (std::size_t u = 0; u < isNeeded.size(); ++u) isNeeded[u] = reduced_.isState[u];
    std::vector<SolutionBlock> kept;
    for (auto block = blocks.rbegin(); block != blocks.rend(); ++block) {
        const bool any = std::any_of(block->unknowns.begin(), block->unknowns.end(), [&](ExpressionId node) {
            return isNeeded[static_cast<std::size_t>(system_.unknownOf(node))];
        });
        if (!any) continue;
        for (const ExpressionId leaf : collect_.leaves(block->expressions))
            if (const int u = system_.unknownOf(leaf); u >= 0) isNeeded[static_cast<std::size_t>(u)] = 1;
        kept.push_back(std::move(*block));
    }
    std::reverse(kept.begin(), kept.end());
    return kept;
}

Outcome<std::vector<SolutionBlock>> InitialConditions::run() {
    const int columns = static_cast<int>(system_.unknowns.size());
    incidence_.reserve(system_.equations.size() + system_.unknowns.size());
    for (const Equation& equation : system_.equations) enter(equation);
    Matching matching(incidence_, columns);
    // States last: the model's equations should be matched with what they are solved for anyway.
    std::vector<char> isUsable(reduced_.isState.size());
    for (std::size_t u = 0; u < isUsable.size(); ++u) isUsable[u] = !reduced_.isState[u];
    matching.augmentAll(isUsable);

    const auto tryToHold = [&](const Equation& equation) {
        enter(equation);
        matching.resize(columns);
        if (matching.augment(static_cast<int>(equations_.size()) - 1)) return true;
        equations_.pop_back();
        incidence_.pop_back();
        matching.resize(columns);
        return false;
    };
    for (const Equation& equation : system_.initialEquations)
        if (equation.left != equation.right && !tryToHold(equation))
            warnings_.push_back(warning(
                fmt::format("The initial equation {} is not used: the start is decided without it.",
                            system_.textOf(equation)),
                equation.span, "Remove it, or free one of the other start conditions."));
    for (const Unknown& unknown : system_.unknowns)
        if (unknown.isFixed && !tryToHold(startEquation(unknown)))
            warnings_.push_back(warning(
                fmt::format("The fixed start value of '{}' is not used: the start is decided without it.",
                            system_.nameOf(unknown.node)),
                unknown.declared, "Remove fixed = true here, or free one of the other start conditions."));

    std::vector<int> others;
    for (int u = 0; u < columns; ++u)
        if (reduced_.isState[static_cast<std::size_t>(u)] && !system_.unknowns[static_cast<std::size_t>(u)].isFixed)
            others.push_back(u);
    std::stable_sort(others.begin(), others.end(), [&](int a, int b) {
        return system_.unknowns[static_cast<std::size_t>(a)].start.valid() >
               system_.unknowns[static_cast<std::size_t>(b)].start.valid();
    });
    std::string assumed;
    for (const int u : others) {
        const Unknown& unknown = system_.unknowns[static_cast<std::size_t>(u)];
        if (tryToHold(startEquation(unknown)) && !unknown.start.valid())
            assumed += (assumed.empty() ? "" : ", ") + system_.nameOf(unknown.node);
    }
    if (!assumed.empty()) {
        Diagnostic note = warning(fmt::format("No start value is given for {}; 0 is taken.", assumed));
        note.severity = Severity::Note;
        warnings_.push_back(std::move(note));
    }
    const std::vector<char> isKnown(system_.unknowns.size(), 0);
    Outcome<std::vector<SolutionBlock>> blocks = orderSolution(system_, equations_, isKnown);
    if (!blocks) {
        Diagnostics faults = blocks.diagnostics();
        for (Diagnostic& fault : faults) fault.message = "At the initial time: " + fault.message;
        return faults;
    }
    return needed(std::move(*blocks));
}

}  // namespace

Outcome<std::vector<SolutionBlock>> orderInitialisation(ReducedSystem& reduced, Diagnostics& warnings) {
    return InitialConditions(reduced, warnings).run();
}

}  // namespace analogon
