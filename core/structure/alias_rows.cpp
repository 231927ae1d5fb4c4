#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "core/structure/alias_elimination.hpp"
#include "core/structure/rewrite.hpp"

namespace analogon {

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

std::optional<AliasElimination::Row> AliasElimination::rowOf(const Equation& equation) {
    Row row;
    if (!addTerms(equation.left, 1, row) || !addTerms(equation.right, -1, row)) return {};
    return row;
}

void AliasElimination::refuse(const Equation& equation, const Text& why) {
    faults_.push_back(
        error(why, equation.span, phrase("Two sources or fixed values act on the same quantity; remove one of them.")));
}

/// The row through the classes as they are now: each once, without those that cancel or are constant.
AliasElimination::Row AliasElimination::seen(const Row& row, double largest) const {
    std::vector<std::pair<int, double>> terms;
    Row now;
    now.constant = row.constant;
    for (const auto& [entity, coefficient] : row.terms) {
        const Signed root = classes_.find(entity);
        const AliasClasses::Class& c = classes_.of(root.entity);
        if (c.constant)
            now.constant += coefficient * root.sign * *c.constant;
        else
            terms.emplace_back(root.entity, coefficient * root.sign);
    }
    std::sort(terms.begin(), terms.end());
    for (std::size_t i = 0; i < terms.size();) {
        const int entity = terms[i].first;
        double sum = 0;
        for (; i < terms.size() && terms[i].first == entity; ++i) sum += terms[i].second;
        if (std::fabs(sum) > 1e-14 * largest) now.terms.emplace_back(entity, sum);
    }
    return now;
}

/// Takes a row out when it is an alias or a constant.
void AliasElimination::process(Row& row) {
    double largest = 0;
    for (const auto& [entity, coefficient] : row.terms) largest = std::max(largest, std::fabs(coefficient));
    const Row now = seen(row, largest);
    const std::vector<std::pair<int, double>>& terms = now.terms;
    const double constant = now.constant;
    const std::size_t count = terms.size();
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

/// Two variables with derivatives that are set to the same expression are one: left apart, both would be taken for
/// states, and what the second equation says would cancel.
void AliasElimination::joinEqualSides() {
    std::unordered_map<std::uint32_t, ExpressionId> setTo;  // by the expression
    for (std::size_t i = 0; i < system_.equations.size(); ++i) {
        if (!isOpen_[i]) continue;
        Equation& equation = system_.equations[i];
        const auto join = [&](ExpressionId name, ExpressionId& expression) {
            const ExpressionNode node = pool_[name], other = pool_[expression];
            const bool isState = node.operation == Operation::Variable &&
                                 isUnknownVariable((*system_.model)[node.variable]) &&
                                 isDifferentiated_[node.variable.value];
            if (!isState || !other.a.valid()) return false;
            const auto [first, isNew] = setTo.emplace(expression.value, name);
            if (!isNew && first->second != name) expression = first->second;
            return true;
        };
        if (!join(equation.left, equation.right)) join(equation.right, equation.left);
    }
}

/// One pass over all equations, to the end of what linear rows can tell. True when something was merged.
bool AliasElimination::round() {
    joinEqualSides();
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

}  // namespace analogon
