#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/flat/expression.hpp"
#include "core/flat/node_map.hpp"

/// Walks over the expression graph that the structural analysis needs again and again. All of them treat
/// delay(z, T) as a leaf for incidence: its value is known from the past, so z is no unknown of the equation.
namespace analogon {

/// Rewrites expressions bottom-up through the folding constructors of the pool. Results are remembered, so a
/// graph that many equations share is rewritten once; `leaf` must give the same answer each time it is asked.
class Rewriter {
public:
    /// The callback sees Variable, Derivative and Time nodes; an invalid result keeps the node.
    using Leaf = std::function<ExpressionId(ExpressionId)>;

    /// Whether the signal inside a delay(z, T) is rewritten, or the delay left as it is.
    enum class Delays { Rewrite, Keep };

    Rewriter(ExpressionPool& pool, Leaf leaf, Delays delays = Delays::Rewrite)
        : pool_(pool), leaf_(std::move(leaf)), delays_(delays) {}
    ExpressionId operator()(ExpressionId in);

private:
    ExpressionId rebuild(ExpressionId in);

    ExpressionPool& pool_;
    Leaf leaf_;
    Delays delays_;
    NodeMap done_;
};

/// Collects the distinct Variable and Derivative nodes of an expression (and, on demand, its delays). Throws
/// LimitReached where all that it was asked for holds more than limits::references.
class LeafCollector {
public:
    explicit LeafCollector(const ExpressionPool& pool) : pool_(pool) {}
    /// In order of first visit, left to right.
    const std::vector<ExpressionId>& leaves(std::span<const ExpressionId> roots);
    const std::vector<ExpressionId>& leaves(ExpressionId root) { return leaves({&root, 1}); }
    /// The Delay nodes met by the last call of leaves().
    const std::vector<ExpressionId>& delays() const { return delays_; }

private:
    const ExpressionPool& pool_;
    std::vector<std::uint32_t> seen_;  // by node: the visit that saw it
    std::uint32_t visit_{};
    std::vector<ExpressionId> stack_, leaves_, delays_;
    std::size_t visited_{};  // nodes, by all calls together
};

/// How an expression depends on a set of unknowns.
enum class Dependence : std::uint8_t { None, Linear, Nonlinear };

/// Classifies expressions against a set of unknown nodes. Linear means affine with coefficients free of the
/// unknowns; a condition, relation or function of an unknown is nonlinear.
class DependenceCheck {
public:
    explicit DependenceCheck(const ExpressionPool& pool) : pool_(pool) {}
    /// Asks about these unknowns from now on; costs nothing but their number.
    void setUnknowns(std::span<const ExpressionId> unknowns);
    /// Asks about one unknown and the nodes that depend on it (DependentNodes); all others are taken to be free of it.
    void setUnknown(ExpressionId unknown, std::span<const std::uint32_t> dependent);
    Dependence operator()(ExpressionId of);

private:
    struct Known {
        std::uint32_t round{};
        Dependence dependence{};
    };
    Dependence classify(const ExpressionNode& node);

    const ExpressionPool& pool_;
    std::vector<Known> known_;  // by node, valid in its round
    std::uint32_t round_{};
    bool isComplete_{};  // what is not known in this round is free of the unknowns
};

}  // namespace analogon
