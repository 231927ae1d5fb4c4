#include "core/structure/index_reduction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/stop.hpp"
#include "core/flat/dependent_nodes.hpp"
#include "core/structure/cancellation.hpp"
#include "core/structure/hidden_constraint.hpp"
#include "core/structure/independence.hpp"
#include "core/structure/rewrite.hpp"

namespace analogon {

Adjacency incidenceOf(const EquationSystem& system) {
    LeafCollector collect(*system.pool);
    Adjacency incidence(system.equations.size());
    for (std::size_t e = 0; e < incidence.size(); ++e) {
        const ExpressionId sides[] = {system.equations[e].left, system.equations[e].right};
        for (const ExpressionId leaf : collect.leaves(sides))
            if (const int u = system.unknownOf(leaf); u >= 0) incidence[e].push_back(u);
    }
    return incidence;
}

namespace {

class IndexReduction {
public:
    IndexReduction(EquationSystem system, const std::vector<Equation>& redundant)
        : system_(std::move(system)), redundant_(redundant), collect_(*system_.pool) {
        revealConstraints(system_);
        combineCancellingDerivatives(system_);
        incidence_ = incidenceOf(system_);
    }

    Outcome<ReducedSystem> run();

private:
    bool isStructurallySound();
    bool pantelides();
    bool differentiate(int equation);
    int derivativeOfUnknown(int unknown);
    ExpressionId derivativeOfLeaf(const ExpressionNode& node);
    int chainTop(int unknown) const;
    void chooseStates();
    struct Level {
        std::vector<int> constraints;  // equations
        std::vector<int> candidates;   // unknowns, the least wanted states first
        Adjacency rows;                // by candidate: positions in `constraints`
    };
    Level levelOf(std::vector<int> constraints, const std::vector<char>& isOffered);
    std::vector<char> dummiesOf(const Level& level);
    bool isSafelySolvedFor(int constraint, const std::vector<char>& isDummy);
    std::vector<char> solvedTogether(const std::vector<int>& constraints, std::vector<char> isDummy);
    bool hasConstantSlope(int constraint, int unknown);
    void stabilise(std::vector<Equation>& equations, std::vector<char>& isLeftOut);
    ExpressionId slopeOf(int constraint, ExpressionId unknown);
    double wishToBeState(int unknown, const std::vector<int>& constraints);

