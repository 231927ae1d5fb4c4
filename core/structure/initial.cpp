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
        : reduced_(reduced),
          system_(reduced.system),
          pool_(*system_.pool),
          warnings_(warnings),
          collect_(pool_),
          columns_(static_cast<int>(system_.unknowns.size())),
          matching_(incidence_, columns_) {}

    Outcome<std::vector<SolutionBlock>> run();

private:
    void enter(const Equation& equation);
    Equation startEquation(const Unknown& unknown) const;
    void enterModel();
    bool tryToHold(const Equation& equation);
    bool isSolved(int unknown) const { return reduced_.isSolvedAtStart[static_cast<std::size_t>(unknown)]; }
    void holdInitialEquations();
    void holdFixedStarts();
    std::vector<char> namedInInitialEquations();
    void holdOtherStarts();
    std::vector<SolutionBlock> needed(std::vector<SolutionBlock> blocks);

    ReducedSystem& reduced_;
    EquationSystem& system_;
    ExpressionPool& pool_;
    Diagnostics& warnings_;
    LeafCollector collect_;
    std::vector<Equation> equations_;
    Adjacency incidence_;
    int columns_;
    Matching matching_;
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

/// The model's own equations, matched with what they are solved for anyway; states are left free.
void InitialConditions::enterModel() {
    for (const Equation& equation : reduced_.startEquations) enter(equation);
    matching_.resize(columns_);
    std::vector<char> isUsable(reduced_.isState.size());
    for (std::size_t u = 0; u < isUsable.size(); ++u) isUsable[u] = !reduced_.isState[u];
    matching_.augmentAll(isUsable);
    matching_.augmentAll();  // constraints between states
}

/// Adds a condition unless those before it already decide all its unknowns.
bool InitialConditions::tryToHold(const Equation& equation) {
    enter(equation);
    matching_.resize(columns_);
    if (matching_.augment(static_cast<int>(equations_.size()) - 1)) return true;
    equations_.pop_back();
    incidence_.pop_back();
    matching_.resize(columns_);
    return false;
}

void InitialConditions::holdInitialEquations() {
    for (const Equation& equation : system_.initialEquations)
        if (equation.left != equation.right && !tryToHold(equation))
            warnings_.push_back(warning(phrase("The initial equation {} is not used: the start is decided without it.",
                                               system_.textOf(equation)),
                                        equation.span,
                                        phrase("Remove it, or free one of the other start conditions.")));
}

void InitialConditions::holdFixedStarts() {
    std::vector<int> fixed;
    for (int u = 0; u < columns_; ++u)
        if (system_.unknowns[static_cast<std::size_t>(u)].isFixed) fixed.push_back(u);
    std::stable_sort(fixed.begin(), fixed.end(), [this](int a, int b) { return isSolved(a) < isSolved(b); });
    for (const int u : fixed)
        if (const Unknown& unknown = system_.unknowns[static_cast<std::size_t>(u)]; !tryToHold(startEquation(unknown)))
            warnings_.push_back(warning(
                phrase("The fixed start value of '{}' is not used: the start is decided without it.",
                       system_.nameOf(unknown.node)),
                unknown.declared, phrase("Remove fixed = true here, or free one of the other start conditions.")));
}

/// States that an initial equation names: it is meant to decide these, and a start value of theirs is a guess.
std::vector<char> InitialConditions::namedInInitialEquations() {
    std::vector<char> isNamed(system_.unknowns.size(), 0);
    for (const Equation& equation : system_.initialEquations) {
        const ExpressionId sides[] = {equation.left, equation.right};
        for (const ExpressionId leaf : collect_.leaves(sides))
            if (const int u = system_.unknownOf(leaf); u >= 0) isNamed[static_cast<std::size_t>(u)] = 1;
    }
    return isNamed;
}

/// Start values of as many further states as are still free, given ones first.
void InitialConditions::holdOtherStarts() {
    const std::vector<char> isNamed = namedInInitialEquations();
    std::vector<int> others;
    for (int u = 0; u < columns_; ++u)
        if (reduced_.isState[static_cast<std::size_t>(u)] && !system_.unknowns[static_cast<std::size_t>(u)].isFixed)
            others.push_back(u);
    std::stable_sort(others.begin(), others.end(), [&](int a, int b) {
        if (isSolved(a) != isSolved(b)) return isSolved(a) < isSolved(b);
        const auto x = static_cast<std::size_t>(a), y = static_cast<std::size_t>(b);
        if (isNamed[x] != isNamed[y]) return isNamed[x] < isNamed[y];
        return system_.unknowns[x].start.valid() > system_.unknowns[y].start.valid();
    });
    std::string assumed;
    for (const int u : others) {
        const Unknown& unknown = system_.unknowns[static_cast<std::size_t>(u)];
        if (tryToHold(startEquation(unknown)) && !unknown.start.valid())
            assumed += (assumed.empty() ? "" : ", ") + system_.nameOf(unknown.node);
    }
    if (assumed.empty()) return;
    Diagnostic note = warning(phrase("No start value is given for {}; 0 is taken.", assumed));
    note.severity = Severity::Note;
    warnings_.push_back(std::move(note));
}

Outcome<std::vector<SolutionBlock>> InitialConditions::run() {
    enterModel();
    holdInitialEquations();
    holdFixedStarts();
    holdOtherStarts();
    const std::vector<char> isKnown(system_.unknowns.size(), 0);
    Outcome<std::vector<SolutionBlock>> blocks = orderSolution(system_, equations_, isKnown);
    if (!blocks) {
        Diagnostics faults = blocks.diagnostics();
        for (Diagnostic& fault : faults) fault.message = phrase("At the initial time: {}", fault.message);
        return faults;
    }
    return needed(std::move(*blocks));
}

}  // namespace

Outcome<std::vector<SolutionBlock>> orderInitialisation(ReducedSystem& reduced, Diagnostics& warnings) {
    return InitialConditions(reduced, warnings).run();
}

}  // namespace analogon
