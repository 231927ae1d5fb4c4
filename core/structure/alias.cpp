#include "core/structure/alias.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/structure/alias_classes.hpp"
#include "core/structure/rewrite.hpp"

namespace analogon {
namespace {

using Signed = AliasClasses::Signed;

/// A linear equation with constant coefficients: sum of coefficient * entity + constant = 0.
struct Row {
    std::vector<std::pair<int, double>> terms;
    double constant{};
    std::size_t equation{};
    bool isOpen{true};
};

class AliasElimination {
public:
    explicit AliasElimination(FoldedModel folded)
        : folded_(std::move(folded)), system_(folded_.system), pool_(*system_.pool) {}

    Outcome<AliasedSystem> run();

private:
    void createEntities();
    int entityOf(ExpressionId node);
    bool round();
    std::optional<Row> rowOf(const Equation& equation);
    bool addTerms(ExpressionId of, double scale, Row& row);
    void process(Row& row);
    void letWait(const Row& row, int number);
    std::vector<int> takeWaiting(int root);
    void refuse(const Equation& equation, const Text& why);
    void addLeftEquations();
    void closeInputs();
    Text slopesOf(int derivativeClass);
    void chooseRepresentatives();
    int score(VariableId id, const Signed& root) const;
    ExpressionId signedNode(ExpressionId node, int sign) { return sign < 0 ? pool_.negate(node) : node; }
    ExpressionId representative(ExpressionId node);
    void rewriteEquations();
    std::vector<char> idleDerivatives();
    void listUnknowns();
    void mergeAttributes();
    void mergeStart(VariableId id, int sign, Unknown& unknown, VariableId& fixedBy);

    bool isUnknownVariable(const FlatVariable& v) const {
        return v.variability == FlatVariability::Continuous && v.type != FlatType::String;
    }

