#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>

#include "core/base/guard.hpp"
#include "core/base/limits.hpp"
#include "core/base/stop.hpp"
#include "core/flat/dependent_nodes.hpp"
#include "core/structure/quadratic.hpp"
#include "core/structure/rewrite.hpp"
#include "core/structure/solution_order.hpp"

namespace analogon {
namespace {

/// Solves one strong component. Variables with a constant factor in some equation are eliminated one after the
/// other (Cellier & Kofman 2006, ch. 7: tearing); what is left is a small system in the torn variables.
class ComponentSolver {
public:
    ComponentSolver(EquationSystem& system, DependenceCheck& depends, const std::vector<Equation>& equations,
                    const std::vector<ExpressionId>& unknowns)
        : system_(system),
          pool_(*system.pool),
          equations_(equations),
          unknowns_(unknowns),
          depends_(depends),
          count_(static_cast<int>(unknowns.size())) {}

    Outcome<std::vector<SolutionBlock>> run();

private:
    struct Step {
        int equation, unknown;
        ExpressionId solved{};  // for the unknown, known when the remainder is made
    };

    enum class Safety : char { None, Constant, Unit };
    struct Entry {
        double factor{};
        Safety safety{Safety::None};
    };

    std::optional<ExpressionId> solveFor(const Equation& equation, ExpressionId unknown);
    ExpressionId quotient(ExpressionId a, ExpressionId b, ExpressionId factor);
    Safety safetyOf(int equation, int unknown);
    double constantFactor(const Equation& equation, ExpressionId unknown, DependentNodes& nodes);
    std::vector<ExpressionId> atZero(std::span<const ExpressionId> residuals, std::span<const ExpressionId> unknowns);
    void findIncidence();
    void tear();
    void eliminate(int equation);
    double growthOf(int equation, int unknown) const;
    void settle(int unknown);
    int nextTorn();
    Outcome<SolutionBlock> remainder();
    Diagnostic noInfluence() const;
    Diagnostic tooLarge(std::size_t limit) const;

