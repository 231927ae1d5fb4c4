#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/structure/structure.hpp"

/// What the passes of the structural analysis hand to each other.
namespace analogon {

/// left = right, after differentiation `order` times.
struct Equation {
    ExpressionId left, right;
    Span span;
    std::string component;
    int order{};
};

/// A quantity to be solved for: a class of variables that alias elimination found equal.
struct Unknown {
    ExpressionId node;          // the Variable or Derivative node that stands for it in the equations
    ExpressionId derivative;    // its time derivative: a signed node, a constant, der(input); invalid: none in use
    int derivativeUnknown{-1};  // the unknown in `derivative`; -1: none, or the derivative is known
    ExpressionId start;         // over parameters; invalid: not given
    bool isFixed{};
    StateSelect stateSelect{StateSelect::Default};
    double nominal{1};
    bool hasNominal{};
    bool isSynthetic{};  // came into being by differentiation
    Span declared;
};

/// The equations between the passes.
struct EquationSystem {
    std::shared_ptr<FlatModel> model;  // own copy
    std::shared_ptr<ExpressionPool> pool;
    std::vector<Equation> equations;
    std::vector<Equation> initialEquations;
    std::vector<Unknown> unknowns;
    std::vector<int> unknownOfNode;  // by node id; -1 or beyond the end: not an unknown

    int unknownOf(ExpressionId node) const {
        return node.value < unknownOfNode.size() ? unknownOfNode[node.value] : -1;
    }
    int addUnknown(Unknown unknown);
    /// "rotor.w", "der(rotor.w)".
    std::string nameOf(ExpressionId node) const;
    std::string nameOf(int unknown) const { return nameOf(unknowns[static_cast<std::size_t>(unknown)].node); }
    /// "J*der(w) = tau (in rotor)", shortened for messages.
    Text textOf(const Equation& equation) const;
    ExpressionId residual(const Equation& equation) const { return pool->subtract(equation.left, equation.right); }
};

/// What to do about an input whose second derivative is asked for.
inline Text noSecondDerivative() {
    return phrase(
        "A recorded signal runs linearly between its samples: it has a slope and no second derivative. Leave out the "
        "inertia that follows it rigidly, drive it through a spring and damper, or pass the signal through "
        "Signals.FirstOrder twice.");
}

}  // namespace analogon
