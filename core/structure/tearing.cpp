#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <unordered_map>

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
    };

    std::optional<ExpressionId> solveFor(const Equation& equation, ExpressionId unknown, bool onlyConstantFactor);
    ExpressionId atZero(ExpressionId residual, const std::vector<ExpressionId>& unknowns);
    void findIncidence();
    bool isSolvable(int equation, int unknown);
    void tear();
    void eliminate(int equation);
    void settle(int unknown);
    int nextTorn() const;
    Outcome<SolutionBlock> remainder();
    Diagnostic noInfluence() const;

    EquationSystem& system_;
    ExpressionPool& pool_;
    const std::vector<Equation>& equations_;
    const std::vector<ExpressionId>& unknowns_;
    DependenceCheck& depends_;
    int count_;
    std::vector<std::vector<int>> unknownsOf_, equationsOf_;
    std::vector<int> openUnknowns_;                    // by equation
    std::vector<char> isSettled_, isUsed_;             // unknown: torn or eliminated; equation: used to eliminate
    std::vector<Step> steps_;
    std::vector<int> torn_;
    std::vector<int> ready_;                           // equations with one open unknown
};

/// unknown := expression, when the equation is linear in it.
std::optional<ExpressionId> ComponentSolver::solveFor(const Equation& equation, ExpressionId unknown,
                                                      bool onlyConstantFactor) {
    const ExpressionId one[] = {unknown};
    depends_.setUnknowns(one);
    const Dependence left = depends_(equation.left), right = depends_(equation.right);
    if (equation.left == unknown && right == Dependence::None) return equation.right;
    if (equation.right == unknown && left == Dependence::None) return equation.left;
    if (left == Dependence::Nonlinear || right == Dependence::Nonlinear) return {};
    const ExpressionId residual = system_.residual(equation);
    const ExpressionId factor = pool_.differentiate(residual, unknown);
    if (pool_.isConstant(factor, 0) || (onlyConstantFactor && !pool_.isConstant(factor))) return {};
    return pool_.negate(pool_.divide(atZero(residual, {unknown}), factor));
}

ExpressionId ComponentSolver::atZero(ExpressionId residual, const std::vector<ExpressionId>& unknowns) {
    const ExpressionId zero = pool_.constant(0);
    return pool_.substitute(residual, [&](const ExpressionNode& node) -> ExpressionId {
        if (node.operation == Operation::Delay) return pool_.delay(node.a, node.b);  // as it is
        for (const ExpressionId unknown : unknowns)
            if (pool_[unknown].operation == node.operation && pool_[unknown].variable == node.variable) return zero;
        return {};
    });
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
}

bool ComponentSolver::isSolvable(int equation, int unknown) {
    return solveFor(equations_[static_cast<std::size_t>(equation)], unknowns_[static_cast<std::size_t>(unknown)], true)
        .has_value();
}

void ComponentSolver::settle(int unknown) {
    isSettled_[static_cast<std::size_t>(unknown)] = 1;
    for (const int e : equationsOf_[static_cast<std::size_t>(unknown)])
        if (--openUnknowns_[static_cast<std::size_t>(e)] == 1 && !isUsed_[static_cast<std::size_t>(e)])
            ready_.push_back(e);
}

/// Uses an equation with one open unknown to eliminate that, if its factor is safe.
void ComponentSolver::eliminate(int equation) {
    const auto e = static_cast<std::size_t>(equation);
    if (isUsed_[e] || openUnknowns_[e] != 1) return;
    for (const int u : unknownsOf_[e]) {
        if (isSettled_[static_cast<std::size_t>(u)]) continue;
        if (!isSolvable(equation, u)) return;
        isUsed_[e] = 1;
        steps_.push_back({equation, u});
        settle(u);
        return;
    }
}

/// The open unknown that meets the most unused equations.
int ComponentSolver::nextTorn() const {
    int best = -1, most = -1;
    for (int u = 0; u < count_; ++u) {
        if (isSettled_[static_cast<std::size_t>(u)]) continue;
        int meets = 0;
        for (const int e : equationsOf_[static_cast<std::size_t>(u)])
            // Equations that would have one open unknown left bring the elimination on at once.
            if (!isUsed_[static_cast<std::size_t>(e)]) meets += openUnknowns_[static_cast<std::size_t>(e)] == 2 ? 3 : 1;
        if (meets > most) best = u, most = meets;
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
        settle(u);
    }
}

Diagnostic ComponentSolver::noInfluence() const {
    std::string names, texts;
    for (const ExpressionId u : unknowns_) names += (names.empty() ? "" : ", ") + system_.nameOf(u);
    for (const Equation& e : equations_) texts += (texts.empty() ? "" : "; ") + system_.textOf(e);
    return error(fmt::format("The equations {} do not determine {}: what they say of it cancels.", texts, names),
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
    for (const Step& step : steps_) {
        const ExpressionId unknown = unknowns_[static_cast<std::size_t>(step.unknown)];
        const auto solved = solveFor(equations_[static_cast<std::size_t>(step.equation)], unknown, true);
        replacement[unknown.value] = rewrite(*solved);
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
    for (const ExpressionId r : block.expressions)
        for (const ExpressionId z : block.unknowns) block.jacobian.push_back(pool_.differentiate(r, z));
    if (!block.isLinear) return block;
    for (const ExpressionId r : block.expressions) block.constantTerm.push_back(atZero(r, block.unknowns));
    if (block.unknowns.size() == 1) {
        if (pool_.isConstant(block.jacobian[0], 0)) return noInfluence();
        block.isExplicit = true;
        block.expressions = {pool_.negate(pool_.divide(block.constantTerm[0], block.jacobian[0]))};
        block.torn.clear();
        block.jacobian.clear();
        block.constantTerm.clear();
    }
    return block;
}

Outcome<std::vector<SolutionBlock>> ComponentSolver::run() {
    std::vector<SolutionBlock> blocks;
    if (count_ == 1) {
        if (const auto solved = solveFor(equations_[0], unknowns_[0], false)) {
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
        block.expressions = {
            *solveFor(equations_[static_cast<std::size_t>(step.equation)], block.unknowns.front(), true)};
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
