#include <algorithm>
#include <limits>

#include "core/flat/executor.hpp"
#include "core/flat/translator.hpp"

/// A `while` whose condition is known only when the model runs: as many turns as it can take, each under its condition.
namespace analogon {
namespace {

using ExpressionKind = syntax::Expression::Kind;

constexpr int mostTurns = 100;  // where the condition does not bound them

}  // namespace

/// `i < n and …` ends after n turns where i counts from 1; the rest is caught when the model runs.
int Executor::turnsOf(const syntax::Expression& condition, const Scope& scope) {
    if (condition.kind != ExpressionKind::Binary) return mostTurns;
    if (condition.text == "and")
        return std::min(turnsOf(condition.operands[0], scope), turnsOf(condition.operands[1], scope));
    if (condition.text != "<" && condition.text != "<=") return mostTurns;
    const Messages::Quiet quiet(work_.messages);
    const auto limit = work_.translator->translate(condition.operands[1], scope);
    if (!limit || limit->type != FlatType::Integer || !limit->isScalar()) return mostTurns;
    const auto number = work_.translator->knownNow(limit->elements[0]);
    return number && *number >= 1 && *number < 10 * mostTurns ? static_cast<int>(*number) + 1 : mostTurns;
}

Executor::Flow Executor::repeatOpen(const Statement& statement, const Scope& scope) {
    const auto& branch = statement.branches.front();
    ExpressionPool& pool = work_.pool;
    const Memory first = remember();
    hasOpenLoop_ = true;
    const int turns = turnsOf(*branch.condition, scope);
    for (int turn = 0;; ++turn) {
        const auto condition = work_.translator->translate(*branch.condition, scope);
        if (!condition || condition->elements.size() != 1) return Flow::Failed;
        ExpressionId holds = pool.unary(Operation::NoEvent, condition->elements[0]);
        if (broken_.valid()) holds = pool.binary(Operation::And, holds, pool.unary(Operation::Not, broken_));
        if (pool.isConstant(holds, 0)) return Flow::Next;
        if (turn == turns) return join(holds, withoutValue(first), statement.span) ? Flow::Next : Flow::Failed;
        const Memory before = remember();
        guards_.push_back(holds);
        const Flow flow = execute(branch.body, scope);
        if (flow == Flow::Failed) return flow;
        leave(flow);
        guards_.pop_back();
        const Memory after = remember();
        recall(before);
        if (!join(holds, after, statement.span)) return Flow::Failed;
    }
}

/// What the loop has changed has no value where it would go on: nothing wrong is told.
Executor::Memory Executor::withoutValue(const Memory& first) const {
    Memory now = remember();
    const ExpressionId none = work_.pool.constant(std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < now.locals.size() && i < first.locals.size(); ++i) {
        auto& elements = now.locals[i].second.elements;
        const auto& before = first.locals[i].second.elements;
        for (std::size_t k = 0; k < elements.size(); ++k)
            if (k >= before.size() || elements[k] != before[k]) elements[k] = none;
    }
    for (auto& [variable, expression] : now.variables) {
        const auto before = first.variables.find(variable);
        if (before == first.variables.end() || before->second != expression) expression = none;
    }
    return now;
}

}  // namespace analogon