    FoldedModel folded_;
    EquationSystem& system_;
    ExpressionPool& pool_;
    AliasClasses classes_;
    std::vector<int> entityOfNode_;        // by node id
    std::vector<ExpressionId> nodeOf_;     // by entity
    std::vector<ExpressionId> standsFor_;  // by root: the node that stands for the class (times sign of its entity)
    std::vector<char> isOpen_;             // by equation: still an equation
    std::vector<char> isDifferentiated_;   // by variable
    std::vector<Equation> redundant_;
    Diagnostics faults_;
};

int AliasElimination::entityOf(ExpressionId node) {
    if (node.value >= entityOfNode_.size())
        entityOfNode_.resize(std::max<std::size_t>(pool_.size(), node.value + 1), -1);
    if (entityOfNode_[node.value] >= 0) return entityOfNode_[node.value];
    const int entity = classes_.add();
    entityOfNode_[node.value] = entity;
    nodeOf_.push_back(node);
    const ExpressionNode n = pool_[node];
    if (n.operation == Operation::Derivative) {
        isDifferentiated_[n.variable.value] = 1;
        classes_.link(entityOf(pool_.variable(n.variable)), entity);
    } else if ((*system_.model)[n.variable].causality == FlatCausality::Input) {
        classes_.of(entity).known = entity;
    }
    return entity;
}

void AliasElimination::createEntities() {
    isDifferentiated_.resize(system_.model->variables.size());
    for (std::uint32_t i = 0; i < system_.model->variables.size(); ++i)
        if (isUnknownVariable(system_.model->variables[i])) entityOf(pool_.variable({i}));
    LeafCollector collect(pool_);
    const auto enter = [&](const std::vector<Equation>& equations) {
        for (const Equation& equation : equations) {
            const ExpressionId sides[] = {equation.left, equation.right};
            for (const ExpressionId leaf : std::vector(collect.leaves(sides)))
                if (isUnknownVariable((*system_.model)[pool_[leaf].variable])) entityOf(leaf);
        }
    };
    enter(system_.equations);
    enter(system_.initialEquations);
    isOpen_.assign(system_.equations.size(), 1);
}

/// Adds scale * expression to the row; false when it is not linear with constant coefficients.
bool AliasElimination::addTerms(ExpressionId of, double scale, Row& row) {
    constexpr std::size_t longest = 64;
    const ExpressionNode node = pool_[of];
    switch (node.operation) {
        case Operation::Constant:
            row.constant += scale * node.value;
            return true;
        case Operation::Variable:
        case Operation::Derivative:
            if (!isUnknownVariable((*system_.model)[node.variable]) || row.terms.size() >= longest) return false;
            row.terms.emplace_back(entityOf(of), scale);
            return true;
        case Operation::Negate:
            return addTerms(node.a, -scale, row);
        case Operation::Add:
            return addTerms(node.a, scale, row) && addTerms(node.b, scale, row);
        case Operation::Subtract:
            return addTerms(node.a, scale, row) && addTerms(node.b, -scale, row);
        case Operation::Multiply:
            if (pool_.isConstant(node.a)) return addTerms(node.b, scale * pool_[node.a].value, row);
            if (pool_.isConstant(node.b)) return addTerms(node.a, scale * pool_[node.b].value, row);
            return false;
        case Operation::Divide:
            if (!pool_.isConstant(node.b) || pool_[node.b].value == 0) return false;
            return addTerms(node.a, scale / pool_[node.b].value, row);
        default:
            return false;
    }
}

std::optional<Row> AliasElimination::rowOf(const Equation& equation) {
    Row row;
    if (!addTerms(equation.left, 1, row) || !addTerms(equation.right, -1, row)) return {};
    return row;
}

void AliasElimination::refuse(const Equation& equation, const Text& why) {
    faults_.push_back(
        error(why, equation.span, phrase("Two sources or fixed values act on the same quantity; remove one of them.")));
}

/// Looks at a row through the classes as they are now, and takes it out when it is an alias or a constant.
void AliasElimination::process(Row& row) {
    std::vector<std::pair<int, double>> terms;
    double constant = row.constant, largest = 0;
    for (const auto& [entity, coefficient] : row.terms) {
        const Signed root = classes_.find(entity);
        const AliasClasses::Class& c = classes_.of(root.entity);
        if (c.constant)
            constant += coefficient * root.sign * *c.constant;
        else
            terms.emplace_back(root.entity, coefficient * root.sign);
        largest = std::max(largest, std::fabs(coefficient));
    }
    std::sort(terms.begin(), terms.end());
    std::size_t count = 0;
    for (std::size_t i = 0; i < terms.size();) {
        const int entity = terms[i].first;
        double sum = 0;
        for (; i < terms.size() && terms[i].first == entity; ++i) sum += terms[i].second;
        if (std::fabs(sum) > 1e-14 * largest) terms[count++] = {entity, sum};
    }
    terms.resize(count);

    const Equation& equation = system_.equations[row.equation];
    AliasClasses::Merge merged = AliasClasses::Merge::Cycle;
    if (count == 0) {
        if (std::fabs(constant) <= 1e-12 * (std::fabs(row.constant) + largest))
            merged = AliasClasses::Merge::Same;
        else
            merged = AliasClasses::Merge::Contradiction;
    } else if (count == 1) {
        merged = classes_.assign(terms[0].first, -constant / terms[0].second);
    } else if (count == 2 && constant == 0 && std::fabs(terms[0].second) == std::fabs(terms[1].second)) {
        merged = classes_.unite(terms[0].first, terms[1].first, terms[0].second == terms[1].second ? -1 : 1);
    } else {
        return;
    }
    switch (merged) {
        case AliasClasses::Merge::Done:
            row.isOpen = false;
            isOpen_[row.equation] = 0;
            break;
        case AliasClasses::Merge::Same:
            row.isOpen = false;
            isOpen_[row.equation] = 0;
            redundant_.push_back(equation);
            break;
        case AliasClasses::Merge::Contradiction:
            row.isOpen = false;
            refuse(equation, phrase("The equation {} cannot hold: other equations fix the same quantities to different "
                                    "values.",
                                    system_.textOf(equation)));
            break;
        case AliasClasses::Merge::BothKnown:
            row.isOpen = false;
            refuse(equation, phrase("The equation {} fixes an input of the model, which is given from outside.",
                                    system_.textOf(equation)));
            break;
        case AliasClasses::Merge::Cycle:
            break;  // stays an equation
    }
}

/// A row that tells nothing yet is looked at again when one of its classes changes.
void AliasElimination::letWait(const Row& row, int number) {
    for (const auto& [entity, coefficient] : row.terms)
        classes_.of(classes_.find(entity).entity).waiting.push_back(number);
}

/// The rows that wait for a class, in their order. They wait no longer: whoever takes them looks at each, so that a
/// row costs what its own looks cost, however large the class has become.
std::vector<int> AliasElimination::takeWaiting(int root) {
    std::vector<int> rows = std::exchange(classes_.of(classes_.find(root).entity).waiting, {});
    std::sort(rows.begin(), rows.end());
    return rows;
}

/// One pass over all equations, to the end of what linear rows can tell. True when something was merged.
bool AliasElimination::round() {
    std::vector<Row> rows;
    std::vector<std::size_t> queue;
    for (std::size_t i = 0; i < system_.equations.size(); ++i) {
        if (!isOpen_[i]) continue;
        const Equation& equation = system_.equations[i];
        if (equation.left == equation.right) {
            isOpen_[i] = 0;
            redundant_.push_back(equation);
            continue;
        }
        std::optional<Row> row = rowOf(equation);
        if (!row) continue;
        row->equation = i;
        queue.push_back(rows.size());
        rows.push_back(std::move(*row));
    }
    for (int root = 0; root < classes_.size(); ++root) classes_.of(root).waiting.clear();
    (void)classes_.takeChanged();
    bool merged = false;
    std::vector<char> isQueued(rows.size(), 1);
    for (std::size_t at = 0; at < queue.size(); ++at) {
        const std::size_t r = queue[at];
        isQueued[r] = 0;
        if (!rows[r].isOpen) continue;
        process(rows[r]);
        if (rows[r].isOpen) letWait(rows[r], static_cast<int>(r));
        for (const int root : classes_.takeChanged()) {
            merged = true;
            for (const int again : takeWaiting(root)) {
                const auto row = static_cast<std::size_t>(again);
                if (isQueued[row] || !rows[row].isOpen) continue;
                isQueued[row] = 1;
                queue.push_back(row);
            }
        }
    }
    return merged;
}

/// Derivatives that are equal because their integrals are, where merging was not possible.
void AliasElimination::addLeftEquations() {
    for (const AliasClasses::Left& left : classes_.takeLeft()) {
        const auto node = [&](int e) { return nodeOf_[static_cast<std::size_t>(e)]; };
        system_.equations.push_back({node(left.a), signedNode(node(left.b), left.sign), {}, "", 1});
        isOpen_.push_back(1);
    }
}

/// ", as the derivative of 'J.w'": the variables that are an input's slope.
Text AliasElimination::slopesOf(int derivativeClass) {
    constexpr int most = 3;
    std::string names;
    int count = 0;
    for (std::uint32_t i = 0; i < system_.model->variables.size() && count < most; ++i) {
        if (!isUnknownVariable(system_.model->variables[i])) continue;
        const int entity = entityOf(pool_.variable({i}));
        if (entity < 0 || classes_.find(entity).entity != derivativeClass) continue;
        names += (count++ == 0 ? "'" : ", '") + system_.model->variables[i].name + "'";
    }
    return names.empty() ? Text() : phrase(", as the derivative of {}", names);
}

/// The derivative of an input is known as well: it is a further input of the program.
void AliasElimination::closeInputs() {
    for (std::uint32_t i = 0; i < system_.model->variables.size(); ++i) {
        const FlatVariable& variable = system_.model->variables[i];
        if (variable.causality != FlatCausality::Input || !isUnknownVariable(variable)) continue;
        const Signed self = classes_.find(entityOf(pool_.variable({i})));
        const Signed slot = classes_.of(self.entity).derivative;
        if (slot.entity < 0) continue;
        const int derivative = entityOf(pool_.derivativeOf({i}));
        AliasClasses::Class& c = classes_.of(classes_.find(derivative).entity);
        if (c.constant || c.known >= 0) {
            faults_.push_back(
                error(phrase("The derivative of the input '{}' is fixed by the equations.", variable.name),
                      variable.declared));
        } else if (c.derivative.entity >= 0) {
            faults_.push_back(error(phrase("The model needs the second derivative of the input '{}'{}.", variable.name,
                                           slopesOf(classes_.find(derivative).entity)),
                                    variable.declared, noSecondDerivative()));
        } else {
            c.known = derivative;
        }
    }
}

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

}  // namespace

Outcome<AliasedSystem> eliminateAliases(FoldedModel folded) { return AliasElimination(std::move(folded)).run(); }

}  // namespace analogon