    static constexpr double mostGrowth = 1e6;  // of rounding: nine digits of sixteen are left
    EquationSystem& system_;
    ExpressionPool& pool_;
    const std::vector<Equation>& equations_;
    const std::vector<ExpressionId>& unknowns_;
    DependenceCheck& depends_;
    int count_;
    std::vector<std::vector<int>> unknownsOf_, equationsOf_;
    std::vector<std::vector<Entry>> entries_;  // by equation, beside unknownsOf_; empty: not looked at yet
    std::vector<int> openUnknowns_;            // by equation
    std::vector<char> isSettled_, isUsed_;     // unknown: torn or eliminated; equation: used to eliminate
    std::vector<Step> steps_;
    std::vector<int> torn_;
    std::vector<int> ready_;      // equations with one open unknown
    std::vector<double> growth_;  // by settled unknown: how far the rounding of torn ones comes through to it
};

/// unknown := expression, when the equation is linear in it.
std::optional<ExpressionId> ComponentSolver::solveFor(const Equation& equation, ExpressionId unknown) {
    const ExpressionId one[] = {unknown};
    depends_.setUnknowns(one);
    const Dependence left = depends_(equation.left), right = depends_(equation.right);
    if (equation.left == unknown && right == Dependence::None) return equation.right;
    if (equation.right == unknown && left == Dependence::None) return equation.left;
    if (left == Dependence::Nonlinear || right == Dependence::Nonlinear) return {};
    const ExpressionId factor =
        pool_.subtract(pool_.differentiate(equation.left, unknown), pool_.differentiate(equation.right, unknown));
    if (pool_.isConstant(factor, 0)) return {};
    const ExpressionId sides[] = {equation.right, equation.left};
    const std::vector<ExpressionId> rest = atZero(sides, one);
    return quotient(rest[0], rest[1], factor);
}

/// (a - b)/factor, without a sign in front where there need not be one.
ExpressionId ComponentSolver::quotient(ExpressionId a, ExpressionId b, ExpressionId factor) {
    const ExpressionNode node = pool_[factor];
    if (node.operation == Operation::Negate || (node.operation == Operation::Constant && node.value < 0))
        return pool_.divide(pool_.subtract(b, a), pool_.negate(factor));
    return pool_.divide(pool_.subtract(a, b), factor);
}

/// How safely an equation can be solved for an unknown: only constant factors cannot vanish, and one that is
/// small beside the others would lose digits (the threshold of partial pivoting).
ComponentSolver::Safety ComponentSolver::safetyOf(int equation, int unknown) {
    std::vector<Entry>& row = entries_[static_cast<std::size_t>(equation)];
    const std::vector<int>& columns = unknownsOf_[static_cast<std::size_t>(equation)];
    if (row.empty()) {
        row.resize(columns.size());
        const Equation& of = equations_[static_cast<std::size_t>(equation)];
        const ExpressionId sides[] = {of.left, of.right};
        DependentNodes dependent(pool_, sides);
        double largest = 0;
        for (std::size_t i = 0; i < columns.size(); ++i) {
            row[i].factor = constantFactor(of, unknowns_[static_cast<std::size_t>(columns[i])], dependent);
            largest = std::max(largest, std::fabs(row[i].factor));
        }
        for (Entry& entry : row) {
            const double size = std::fabs(entry.factor);
            if (size == 1)
                entry.safety = Safety::Unit;
            else if (size > 0 && size >= 0.1 * largest)
                entry.safety = Safety::Constant;
        }
    }
    const auto at = std::find(columns.begin(), columns.end(), unknown);
    return row[static_cast<std::size_t>(at - columns.begin())].safety;
}

/// The factor of an unknown in an equation that is linear in it with a constant factor; else 0.
double ComponentSolver::constantFactor(const Equation& equation, ExpressionId unknown, DependentNodes& nodes) {
    const std::span<const std::uint32_t> dependent = nodes.of(unknown);
    depends_.setUnknown(unknown, dependent);
    if (std::max(depends_(equation.left), depends_(equation.right)) == Dependence::Nonlinear) return 0;
    const ExpressionId factor = pool_.subtract(pool_.differentiate(equation.left, unknown, dependent),
                                               pool_.differentiate(equation.right, unknown, dependent));
    return pool_.isConstant(factor) ? pool_[factor].value : 0;
}

/// The expressions where the unknowns are 0.
std::vector<ExpressionId> ComponentSolver::atZero(std::span<const ExpressionId> residuals,
                                                  std::span<const ExpressionId> unknowns) {
    NodeMap isUnknown;
    for (const ExpressionId unknown : unknowns) isUnknown.insert(unknown.value, 0);
    const ExpressionId zero = pool_.constant(0);
    Rewriter rewrite(
        pool_, [&](ExpressionId leaf) { return isUnknown.find(leaf.value) ? zero : ExpressionId{}; },
        Rewriter::Delays::Keep);
    std::vector<ExpressionId> values;
    for (const ExpressionId residual : residuals) values.push_back(rewrite(residual));
    return values;
}

void ComponentSolver::findIncidence() {
    LeafCollector collect(pool_);
    std::vector<std::pair<std::uint32_t, int>> places;
    for (int u = 0; u < count_; ++u) places.emplace_back(unknowns_[static_cast<std::size_t>(u)].value, u);
    std::sort(places.begin(), places.end());
    unknownsOf_.resize(equations_.size());
    equationsOf_.resize(equations_.size());
    for (std::size_t e = 0; e < equations_.size(); ++e) {
        const ExpressionId sides[] = {equations_[e].left, equations_[e].right};
        for (const ExpressionId leaf : collect.leaves(sides)) {
            const auto at = std::lower_bound(places.begin(), places.end(), std::pair(leaf.value, 0));
            if (at == places.end() || at->first != leaf.value) continue;
            unknownsOf_[e].push_back(at->second);
            equationsOf_[static_cast<std::size_t>(at->second)].push_back(static_cast<int>(e));
        }
        openUnknowns_.push_back(static_cast<int>(unknownsOf_[e].size()));
    }
    isSettled_.assign(equations_.size(), 0);
    isUsed_.assign(equations_.size(), 0);
    growth_.assign(equations_.size(), 1);
    entries_.resize(equations_.size());
}

void ComponentSolver::settle(int unknown) {
    isSettled_[static_cast<std::size_t>(unknown)] = 1;
    for (const int e : equationsOf_[static_cast<std::size_t>(unknown)])
        if (--openUnknowns_[static_cast<std::size_t>(e)] == 1 && !isUsed_[static_cast<std::size_t>(e)])
            ready_.push_back(e);
}

/// The sum of what the others bring, with the magnitudes of their factors; one that is not constant counts as 1.
double ComponentSolver::growthOf(int equation, int unknown) const {
    const auto e = static_cast<std::size_t>(equation);
    double sum = 0, own = 1;
    for (std::size_t i = 0; i < unknownsOf_[e].size(); ++i) {
        const double size = std::fabs(entries_[e][i].factor);
        if (unknownsOf_[e][i] == unknown)
            own = size;
        else
            sum += (size > 0 ? size : 1) * growth_[static_cast<std::size_t>(unknownsOf_[e][i])];
    }
    return sum / own;
}

/// Uses an equation with one open unknown to eliminate that, if its factor is safe, and rounding does not grow too far
/// on the way: from node to node of a large net every step multiplies it, and the torn unknowns at the end of many are
/// found from differences of large numbers (as with shooting: Ascher, Mattheij & Russell 1995, section 4.2).
void ComponentSolver::eliminate(int equation) {
    const auto e = static_cast<std::size_t>(equation);
    if (isUsed_[e] || openUnknowns_[e] != 1) return;
    for (const int u : unknownsOf_[e]) {
        if (isSettled_[static_cast<std::size_t>(u)]) continue;
        if (safetyOf(equation, u) == Safety::None) return;
        const double growth = growthOf(equation, u);
        if (growth > mostGrowth) return;
        growth_[static_cast<std::size_t>(u)] = growth;
        isUsed_[e] = 1;
        steps_.push_back({equation, u, {}});
        settle(u);
        return;
    }
}

/// The open unknown that brings the elimination on most: equations that it leaves with one open unknown, all
/// the more when they are easily solved for that.
int ComponentSolver::nextTorn() {
    stopPoint();
    int best = -1, most = -1;
    for (int u = 0; u < count_; ++u) {
        if (isSettled_[static_cast<std::size_t>(u)]) continue;
        int gain = 0;
        for (const int e : equationsOf_[static_cast<std::size_t>(u)]) {
            if (isUsed_[static_cast<std::size_t>(e)]) continue;
            gain += 1;
            if (openUnknowns_[static_cast<std::size_t>(e)] != 2) continue;
            for (const int other : unknownsOf_[static_cast<std::size_t>(e)])
                if (other != u && !isSettled_[static_cast<std::size_t>(other)])
                    gain += 2 * static_cast<int>(safetyOf(e, other));
        }
        if (gain > most) best = u, most = gain;
    }
    return best;
}

void ComponentSolver::tear() {
    for (int e = 0; e < count_; ++e)
        if (openUnknowns_[static_cast<std::size_t>(e)] == 1) ready_.push_back(e);
    for (;;) {
        for (std::size_t i = 0; i < ready_.size(); ++i) eliminate(ready_[i]);
        ready_.clear();
        const int u = nextTorn();
        if (u < 0) break;
        torn_.push_back(u);
        if (torn_.size() > limits::loopUnknowns) throw LimitReached(tooLarge(limits::loopUnknowns));
        settle(u);
    }
}

/// One that would have to be solved at once, with too many unknowns.
Diagnostic ComponentSolver::tooLarge(std::size_t limit) const {
    return error(phrase("{} equations for {}, {} and {} more must be solved at once, in more than {} unknowns", count_,
                        system_.nameOf(unknowns_[0]), system_.nameOf(unknowns_[1]), count_ - 2, limit),
                 equations_.front().span,
                 phrase("Break the loop: let some of its quantities follow with a small inertia, capacity or lag, or "
                        "model fewer parts."));
}

Diagnostic ComponentSolver::noInfluence() const {
    std::string names;
    for (const ExpressionId u : unknowns_) names += (names.empty() ? "" : ", ") + system_.nameOf(u);
    Text texts;
    for (const Equation& e : equations_) {
        if (!texts.empty()) texts += "; ";
        texts += system_.textOf(e);
    }
    return error(phrase("The equations {} do not determine {}: what they say of it cancels.", texts, names),
                 equations_.front().span);
}

/// The residuals in the torn variables alone.
Outcome<SolutionBlock> ComponentSolver::remainder() {
    std::unordered_map<std::uint32_t, ExpressionId> replacement;  // by node of an eliminated unknown
    Rewriter rewrite(
        pool_,
        [&](ExpressionId node) {
            const auto at = replacement.find(node.value);
            return at == replacement.end() ? ExpressionId{} : at->second;
        },
        Rewriter::Delays::Keep);
    for (Step& step : steps_) {
        const ExpressionId unknown = unknowns_[static_cast<std::size_t>(step.unknown)];
        step.solved = *solveFor(equations_[static_cast<std::size_t>(step.equation)], unknown);
        replacement[unknown.value] = rewrite(step.solved);
    }
    SolutionBlock block;
    block.isExplicit = false;
    for (const int u : torn_) block.unknowns.push_back(unknowns_[static_cast<std::size_t>(u)]);
    for (int e = 0; e < count_; ++e)
        if (!isUsed_[static_cast<std::size_t>(e)])
            block.expressions.push_back(rewrite(system_.residual(equations_[static_cast<std::size_t>(e)])));
    block.torn = unknowns_;
    depends_.setUnknowns(block.unknowns);
    Dependence most = Dependence::None;
    for (const ExpressionId r : block.expressions) most = std::max(most, depends_(r));
    if (most == Dependence::None) return noInfluence();
    block.isLinear = most == Dependence::Linear;
    if (!block.isLinear && block.unknowns.size() == 1) {
        if (const auto solved = quadraticSolution(system_, depends_, block.expressions[0], block.unknowns[0])) {
            block.isExplicit = true;
            block.expressions = {*solved};
            block.torn.clear();
            return block;
        }
    }
    if (!block.isLinear && block.unknowns.size() > limits::nonlinearUnknowns)
        throw LimitReached(tooLarge(limits::nonlinearUnknowns));
    for (const ExpressionId r : block.expressions) {
        DependentNodes dependent(pool_, r);
        for (const ExpressionId z : block.unknowns)
            block.jacobian.push_back(pool_.differentiate(r, z, dependent.of(z)));
    }
    if (!block.isLinear) return block;
    block.constantTerm = atZero(block.expressions, block.unknowns);
    if (block.unknowns.size() == 1) {
        if (pool_.isConstant(block.jacobian[0], 0)) return noInfluence();
        block.isExplicit = true;
        block.expressions = {quotient(pool_.constant(0), block.constantTerm[0], block.jacobian[0])};
        block.torn.clear();
        block.jacobian.clear();
        block.constantTerm.clear();
    }
    return block;
}

Outcome<std::vector<SolutionBlock>> ComponentSolver::run() {
    std::vector<SolutionBlock> blocks;
    if (count_ == 1) {
        if (const auto solved = solveFor(equations_[0], unknowns_[0])) {
            SolutionBlock block;
            block.unknowns = unknowns_;
            block.expressions = {*solved};
            blocks.push_back(std::move(block));
            return blocks;
        }
    }
    findIncidence();
    tear();
    Outcome<SolutionBlock> rest = remainder();
    if (!rest) return rest.diagnostics();
    blocks.push_back(std::move(*rest));
    for (const Step& step : steps_) {
        SolutionBlock block;
        block.unknowns = {unknowns_[static_cast<std::size_t>(step.unknown)]};
        block.expressions = {step.solved};
        blocks.push_back(std::move(block));
    }
    return blocks;
}

}  // namespace

Outcome<std::vector<SolutionBlock>> solveComponent(EquationSystem& system, DependenceCheck& depends,
                                                   const std::vector<Equation>& equations,
                                                   const std::vector<ExpressionId>& unknowns) {
    return ComponentSolver(system, depends, equations, unknowns).run();
}

}  // namespace analogon
