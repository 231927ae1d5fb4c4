#include <array>

#include "core/structure/partition.hpp"

/// What matters at events alone: relations that nobody has to watch for, and slots that the motion between events does
/// not read.
namespace analogon {

using enum Operation;

/// Whether one of these is pre() of the other, or of its opposite.
bool Partition::isChange(ExpressionId a, ExpressionId b, bool isOfOpposites) {
    const auto withoutNot = [&](ExpressionId id, bool& isOpposite) {
        for (; pool()[id].operation == Not; id = pool()[id].a) isOpposite = !isOpposite;
        return pool()[id];
    };
    bool isOpposite = false;
    const ExpressionNode one = withoutNot(a, isOpposite), other = withoutNot(b, isOpposite);
    if (one.operation != Variable || other.operation != Variable || isOpposite != isOfOpposites) return false;
    const auto isBefore = [&](VariableId before, VariableId of) {
        const auto known = before_.find(of.value);
        return known != before_.end() && known->second == before.value;
    };
    return isBefore(one.variable, other.variable) || isBefore(other.variable, one.variable);
}

/// Whether a condition can hold while an event is worked out only: at samples, at the start and the end, and where a
/// discrete quantity is not what it was before.
bool Partition::isAtEventsAlone(ExpressionId id) {
    if (const auto known = isAtEventsAlone_.find(id.value); known != isAtEventsAlone_.end()) return known->second;
    const ExpressionNode node = pool()[id];
    bool result = false;
    if (node.operation == Constant)
        result = node.value == 0;
    else if (node.operation == Variable)
        result = momentary_.count(node.variable.value) > 0;
    else if (node.operation == NotEqual)
        result = isChange(node.a, node.b, false);
    else if (node.operation == And)
        result = isAtEventsAlone(node.a) || isAtEventsAlone(node.b) || isChange(node.a, node.b, true);
    else if (node.operation == Or)
        result = isAtEventsAlone(node.a) && isAtEventsAlone(node.b);
    return isAtEventsAlone_[id.value] = result;
}

ExpressionId Partition::frozenAtEvents(ExpressionId id) {
    const bool before = std::exchange(isAtEvents_, true);
    const ExpressionId result = frozen(id);
    isAtEvents_ = before;
    return result;
}

/// A choice; what is asked for where an event is worked out only raises none itself (Modelica 3.6, section 3.7.2).
ExpressionId Partition::frozenChoice(const ExpressionNode& node) {
    const auto side = [&](ExpressionId id, bool isAtEvents) { return isAtEvents ? frozenAtEvents(id) : frozen(id); };
    const auto isElsewhere = [&](ExpressionId id) {
        return pool()[id].operation == Not && isAtEventsAlone(pool()[id].a);
    };
    if (node.operation == If)
        return pool().ifThenElse(frozen(node.a), side(node.b, isAtEventsAlone(node.a)), frozen(node.c));
    if (node.operation == And) {
        const bool isFirst = isAtEventsAlone(node.a);
        return pool().binary(And, side(node.a, !isFirst && isAtEventsAlone(node.b)), side(node.b, isFirst));
    }
    const bool isFirst = isElsewhere(node.a);
    return pool().binary(Or, side(node.a, !isFirst && isElsewhere(node.b)), side(node.b, isFirst));
}

/// Which slots the motion between events reads. An equation with a variable that stands nowhere else says what this
/// variable is, and nothing to the others; what is left without all of those is what the motion may follow from.
void Partition::findReaders() {
    const std::size_t count = model_->equations.size();
    std::vector<std::vector<std::uint32_t>> named(count);
    std::vector<std::vector<std::size_t>> namedBy(model_->variables.size());
    std::vector<char> isNeeded(model_->variables.size(), 0), isLeft(count, 1);
    for (std::size_t e = 0; e < count; ++e)
        for (const ExpressionId leaf :
             pool().leaves(std::array{model_->equations[e].left, model_->equations[e].right})) {
            const ExpressionNode node = pool()[leaf];
            if (node.operation == Derivative) isNeeded[node.variable.value] = 1;
            std::vector<std::size_t>& by = namedBy[node.variable.value];
            if (!by.empty() && by.back() == e) continue;
            by.push_back(e);
            named[e].push_back(node.variable.value);
        }
    const auto need = [&](int reading) { isNeeded[readingIds_[static_cast<std::size_t>(reading)].value] = 1; };
    for (const HybridModel::Relation& r : out_.relations)
        if (r.isWatched) need(r.reading);
    for (const HybridModel::Whole& w : out_.wholes)
        if (w.isWatched) need(w.reading);
    for (const HybridModel::Delay& delay : out_.delays) need(delay.reading);
    std::vector<std::size_t> uses(namedBy.size());
    std::vector<std::uint32_t> lone;
    const auto consider = [&](std::uint32_t id) {
        const FlatVariable& v = variable({id});
        if (uses[id] == 1 && !isNeeded[id] && !isSlot({id}) && v.variability == FlatVariability::Continuous &&
            v.causality != FlatCausality::Input)
            lone.push_back(id);
    };
    for (std::uint32_t id = 0; id < uses.size(); ++id) {
        uses[id] = namedBy[id].size();
        consider(id);
    }
    while (!lone.empty()) {
        const std::uint32_t id = lone.back();
        lone.pop_back();
        for (const std::size_t e : namedBy[id]) {
            if (!std::exchange(isLeft[e], 0)) continue;
            for (const std::uint32_t other : named[e]) {
                --uses[other];
                consider(other);
            }
        }
    }
    out_.isRead.assign(out_.slots.size(), 0);
    for (std::size_t e = 0; e < count; ++e)
        for (const std::uint32_t id : named[e])
            if (isLeft[e] && isSlot({id})) out_.isRead[static_cast<std::size_t>(slotOf_[id])] = 1;
}

}  // namespace analogon
