#include "core/structure/delay.hpp"

#include <functional>
#include <unordered_map>
#include <utility>

#include "core/structure/rewrite.hpp"

namespace analogon {
namespace {

class DelayRewriting {
public:
    explicit DelayRewriting(Structure& structure) : structure_(structure), pool_(*structure.pool) {
        for (const SolutionBlock& block : structure.blocks)
            if (block.isExplicit) definition_.emplace(block.unknowns.front().value, block.expressions.front());
    }

    /// What stands for the delayed signal; the node itself when it is none of inputs alone.
    ExpressionId replacement(ExpressionId delay) {
        const ExpressionNode node = pool_[delay];
        const ExpressionId source = sourceOf(node.a);
        if (!source.valid()) return delay;
        return pool_.substitute(source, [&](const ExpressionNode& leaf) -> ExpressionId {
            if (leaf.operation == Operation::Time) return pool_.subtract(pool_.time(), node.b);
            if (leaf.operation == Operation::Delay) return pool_.delay(leaf.a, pool_.add(leaf.b, node.b));
            if (leaf.operation == Operation::Variable && isInput(leaf.variable))
                return pool_.delay(pool_.variable(leaf.variable), node.b);
            return {};
        });
    }

private:
    bool isInput(VariableId id) const { return (*structure_.model)[id].causality == FlatCausality::Input; }

    /// The signal over inputs, delayed inputs, time and parameters; invalid when it needs anything else.
    ExpressionId sourceOf(ExpressionId signal) {
        bool isPossible = true;
        const ExpressionId source = pool_.substitute(signal, [&](const ExpressionNode& leaf) -> ExpressionId {
            if (!isPossible) return {};
            if (leaf.operation == Operation::Time) return {};
            if (leaf.operation == Operation::Delay) {
                const ExpressionId outer = pool_.delay(leaf.a, leaf.b), inner = replacement(outer);
                isPossible = isPossible && (inner != outer || isDelayedInput(inner));
                return inner;
            }
            if (leaf.operation == Operation::Derivative) return isPossible = false, ExpressionId{};
            if ((*structure_.model)[leaf.variable].variability != FlatVariability::Continuous || isInput(leaf.variable))
                return {};
            const ExpressionId followed = follow(pool_.variable(leaf.variable));
            isPossible = followed.valid();
            return followed;
        });
        return isPossible ? source : ExpressionId{};
    }

    /// An unknown through its explicit block; invalid for states and unknowns of loops.
    ExpressionId follow(ExpressionId unknown) {
        const auto known = followed_.find(unknown.value);
        if (known != followed_.end()) return known->second;
        followed_[unknown.value] = {};  // what comes back to itself by delays alone is none of inputs
        const auto definition = definition_.find(unknown.value);
        const ExpressionId source = definition == definition_.end() ? ExpressionId{} : sourceOf(definition->second);
        return followed_[unknown.value] = source;
    }

    bool isDelayedInput(ExpressionId id) const {
        const ExpressionNode& node = pool_[id];
        return node.operation == Operation::Delay && pool_[node.a].operation == Operation::Variable &&
               isInput(pool_[node.a].variable);
    }

    Structure& structure_;
    ExpressionPool& pool_;
    std::unordered_map<std::uint32_t, ExpressionId> definition_;  // by node of an unknown
    std::unordered_map<std::uint32_t, ExpressionId> followed_;
};

}  // namespace

std::vector<ExpressionId> delaysOf(const Structure& structure) {
    LeafCollector collect(*structure.pool);
    std::vector<ExpressionId> delays;
    std::vector<char> isListed(structure.pool->size(), 0);
    const auto list = [&](std::span<const ExpressionId> roots) {
        collect.leaves(roots);
        for (const ExpressionId delay : collect.delays())
            if (!std::exchange(isListed[delay.value], 1)) delays.push_back(delay);
    };
    for (const SolutionBlock& block : structure.blocks) list(block.expressions);
    for (const SolutionBlock& block : structure.initialBlocks) list(block.expressions);
    for (std::size_t i = 0; i < delays.size(); ++i) {  // a delayed signal may itself hold a delay
        const ExpressionId signal = (*structure.pool)[delays[i]].a;
        list({&signal, 1});
    }
    return delays;
}

void delayInputsInstead(Structure& structure) {
    const std::vector<ExpressionId> delays = delaysOf(structure);
    if (delays.empty()) return;
    DelayRewriting rewriting(structure);
    std::unordered_map<std::uint32_t, ExpressionId> replaced;
    for (const ExpressionId delay : delays) replaced.emplace(delay.value, rewriting.replacement(delay));
    ExpressionPool& pool = *structure.pool;
    const auto rewrite = [&](std::vector<ExpressionId>& expressions) {
        for (ExpressionId& expression : expressions)
            expression = pool.substitute(expression, [&](const ExpressionNode& leaf) -> ExpressionId {
                if (leaf.operation != Operation::Delay) return {};
                const auto at = replaced.find(pool.delay(leaf.a, leaf.b).value);
                return at == replaced.end() ? ExpressionId{} : at->second;
            });
    };
    for (auto* blocks : {&structure.blocks, &structure.initialBlocks})
        for (SolutionBlock& block : *blocks) {
            rewrite(block.expressions);
            rewrite(block.jacobian);
            rewrite(block.constantTerm);
        }
}

}  // namespace analogon
