#include "core/structure/alias.hpp"

#include <algorithm>
#include <cmath>

#include "core/structure/alias_elimination.hpp"
#include "core/structure/rewrite.hpp"

namespace analogon {

/// How much a variable deserves to stand for its class.
int AliasElimination::score(VariableId id, const Signed& root) const {
    const FlatVariable& v = (*system_.model)[id];
    int points = 0;
    if (classes_.of(root.entity).derivative.entity >= 0) {
        if (isDifferentiated_[id.value]) points += 400;
        if (v.stateSelect == StateSelect::Always) points += 300;
        if (v.stateSelect == StateSelect::Prefer) points += 200;
        if (v.isFixed) points += 100;
        if (v.start.valid()) points += 50;
        if (v.causality == FlatCausality::Output) points += 20;
    } else if (v.causality == FlatCausality::Output) {
        points += 400;
    }
    if (!v.isProtected) points += 8;
    return points - 2 * static_cast<int>(std::count(v.name.begin(), v.name.end(), '.'));
}

void AliasElimination::chooseRepresentatives() {
    const auto n = static_cast<std::size_t>(classes_.size());
    standsFor_.assign(n, {});
    std::vector<int> best(n);
    for (std::uint32_t i = 0; i < system_.model->variables.size(); ++i) {
        if (!isUnknownVariable(system_.model->variables[i])) continue;
        const ExpressionId node = pool_.variable({i});
        const Signed root = classes_.find(entityOf(node));
        const auto r = static_cast<std::size_t>(root.entity);
        const int points = score({i}, root);
        if (standsFor_[r].valid() && points <= best[r]) continue;
        standsFor_[r] = node;
        best[r] = points;
    }
    for (std::size_t r = 0; r < n; ++r) {
        const AliasClasses::Class& c = classes_.of(static_cast<int>(r));
        if (classes_.find(static_cast<int>(r)).entity == static_cast<int>(r) && c.known >= 0)
            standsFor_[r] = nodeOf_[static_cast<std::size_t>(c.known)];
    }
    // A class of derivatives alone is called der(representative of what it is the derivative of).
    for (std::size_t e = 0; e < n; ++e) {
        const ExpressionNode node = pool_[nodeOf_[e]];
        if (node.operation != Operation::Derivative) continue;
        const auto r = static_cast<std::size_t>(classes_.find(static_cast<int>(e)).entity);
        if (standsFor_[r].valid() || classes_.of(static_cast<int>(r)).constant) continue;
        const Signed base = classes_.find(entityOf(pool_.variable(node.variable)));
        const ExpressionNode of = pool_[standsFor_[static_cast<std::size_t>(base.entity)]];
        standsFor_[r] = pool_.derivativeOf(of.variable);
        entityOf(standsFor_[r]);
    }
    standsFor_.resize(static_cast<std::size_t>(classes_.size()));
}

ExpressionId AliasElimination::representative(ExpressionId node) {
    if (pool_[node].operation == Operation::Time || !isUnknownVariable((*system_.model)[pool_[node].variable]))
        return {};
    const Signed root = classes_.find(entityOf(node));
    if (const auto& constant = classes_.of(root.entity).constant) return pool_.constant(root.sign * *constant);
    const ExpressionId stand = standsFor_[static_cast<std::size_t>(root.entity)];
    return signedNode(stand, root.sign * classes_.find(entityOf(stand)).sign);
}

void AliasElimination::rewriteEquations() {
    Rewriter rewrite(pool_, [this](ExpressionId node) { return representative(node); });
    for (std::size_t i = 0; i < system_.equations.size(); ++i) {
        if (!isOpen_[i]) continue;
        Equation& equation = system_.equations[i];
        equation.left = rewrite(equation.left);
        equation.right = rewrite(equation.right);
    }
    for (Equation& equation : system_.initialEquations) {
        equation.left = rewrite(equation.left);
        equation.right = rewrite(equation.right);
    }
}

/// By root: a derivative that no equation asks for any more (its factor has turned out to be 0). What it is the
/// derivative of is no state then.
std::vector<char> AliasElimination::idleDerivatives() {
    std::vector<char> isIdle(static_cast<std::size_t>(classes_.size()));
    for (std::size_t root = 0; root < isIdle.size(); ++root)
        isIdle[root] = standsFor_[root].valid() && pool_[standsFor_[root]].operation == Operation::Derivative &&
                       classes_.of(static_cast<int>(root)).known < 0;
    LeafCollector collect(pool_);
    const auto enter = [&](const Equation& equation) {
        const ExpressionId sides[] = {equation.left, equation.right};
        for (const ExpressionId leaf : std::vector(collect.leaves(sides)))
            if (isUnknownVariable((*system_.model)[pool_[leaf].variable]))
                isIdle[static_cast<std::size_t>(classes_.find(entityOf(leaf)).entity)] = 0;
    };
    for (std::size_t i = 0; i < system_.equations.size(); ++i)
        if (isOpen_[i]) enter(system_.equations[i]);
    for (const Equation& equation : system_.initialEquations) enter(equation);
    return isIdle;
}

void AliasElimination::listUnknowns() {
    const std::vector<char> isIdle = idleDerivatives();
    std::vector<int> unknownOfRoot(static_cast<std::size_t>(classes_.size()), -1);
    // Every class that is neither constant nor known, in the order of its first member.
    const int count = classes_.size();
    for (int e = 0; e < count; ++e) {
        const int root = classes_.find(e).entity;
        const AliasClasses::Class& c = classes_.of(root);
        if (c.constant || c.known >= 0 || unknownOfRoot[static_cast<std::size_t>(root)] >= 0) continue;
        if (isIdle[static_cast<std::size_t>(root)]) continue;
        Unknown unknown;
        unknown.node = standsFor_[static_cast<std::size_t>(root)];
        unknown.declared = (*system_.model)[pool_[unknown.node].variable].declared;
        unknownOfRoot[static_cast<std::size_t>(root)] = system_.addUnknown(std::move(unknown));
    }
    for (int root = 0; root < count; ++root) {
        const int u = unknownOfRoot[static_cast<std::size_t>(root)];
        const Signed derivative = classes_.of(root).derivative;
        if (u < 0 || derivative.entity < 0) continue;
        if (isIdle[static_cast<std::size_t>(classes_.find(derivative.entity).entity)]) continue;
        Unknown& unknown = system_.unknowns[static_cast<std::size_t>(u)];
        const int sign = derivative.sign * classes_.find(entityOf(unknown.node)).sign;
        unknown.derivative = signedNode(representative(nodeOf_[static_cast<std::size_t>(derivative.entity)]), sign);
        unknown.derivativeUnknown = unknownOfRoot[static_cast<std::size_t>(classes_.find(derivative.entity).entity)];
    }
}

void AliasElimination::mergeStart(VariableId id, int sign, Unknown& unknown, VariableId& fixedBy) {
    const FlatVariable& v = (*system_.model)[id];
    const ExpressionId given = folded_.starts[id.value];
    if (!given.valid() && !v.isFixed) return;
    const ExpressionId start = given.valid() ? signedNode(given, sign) : pool_.constant(0);
    const bool isRepresentative = unknown.node == pool_.variable(id);
    if (!v.isFixed) {
        if (!unknown.isFixed && (!unknown.start.valid() || isRepresentative)) unknown.start = start;
        return;
    }
    if (unknown.isFixed && start != unknown.start) {
        const std::string& first = (*system_.model)[fixedBy].name;
        if (pool_.isConstant(start) && pool_.isConstant(unknown.start)) {
            faults_.push_back(
                error(phrase("'{}' and '{}' are the same quantity, but their start values are fixed to {} and {}.",
                             first, v.name, pool_[unknown.start].value, pool_[start].value),
                      v.declared, phrase("Give both the same start value, or free one of them (fixed = false).")));
        } else {
            folded_.warnings.push_back(
                warning(phrase("'{}' and '{}' are the same quantity; the fixed start value of '{}' is used.", first,
                               v.name, first),
                        v.declared));
        }
        return;
    }
    unknown.start = start;
    unknown.isFixed = true;
    fixedBy = id;
}

void AliasElimination::mergeAttributes() {
    std::vector<VariableId> fixedBy(system_.unknowns.size());
    const auto strength = [](StateSelect s) {
        switch (s) {
            case StateSelect::Always:
                return 4;
            case StateSelect::Prefer:
                return 3;
            case StateSelect::Never:
                return 2;
            case StateSelect::Avoid:
                return 1;
            case StateSelect::Default:
                break;
        }
        return 0;
    };
    for (std::uint32_t i = 0; i < system_.model->variables.size(); ++i) {
        const FlatVariable& v = system_.model->variables[i];
        if (!isUnknownVariable(v)) continue;
        const ExpressionId self = pool_.variable({i});
        const Signed root = classes_.find(entityOf(self));
        if (classes_.of(root.entity).constant) continue;
        const ExpressionId stand = standsFor_[static_cast<std::size_t>(root.entity)];
        const int u = system_.unknownOf(stand);
        if (u < 0) {  // an input stands for it
            if (v.isFixed)
                folded_.warnings.push_back(
                    warning(phrase("The fixed start value of '{}' is not used: the input '{}' prescribes it.", v.name,
                                   system_.nameOf(stand)),
                            v.declared));
            continue;
        }
        Unknown& unknown = system_.unknowns[static_cast<std::size_t>(u)];
        mergeStart({i}, root.sign * classes_.find(entityOf(stand)).sign, unknown, fixedBy[static_cast<std::size_t>(u)]);
        if (strength(v.stateSelect) > strength(unknown.stateSelect)) unknown.stateSelect = v.stateSelect;
        if (v.nominal && *v.nominal != 0 && (!unknown.hasNominal || stand == self)) {
            unknown.nominal = std::fabs(*v.nominal);
            unknown.hasNominal = true;
        }
    }
}

Outcome<AliasedSystem> AliasElimination::run() {
    createEntities();
    constexpr int mostRounds = 20;
    for (int i = 0; i < mostRounds && round(); ++i) {
        if (!faults_.empty()) return faults_;
        addLeftEquations();
        chooseRepresentatives();
        rewriteEquations();
    }
    if (faults_.empty()) closeInputs();
    if (!faults_.empty()) return faults_;
    chooseRepresentatives();
    rewriteEquations();
    listUnknowns();
    mergeAttributes();
    if (!faults_.empty()) return faults_;

    AliasedSystem out;
    for (std::uint32_t i = 0; i < system_.model->variables.size(); ++i) {
        if (!isUnknownVariable(system_.model->variables[i])) continue;
        const ExpressionId self = pool_.variable({i});
        const ExpressionId stand = representative(self);
        if (stand != self) out.aliases.emplace_back(VariableId{i}, stand);
    }
    std::vector<Equation> open;
    for (std::size_t i = 0; i < system_.equations.size(); ++i)
        if (isOpen_[i]) open.push_back(std::move(system_.equations[i]));
    system_.equations = std::move(open);
    out.system = std::move(system_);
    out.redundant = std::move(redundant_);
    out.warnings = std::move(folded_.warnings);
    return out;
}

Outcome<AliasedSystem> eliminateAliases(FoldedModel folded) { return AliasElimination(std::move(folded)).run(); }

}  // namespace analogon
