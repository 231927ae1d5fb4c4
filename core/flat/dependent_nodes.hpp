#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/flat/expression.hpp"
#include "core/flat/node_map.hpp"

namespace analogon {

/// Which nodes of some expressions depend on a leaf of theirs. The expressions are walked once; each leaf then costs
/// what depends on it, so that all slopes of an equation with many unknowns cost little more than the equation.
/// A delayed signal is given by the past and depends on no leaf.
class DependentNodes {
public:
    DependentNodes(const ExpressionPool& pool, std::span<const ExpressionId> roots);
    DependentNodes(const ExpressionPool& pool, ExpressionId root) : DependentNodes(pool, std::span(&root, 1)) {}

    /// The leaf and what is above it, ascending (children before parents); until the next call. Empty for a leaf that
    /// is not there.
    std::span<const std::uint32_t> of(ExpressionId leaf);

private:
    std::vector<std::uint32_t> nodes_;                  // of the pool, ascending
    NodeMap placeOf_;                                   // of a node in nodes_
    std::vector<std::uint32_t> firstParent_, parents_;  // by place: places of the nodes that it is a part of
    std::vector<std::uint32_t> visitOf_;                // by place: the last leaf that reached it
    std::uint32_t visit_{};
    std::vector<std::uint32_t> found_;
};

}  // namespace analogon
