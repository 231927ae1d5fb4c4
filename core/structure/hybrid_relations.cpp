#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/structure/partition.hpp"

/// Relations and readings: what the equations between events are told of by events, and what events ask of them.
namespace analogon {

using enum Operation;

namespace {

bool isRelation(Operation operation) {
    return operation == Less || operation == LessEqual || operation == Greater || operation == GreaterEqual;
}

}  // namespace

/// Whether a quantity that runs between events is below the node.
bool Partition::runs(ExpressionId id) {
    if (const auto known = runs_.find(id.value); known != runs_.end()) return known->second;
    const ExpressionNode node = pool()[id];
    bool result = false;
    switch (node.operation) {
        case Time:
        case Derivative:
        case Delay:
            result = true;
            break;
        case Variable:
            result = variable(node.variable).variability == FlatVariability::Continuous && !isSlot(node.variable);
            break;
        default:
            for (const ExpressionId part : {node.a, node.b, node.c}) result = result || (part.valid() && runs(part));
    }
    runs_[id.value] = result;
    return result;
}

int Partition::readingOf(ExpressionId expression) {
    const auto [entry, isNew] = readings_.try_emplace(expression.value, static_cast<int>(out_.readings.size()));
    if (isNew) {
        const VariableId id = addVariable(fmt::format("$reading{}", out_.readings.size()), FlatType::Real);
        variable(id).causality = FlatCausality::Output;
        out_.readings.push_back(variable(id).name);
        readingIds_.push_back(id);
        model_->equations.push_back({pool().variable(id), expression, {}, {}, false});
    }
    return entry->second;
}

/// Whether a parameter may take other values than the model's own, or follows one that may.
bool Partition::isOpen(VariableId id) {
    const auto [entry, isNew] = isOpen_.try_emplace(id.value, false);
    if (!isNew) return entry->second;
    const ExpressionId binding = variable(id).binding;
    const bool result = symbolic_.count(variable(id).name) > 0 || (binding.valid() && speaksOfOpen(binding));
    return isOpen_[id.value] = result;
}

bool Partition::speaksOfOpen(ExpressionId id) {
    bool result = false;
    pool().evaluate(id, [&](const ExpressionNode& leaf) {
        result =
            result || (leaf.operation == Variable && !isSlot(leaf.variable) &&
                       variable(leaf.variable).variability != FlatVariability::Continuous && isOpen(leaf.variable));
        return 1.0;
    });
    return result;
}

/// The value of what parameters alone decide, that stay as they are.
std::optional<double> Partition::number(ExpressionId of) {
    bool isNumber = true;
    const double value = pool().evaluate(of, [&](const ExpressionNode& leaf) {
        const auto known = leaf.operation == Variable && !isSlot(leaf.variable) &&
                                   variable(leaf.variable).variability != FlatVariability::Continuous &&
                                   !isOpen(leaf.variable)
                               ? model_->parameterValue(leaf.variable)
                               : std::nullopt;
        isNumber = isNumber && known;
        return known.value_or(0);
    });
    return isNumber && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<Partition::OfTime> Partition::ofTime(ExpressionId id) {
    if (!runs(id)) return OfTime{0, id};
    const ExpressionNode node = pool()[id];
    const auto both = [&](auto combine) -> std::optional<OfTime> {
        const auto a = ofTime(node.a), b = ofTime(node.b);
        return a && b ? combine(*a, *b) : std::nullopt;
    };
    switch (node.operation) {
        case Time:
            return OfTime{1, pool().constant(0)};
        case Negate:
            if (const auto a = ofTime(node.a)) return OfTime{-a->factor, pool().negate(a->rest)};
            return std::nullopt;
        case Add:
            return both([&](const OfTime& a, const OfTime& b) -> std::optional<OfTime> {
                return OfTime{a.factor + b.factor, pool().add(a.rest, b.rest)};
            });
        case Subtract:
            return both([&](const OfTime& a, const OfTime& b) -> std::optional<OfTime> {
                return OfTime{a.factor - b.factor, pool().subtract(a.rest, b.rest)};
            });
        case Multiply:
        case Divide: {
            const bool isLeft = !runs(node.b);
            if (!isLeft && (node.operation == Divide || runs(node.a))) return std::nullopt;
            const auto of = ofTime(isLeft ? node.a : node.b);
            const ExpressionId other = isLeft ? node.b : node.a;
            const auto by = number(other);
            if (!of || !by || *by == 0) return std::nullopt;
            if (node.operation == Divide) return OfTime{of->factor / *by, pool().divide(of->rest, other)};
            return OfTime{of->factor * *by, pool().multiply(of->rest, other)};
        }
        default:
            return std::nullopt;
    }
}

std::string Partition::textOf(Operation operation, ExpressionId a, ExpressionId b) {
    constexpr std::size_t longest = 120;
    std::string text =
        pool().print(pool().binary(operation, a, b), [this](VariableId id) { return variable(id).name; });
    if (text.size() > longest) text = text.substr(0, longest) + " …";
    return text;
}

ExpressionId Partition::relationSlot(Operation operation, ExpressionId a, ExpressionId b) {
    const auto [entry, isNew] = relationOf_.try_emplace({operation, a.value, b.value}, out_.relations.size());
    if (isNew) addRelation(operation, a, b);
    HybridModel::Relation& relation = out_.relations[entry->second];
    relation.isWatched = relation.isWatched || !isAtEvents_;
    return pool().variable(slotIds_[static_cast<std::size_t>(relation.slot)]);
}

void Partition::addRelation(Operation operation, ExpressionId a, ExpressionId b) {
    const VariableId id = addVariable(fmt::format("$relation{}", out_.relations.size()), FlatType::Boolean);
    const int slot = addSlot(id);
    isKnown_.resize(model_->variables.size(), 0);
    isKnown_[id.value] = 1;
    const ExpressionId difference = pool().subtract(a, b);
    HybridModel::Relation relation{slot, readingOf(difference), operation, false, 0, -1, textOf(operation, a, b)};
    if (const auto of = ofTime(difference); of && of->factor != 0) {
        relation.isOfTime = true;
        relation.factor = of->factor;
        relationOffsets_.emplace_back(out_.relations.size(), of->rest);
    }
    out_.relations.push_back(relation);
}

ExpressionId Partition::wholeSlot(ExpressionId of) {
    const auto [entry, isNew] = wholeOf_.try_emplace(of.value, out_.wholes.size());
    if (isNew) addWhole(of);
    HybridModel::Whole& whole = out_.wholes[entry->second];
    whole.isWatched = whole.isWatched || !isAtEvents_;
    return pool().variable(slotIds_[static_cast<std::size_t>(whole.slot)]);
}

void Partition::addWhole(ExpressionId of) {
    const VariableId id = addVariable(fmt::format("$floor{}", out_.wholes.size()), FlatType::Integer);
    const int slot = addSlot(id);
    isKnown_.resize(model_->variables.size(), 0);
    isKnown_[id.value] = 1;
    HybridModel::Whole whole{slot, readingOf(of), false, 0, -1};
    if (const auto linear = ofTime(of); linear && linear->factor != 0) {
        whole.isOfTime = true;
        whole.factor = linear->factor;
        wholeOffsets_.emplace_back(out_.wholes.size(), linear->rest);
    }
    out_.wholes.push_back(whole);
}

/// The expression with a slot for each relation of quantities that run, but within noEvent and smooth.
ExpressionId Partition::frozen(ExpressionId id) {
    const std::map<std::uint32_t, ExpressionId>& known = frozen_[isAtEvents_];
    if (const auto found = known.find(id.value); found != known.end()) return found->second;
    const ExpressionNode node = pool()[id];
    ExpressionId result = id;
    if (node.operation == NoEvent || node.operation == Smooth) {
        result = pool().substitute(id, [&](const ExpressionNode& leaf) {
            return leaf.operation == Delay ? frozen(pool().delay(leaf.a, leaf.b)) : ExpressionId{};
        });
    } else if (!hasParts(node)) {
        result = id;
    } else if (node.operation == Delay) {
        const bool isAtEvents = std::exchange(isAtEvents_, false);  // what was is asked for at all times
        result = isAtEvents ? frozen(id) : delayed(node);
        isAtEvents_ = isAtEvents;
    } else if (node.operation == If || node.operation == And || node.operation == Or) {
        result = frozenChoice(node);
    } else {
        const ExpressionId a = frozen(node.a), b = node.b.valid() ? frozen(node.b) : node.b;
        result = frozenOf(node, a, b);
    }
    return frozen_[isAtEvents_][id.value] = result;
}

/// An input that is fed with what the signal was.
ExpressionId Partition::delayed(const ExpressionNode& node) {
    const ExpressionId signal = frozen(node.a);
    const std::optional<double> time = number(node.b);
    if (!time || *time < 0) {
        faults_.push_back(error(phrase("a model with events needs delays that do not change while it runs"), {},
                                phrase("use a parameter of at least 0 as the delay time")));
        return signal;
    }
    if (*time == 0) return signal;
    const VariableId id = addVariable(fmt::format("$delay{}", out_.delays.size()), FlatType::Real);
    variable(id).causality = FlatCausality::Input;
    isKnown_.resize(model_->variables.size(), 0);
    delayed_.insert(id.value);
    out_.delays.push_back({variable(id).name, readingOf(signal), *time});
    return pool().variable(id);
}

bool Partition::hasParts(const ExpressionNode& node) { return node.a.valid(); }

ExpressionId Partition::frozenOf(const ExpressionNode& node, ExpressionId a, ExpressionId b) {
    ExpressionPool& p = pool();
    const bool moves = runs(a) || (b.valid() && runs(b));
    const auto floorOf = [&](ExpressionId x) { return runs(x) ? wholeSlot(x) : p.unary(Floor, x); };
    const auto truncated = [&](ExpressionId x) {
        const ExpressionId isPositive = relationSlot(GreaterEqual, x, p.constant(0));
        return p.ifThenElse(isPositive, floorOf(x), p.negate(floorOf(p.negate(x))));
    };
    if (moves) {
        if (isRelation(node.operation)) return relationSlot(node.operation, a, b);
        if (node.operation == Sign)
            return p.ifThenElse(relationSlot(Greater, a, p.constant(0)), p.constant(1),
                                p.ifThenElse(relationSlot(Less, a, p.constant(0)), p.constant(-1), p.constant(0)));
        if (node.operation == Floor) return floorOf(a);
        if (node.operation == Ceil) return p.negate(floorOf(p.negate(a)));
        if (node.operation == Mod) return p.subtract(a, p.multiply(floorOf(p.divide(a, b)), b));
        if (node.operation == Div) return truncated(p.divide(a, b));
        if (node.operation == Rem) return p.subtract(a, p.multiply(truncated(p.divide(a, b)), b));
    }
    switch (node.operation) {
        case Table:
            return p.table(LookupTable(p.tables()[static_cast<std::size_t>(node.value)]), a);
        case TableDerivative:
            return p.tableDerivative(static_cast<std::size_t>(node.value), a);
        default:
            return b.valid() ? p.binary(node.operation, a, b) : p.unary(node.operation, a);
    }
}

void Partition::rewriteContinuous() {
    const std::size_t count = model_->equations.size();  // readings are added behind
    for (std::size_t e = 0; e < count; ++e) {
        const ExpressionId left = frozen(model_->equations[e].left), right = frozen(model_->equations[e].right);
        model_->equations[e].left = left;
        model_->equations[e].right = right;
    }
    for (FlatEquation& e : model_->initialEquations) {
        e.left = frozenAtEvents(e.left);
        e.right = frozenAtEvents(e.right);
    }
}

void Partition::rewriteDiscrete() {
    for (const auto& [id, equation] : equationOf_)
        for (const auto& [target, value] : discrete_[equation].ways)
            if (target.value == id) values_[id] = frozen(value);
    for (auto& [id, value] : initial_) value = frozenAtEvents(value);
    for (const auto& [before, of] : running_)
        out_.leftLimits.emplace_back(slotOf_[before.value], readingOf(pool().variable(of)));
    for (FlatEvents::Reinit& reinit : events_.reinits) {
        reinit.condition = frozen(reinit.condition);
        reinit.value = frozenAtEvents(reinit.value);
    }
    for (FlatEvents::Check& check : events_.checks) check.condition = frozen(check.condition);
    for (FlatEvents::Subscript& subscript : events_.subscripts) subscript.index = frozen(subscript.index);
}

}  // namespace analogon