    EquationSystem system_;
    const std::vector<Equation>& redundant_;
    LeafCollector collect_;
    std::map<std::uint32_t, DependentNodes> dependent_;             // by residual of a constraint
    std::map<std::pair<int, std::uint32_t>, ExpressionId> slopes_;  // by constraint and unknown
    Adjacency incidence_;
    std::vector<int> derivativeEquation_, integralEquation_;  // by equation; -1: none
    std::vector<char> isHighest_;                             // by unknown: it has no derivative
    std::vector<char> isState_, isSolvedAtStart_;             // by unknown
    std::vector<int> stabilised_;                             // constraints, of the order below the highest
    int differentiated_{};
    Diagnostics faults_;
};

/// The highest derivative of an unknown; -1 when that is known (a constant, an input).
int IndexReduction::chainTop(int unknown) const {
    for (std::size_t steps = 0; steps <= system_.unknowns.size(); ++steps) {
        const Unknown& u = system_.unknowns[static_cast<std::size_t>(unknown)];
        if (!u.derivative.valid()) return unknown;
        if (u.derivativeUnknown < 0) return -1;
        unknown = u.derivativeUnknown;
    }
    return unknown;
}

/// Whether equations and unknowns pair up when a variable and its derivatives count as one: without that no
/// differentiation helps.
bool IndexReduction::isStructurallySound() {
    Adjacency collapsed(incidence_.size());
    for (std::size_t e = 0; e < incidence_.size(); ++e)
        for (const int u : incidence_[e])
            if (const int top = chainTop(u); top >= 0) collapsed[e].push_back(top);
    const int columns = static_cast<int>(system_.unknowns.size());
    Matching matching(collapsed, columns);
    std::vector<int> surplus, undetermined;
    if (!matching.augmentAll()) {
        for (int e = 0; e < static_cast<int>(collapsed.size()) && surplus.empty(); ++e)
            if (matching.columnOf(e) < 0 && !matching.augment(e)) surplus = matching.visitedRows();
        std::sort(surplus.begin(), surplus.end());
    }
    for (int u = 0; u < columns; ++u)
        if (chainTop(u) == u && matching.rowOf(u) < 0) undetermined.push_back(u);
    if (surplus.empty() && undetermined.empty()) return true;
    faults_.push_back(singularSystem(system_, system_.equations, surplus, undetermined, redundant_));
    return false;
}

/// The unknown that is the derivative of `unknown`, made when there is none; -1 when the derivative is known.
int IndexReduction::derivativeOfUnknown(int unknown) {
    const auto i = static_cast<std::size_t>(unknown);
    if (system_.unknowns[i].derivative.valid()) return system_.unknowns[i].derivativeUnknown;
    ExpressionPool& pool = *system_.pool;
    const ExpressionNode node = pool[system_.unknowns[i].node];
    Unknown made;
    made.isSynthetic = true;
    made.declared = system_.unknowns[i].declared;
    if (node.operation == Operation::Variable) {
        made.node = pool.derivativeOf(node.variable);
    } else {
        // der(x) has no name of its own to differentiate: it gets one.
        FlatVariable variable;
        variable.name = fmt::format("der({})", system_.nameOf(unknown));
        variable.isProtected = true;
        const VariableId id{static_cast<std::uint32_t>(system_.model->variables.size())};
        system_.model->byName.emplace(variable.name, id);
        system_.model->variables.push_back(std::move(variable));
        made.node = pool.variable(id);
    }
    const ExpressionId derivative = made.node;
    const int index = system_.addUnknown(std::move(made));
    system_.unknowns[i].derivative = derivative;
    system_.unknowns[i].derivativeUnknown = index;
    isHighest_[i] = 0;
    isHighest_.push_back(1);
    return index;
}

ExpressionId IndexReduction::derivativeOfLeaf(const ExpressionNode& node) {
    ExpressionPool& pool = *system_.pool;
    const FlatVariable& variable = (*system_.model)[node.variable];
    if (variable.variability != FlatVariability::Continuous) return pool.constant(0);
    const ExpressionId self =
        node.operation == Operation::Variable ? pool.variable(node.variable) : pool.derivativeOf(node.variable);
    if (const int u = system_.unknownOf(self); u >= 0) {
        derivativeOfUnknown(u);
        return system_.unknowns[static_cast<std::size_t>(u)].derivative;
    }
    if (node.operation == Operation::Variable) return pool.derivativeOf(node.variable);  // an input
    faults_.push_back(error(phrase("The model needs the second derivative of the input '{}'.", variable.name),
                            variable.declared, noSecondDerivative()));
    return pool.constant(0);
}

/// Adds the time derivative of an equation.
bool IndexReduction::differentiate(int equation) {
    const Equation original = system_.equations[static_cast<std::size_t>(equation)];
    constexpr int highestOrder = 4;
    const ExpressionId sides[] = {original.left, original.right};
    collect_.leaves(sides);
    const bool isDelayed = !collect_.delays().empty();
    if (original.order >= highestOrder || isDelayed) {
        const Text text = system_.textOf(original);
        faults_.push_back(error(
            !isDelayed
                ? phrase("The equation {} would have to be differentiated too often; the equations constrain "
                         "each other in a circle.",
                         text)
                : phrase("The equation {} would have to be differentiated although it holds a delayed signal.", text),
            original.span));
        return false;
    }
    const auto leaf = [this](const ExpressionNode& node) { return derivativeOfLeaf(node); };
    Equation derived = original;
    derived.left = system_.pool->timeDerivative(original.left, leaf);
    derived.right = system_.pool->timeDerivative(original.right, leaf);
    ++derived.order;
    const ExpressionId derivedSides[] = {derived.left, derived.right};
    std::vector<int> unknowns;
    for (const ExpressionId node : collect_.leaves(derivedSides))
        if (const int u = system_.unknownOf(node); u >= 0) unknowns.push_back(u);
    derivativeEquation_[static_cast<std::size_t>(equation)] = static_cast<int>(system_.equations.size());
    derivativeEquation_.push_back(-1);
    integralEquation_.push_back(equation);
    system_.equations.push_back(std::move(derived));
    incidence_.push_back(std::move(unknowns));
    ++differentiated_;
    return faults_.empty();
}

/// Matches every equation with a highest derivative, differentiating where that is impossible.
bool IndexReduction::pantelides() {
    const std::size_t originals = system_.equations.size();
    derivativeEquation_.assign(originals, -1);
    integralEquation_.assign(originals, -1);
    isHighest_.clear();
    for (const Unknown& u : system_.unknowns) isHighest_.push_back(!u.derivative.valid());
    Matching matching(incidence_, static_cast<int>(system_.unknowns.size()));
    // Everything that needs no differentiation first: the alternating trees below then stay small.
    matching.augmentAll(isHighest_);
    for (std::size_t original = 0; original < originals; ++original) {
        if (matching.columnOf(static_cast<int>(original)) >= 0) continue;
        int equation = static_cast<int>(original);
        while (!matching.augment(equation, isHighest_)) {
            const std::vector<int> rows = matching.visitedRows(), columns = matching.visitedColumns();
            for (const int column : columns) derivativeOfUnknown(column);
            for (const int row : rows)
                if (derivativeEquation_[static_cast<std::size_t>(row)] < 0 && !differentiate(row)) return false;
            matching.resize(static_cast<int>(system_.unknowns.size()));
            for (const int column : columns)
                matching.assign(derivativeEquation_[static_cast<std::size_t>(matching.rowOf(column))],
                                derivativeOfUnknown(column));
            equation = derivativeEquation_[static_cast<std::size_t>(equation)];
        }
    }
    return true;
}

/// The slope of a constraint along an unknown.
ExpressionId IndexReduction::slopeOf(int constraint, ExpressionId unknown) {
    ExpressionId& slope = slopes_[{constraint, unknown.value}];
    if (slope.valid()) return slope;
    const ExpressionId residual = system_.residual(system_.equations[static_cast<std::size_t>(constraint)]);
    const auto nodes = dependent_.try_emplace(residual.value, *system_.pool, residual).first;
    return slope = system_.pool->differentiate(residual, unknown, nodes->second.of(unknown));
}

/// How much a differentiated unknown should be a state; `constraints` are the equations it may be taken from.
double IndexReduction::wishToBeState(int unknown, const std::vector<int>& constraints) {
    const Unknown& u = system_.unknowns[static_cast<std::size_t>(unknown)];
    double wish = 0;
    switch (u.stateSelect) {
        case StateSelect::Always:
            wish += 4000;
            break;
        case StateSelect::Prefer:
            wish += 2000;
            break;
        case StateSelect::Avoid:
            wish -= 2000;
            break;
        case StateSelect::Never:
            wish -= 4000;
            break;
        case StateSelect::Default:
            break;
    }
    if (u.isFixed) wish += 200;
    if (u.start.valid()) wish += 50;
    if (u.isSynthetic ||
        (u.derivativeUnknown >= 0 && system_.unknowns[static_cast<std::size_t>(u.derivativeUnknown)].isSynthetic))
        wish -= 500;  // nobody integrates it in the model
    for (const int e : constraints) {
        const ExpressionId slope = slopeOf(e, u.node);
        if (system_.pool->isConstant(slope))
            wish -= std::fabs((*system_.pool)[slope].value) == 1 ? 20 : 10;  // easily solved for
        else if (std::fabs(startValueOf(system_, slope)) < 1e-12)
            wish += 1000;  // cannot be solved for where the simulation starts
        else
            wish += 30;  // may be lost where the slope passes through 0
    }
    return wish;
}

bool IndexReduction::hasConstantSlope(int constraint, int unknown) {
    const ExpressionId slope = slopeOf(constraint, system_.unknowns[static_cast<std::size_t>(unknown)].node);
    const auto leaves = collect_.leaves(slope);
    return std::none_of(leaves.begin(), leaves.end(), [&](ExpressionId leaf) { return system_.unknownOf(leaf) >= 0; });
}

/// The dummies without those that follow one after the other, each from a constraint with none that is open but itself
/// and with a constant slope: where they stand elsewhere they are known.
std::vector<char> IndexReduction::solvedTogether(const std::vector<int>& constraints, std::vector<char> isDummy) {
    for (bool isMore = true; isMore;) {
        isMore = false;
        for (const int e : constraints) {
            stopPoint();
            int open = -1, count = 0;
            for (const int u : incidence_[static_cast<std::size_t>(e)])
                if (isDummy[static_cast<std::size_t>(u)]) {
                    open = u;
                    ++count;
                }
            if (count != 1 || !hasConstantSlope(e, open)) continue;
            isDummy[static_cast<std::size_t>(open)] = 0;
            isMore = true;
        }
    }
    return isDummy;
}

/// Whether a choice made at the start holds for good: the slopes of a constraint along the unknowns that it is solved
/// for are the same in every state. Where the model says itself what should be a state, that is kept.
bool IndexReduction::isSafelySolvedFor(int constraint, const std::vector<char>& isDummy) {
    const std::vector<int>& unknowns = incidence_[static_cast<std::size_t>(constraint)];
    for (const int u : unknowns)
        if (system_.unknowns[static_cast<std::size_t>(u)].stateSelect != StateSelect::Default) return true;
    return std::all_of(unknowns.begin(), unknowns.end(),
                       [&](int u) { return !isDummy[static_cast<std::size_t>(u)] || hasConstantSlope(constraint, u); });
}

/// Constraints of one order, and the differentiated unknowns that may be solved from them.
IndexReduction::Level IndexReduction::levelOf(std::vector<int> constraints, const std::vector<char>& isOffered) {
    Level level;
    level.constraints = std::move(constraints);
    std::map<int, std::vector<int>> positions;
    for (std::size_t i = 0; i < level.constraints.size(); ++i)
        for (const int u : incidence_[static_cast<std::size_t>(level.constraints[i])])
            if (isOffered[static_cast<std::size_t>(u)]) positions[u].push_back(static_cast<int>(i));
    std::map<int, double> wish;
    for (const auto& [u, rows] : positions) {
        std::vector<int> equations;
        for (const int i : rows) equations.push_back(level.constraints[static_cast<std::size_t>(i)]);
        stopPoint();
        wish[u] = wishToBeState(u, equations);
        level.candidates.push_back(u);
    }
    std::sort(level.candidates.begin(), level.candidates.end(), [&](int a, int b) {
        return wish[a] != wish[b] ? wish[a] < wish[b] : a > b;  // of equals the later one yields
    });
    for (const int u : level.candidates) level.rows.push_back(std::move(positions[u]));
    return level;
}

/// The least wanted states that can pay for all constraints: whose slopes are independent, or where constraints depend
/// on each other by their numbers, that stand in them (greedy over a matroid in both cases).
std::vector<char> IndexReduction::dummiesOf(const Level& level) {
    std::vector<char> isDummy(system_.unknowns.size(), 0);
    const auto yields = [&](std::size_t candidate) {
        isDummy[static_cast<std::size_t>(level.candidates[candidate])] = 1;
    };
    std::vector<SparseColumn> columns(level.candidates.size());
    for (std::size_t i = 0; i < columns.size(); ++i)
        for (const int at : level.rows[i])
            columns[i][at] =
                genericValueOf(system_, slopeOf(level.constraints[static_cast<std::size_t>(at)],
                                                system_.unknowns[static_cast<std::size_t>(level.candidates[i])].node));
    if (const auto chosen = independentColumns(columns, level.constraints.size())) {
        std::for_each(chosen->begin(), chosen->end(), yields);
        return isDummy;
    }
    Matching matching(level.rows, static_cast<int>(level.constraints.size()));
    for (int i = 0; i < static_cast<int>(level.rows.size()); ++i)
        if (matching.augment(i)) yields(static_cast<std::size_t>(i));
    for (std::size_t i = 0; i < level.constraints.size(); ++i) {
        if (matching.rowOf(static_cast<int>(i)) >= 0) continue;
        const Equation& equation = system_.equations[static_cast<std::size_t>(level.constraints[i])];
        faults_.push_back(
            error(phrase("No state can be eliminated by the constraint {}.", system_.textOf(equation)), equation.span));
    }
    return isDummy;
}

/// Dummy derivatives: of every constraint that was differentiated, one differentiated unknown is no state. Where no
/// such choice holds in every state (a pendulum in Cartesian coordinates), all of them stay states and the constraint
/// is held by the equation that replaces its last derivative.
void IndexReduction::chooseStates() {
    const auto count = system_.unknowns.size();
    isState_.assign(count, 0);
    for (std::size_t u = 0; u < count; ++u) isState_[u] = system_.unknowns[u].derivative.valid();
    isSolvedAtStart_.assign(count, 0);
    std::vector<int> constraints;  // those whose derivative is one of the highest equations
    for (std::size_t e = 0; e < derivativeEquation_.size(); ++e) {
        const int derived = derivativeEquation_[e];
        if (derived >= 0 && derivativeEquation_[static_cast<std::size_t>(derived)] < 0)
            constraints.push_back(static_cast<int>(e));
    }
    std::vector<char> isOffered(count, 0);  // its derivative may become a dummy
    for (std::size_t u = 0; u < count; ++u)
        isOffered[u] = system_.unknowns[u].derivative.valid() && system_.unknowns[u].derivativeUnknown >= 0 &&
                       isHighest_[static_cast<std::size_t>(system_.unknowns[u].derivativeUnknown)];
    for (bool isTop = true; !constraints.empty(); isTop = false) {
        std::vector<char> isDummy = dummiesOf(levelOf(constraints, isOffered));
        for (std::size_t u = 0; u < count; ++u) isSolvedAtStart_[u] |= isDummy[u];
        while (isTop) {  // orders below follow: their slopes are the same
            std::vector<int> safe;
            const std::vector<char> isOpen = solvedTogether(constraints, isDummy);
            for (const int e : constraints)
                if (isSafelySolvedFor(e, isOpen))
                    safe.push_back(e);
                else
                    stabilised_.push_back(e);
            if (safe.size() == constraints.size()) break;
            constraints = std::move(safe);
            isDummy = dummiesOf(levelOf(constraints, isOffered));
        }
        for (std::size_t u = 0; u < count; ++u)
            if (isDummy[u]) isState_[u] = 0;
        // One order down: constraints whose derivative was just served, among integrals of the dummies.
        std::vector<int> lower;
        for (const int e : constraints)
            if (const int below = integralEquation_[static_cast<std::size_t>(e)]; below >= 0) lower.push_back(below);
        for (std::size_t u = 0; u < count; ++u) {
            const int derivative = system_.unknowns[u].derivativeUnknown;
            isOffered[u] = derivative >= 0 && isDummy[static_cast<std::size_t>(derivative)];
        }
        constraints = std::move(lower);
    }
}

/// (d/dt + a)^k g = 0 in place of the k-th derivative of a constraint g = 0 (Baumgarte 1972): the same solution, but
/// what rounding and the integration leave of g dies away instead of adding up.
void IndexReduction::stabilise(std::vector<Equation>& equations, std::vector<char>& isLeftOut) {
    constexpr double decay = 10;  // [1/s]
    ExpressionPool& pool = *system_.pool;
    for (const int constraint : stabilised_) {
        int highest = derivativeEquation_[static_cast<std::size_t>(constraint)];
        ExpressionId sum = system_.residual(equations[static_cast<std::size_t>(highest)]);
        std::vector<int> chain;
        for (int e = constraint; e >= 0; e = integralEquation_[static_cast<std::size_t>(e)]) chain.push_back(e);
        double weight = 1;
        const auto order = static_cast<double>(chain.size());
        for (std::size_t i = 0; i < chain.size(); ++i) {
            weight *= decay * (order - static_cast<double>(i)) / static_cast<double>(i + 1);
            const ExpressionId residual = system_.residual(equations[static_cast<std::size_t>(chain[i])]);
            sum = pool.add(sum, pool.multiply(pool.constant(weight), residual));
            isLeftOut[static_cast<std::size_t>(chain[i])] = 1;
        }
        equations[static_cast<std::size_t>(highest)].left = sum;
        equations[static_cast<std::size_t>(highest)].right = pool.constant(0);
    }
}

Outcome<ReducedSystem> IndexReduction::run() {
    if (!isStructurallySound() || !pantelides()) return faults_;
    chooseStates();
    if (!faults_.empty()) return faults_;
    ReducedSystem out;
    out.startEquations = system_.equations;
    std::vector<char> isLeftOut(system_.equations.size(), 0);
    std::vector<Equation> equations = system_.equations;
    stabilise(equations, isLeftOut);
    system_.equations.clear();
    for (std::size_t e = 0; e < equations.size(); ++e)
        if (!isLeftOut[e]) system_.equations.push_back(std::move(equations[e]));
    out.system = std::move(system_);
    out.isState = std::move(isState_);
    out.isSolvedAtStart = std::move(isSolvedAtStart_);
    out.differentiated = differentiated_;
    return out;
}

}  // namespace

Outcome<ReducedSystem> reduceIndex(EquationSystem system, const std::vector<Equation>& redundant) {
    return IndexReduction(std::move(system), redundant).run();
}

}  // namespace analogon
