#include "core/structure/hybrid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/guard.hpp"
#include "core/structure/partition.hpp"

namespace analogon {

using enum Operation;

Partition::Partition(const FlatModel& model, Signals signals, const std::vector<std::string>& symbolic)
    : signals_(signals), symbolic_(symbolic.begin(), symbolic.end()), model_(std::make_shared<FlatModel>(model)) {
    model_->pool = std::make_shared<ExpressionPool>(*model.pool);
    model_->events = {};
    events_ = model.events;
}

Outcome<HybridModel> Partition::run() {
    findSlots();
    splitEquations();
    if (!faults_.empty()) return faults_;
    match();
    if (!faults_.empty()) return faults_;
    rewriteContinuous();
    rewriteDiscrete();
    buildProgram();
    if (!faults_.empty()) return faults_;
    findReaders();
    finish();
    if (!faults_.empty()) return faults_;
    return std::move(out_);
}

ExpressionPool& Partition::pool() { return *model_->pool; }

FlatVariable& Partition::variable(VariableId id) { return model_->variables[id.value]; }

bool Partition::isSlot(VariableId id) const { return id.value < slotOf_.size() && slotOf_[id.value] >= 0; }

int Partition::addSlot(VariableId id) {
    slotOf_.resize(std::max<std::size_t>(slotOf_.size(), model_->variables.size()), -1);
    const int slot = static_cast<int>(out_.slots.size());
    slotOf_[id.value] = slot;
    out_.slots.push_back(variable(id).name);
    slotIds_.push_back(id);
    return slot;
}

VariableId Partition::addVariable(std::string name, FlatType type) {
    const VariableId id{static_cast<std::uint32_t>(model_->variables.size())};
    FlatVariable made;
    made.name = std::move(name);
    made.type = type;
    made.isProtected = true;
    model_->byName.emplace(made.name, id);
    model_->variables.push_back(std::move(made));
    slotOf_.resize(model_->variables.size(), -1);
    return id;
}

/// Every quantity that changes at events alone.
void Partition::findSlots() {
    const std::size_t count = model_->variables.size();
    slotOf_.assign(count, -1);
    isKnown_.assign(count, 0);
    for (std::uint32_t i = 0; i < count; ++i) {
        const FlatVariable& v = model_->variables[i];
        if (v.variability != FlatVariability::Continuous || v.type == FlatType::String) continue;
        if (v.type == FlatType::Real && !v.isDiscrete) continue;
        addSlot({i});
        isKnown_[i] = v.causality == FlatCausality::Input;
    }
    for (const auto& [before, of] : events_.pres) {
        if (slotOf_[of.value] >= 0) {
            out_.pres.emplace_back(slotOf_[before.value], slotOf_[of.value]);
            before_[of.value] = before.value;
        } else
            running_.emplace_back(before, of);
    }
    for (const FlatEvents::Sample& sample : events_.samples) momentary_.insert(sample.flag.value);
    for (const VariableId flag : {events_.initial, events_.terminal})
        if (flag.valid()) momentary_.insert(flag.value);
    if (events_.initial.valid()) out_.initial = slotOf_[events_.initial.value];
    if (events_.terminal.valid()) out_.terminal = slotOf_[events_.terminal.value];
}

std::optional<VariableId> Partition::lone(ExpressionId id) {
    const ExpressionNode& node = pool()[id];
    if (node.operation != Variable) return std::nullopt;
    return node.variable;
}

bool Partition::isUnknownSlot(std::optional<VariableId> id) { return id && isSlot(*id) && !isKnown_[id->value]; }

bool Partition::isContinuousVariable(std::optional<VariableId> id) {
    return id && !isSlot(*id) && variable(*id).variability == FlatVariability::Continuous;
}

/// Of a type that changes at events, as far as the expression tells.
bool Partition::isDiscreteTyped(std::optional<VariableId> id) { return id && variable(*id).type != FlatType::Real; }

void Partition::splitEquations() {
    std::vector<FlatEquation> continuous;
    for (const FlatEquation& e : model_->equations) {
        const auto left = lone(e.left), right = lone(e.right);
        DiscreteEquation d{e, {}};
        const auto consider = [&](std::optional<VariableId> target, std::optional<VariableId> other,
                                  ExpressionId value) {
            if (!isUnknownSlot(target) || isContinuousVariable(other)) return;
            if (e.isDiscrete ? variable(*target).isDiscrete || isDiscreteTyped(target) : isDiscreteTyped(target))
                d.ways.emplace_back(*target, value);
        };
        consider(left, right, e.right);
        if (!e.isDiscrete) consider(right, left, e.left);
        if (d.ways.empty())
            continuous.push_back(e);
        else
            discrete_.push_back(std::move(d));
    }
    model_->equations = std::move(continuous);
    splitInitialEquations();
}

/// Those that say what a discrete variable begins with. `x = r` does so only where nothing else says it of r: otherwise
/// it says it of x.
void Partition::splitInitialEquations() {
    std::vector<FlatEquation> initial, open;
    std::set<std::uint32_t> given;
    const auto giveTo = [&](std::optional<VariableId> id, ExpressionId value) {
        if (!id || !isSlot(*id)) return false;
        initial_.emplace_back(*id, value);
        given.insert(id->value);
        return true;
    };
    const auto place = [&](const FlatEquation& e) {
        if (!giveTo(lone(e.left), e.right) && !giveTo(lone(e.right), e.left)) initial.push_back(e);
    };
    const auto isGiven = [&](std::optional<VariableId> id) {
        return id && isSlot(*id) && (variable(*id).isFixed || given.count(id->value));
    };
    for (const FlatEquation& e : model_->initialEquations)
        if (isContinuousVariable(lone(e.left)) || isContinuousVariable(lone(e.right)))
            open.push_back(e);
        else
            place(e);
    for (const FlatEquation& e : open)
        if (isGiven(lone(e.left)) || isGiven(lone(e.right)))
            initial.push_back(e);
        else
            place(e);
    model_->initialEquations = std::move(initial);
}

bool Partition::augment(std::size_t equation, std::vector<char>& seen) {
    for (const auto& [id, value] : discrete_[equation].ways) {
        if (std::exchange(seen[id.value], 1)) continue;
        const auto holder = equationOf_.find(id.value);
        if (holder == equationOf_.end() || augment(holder->second, seen)) {
            equationOf_[id.value] = equation;
            return true;
        }
    }
    return false;
}

void Partition::match() {
    for (std::size_t e = 0; e < discrete_.size(); ++e) {
        std::vector<char> seen(model_->variables.size(), 0);
        if (!augment(e, seen) && faults_.size() < 10)
            faults_.push_back(
                error(phrase("'{}' is set by two equations", variable(discrete_[e].ways.front().first).name),
                      discrete_[e].equation.span));
    }
    for (const VariableId id : slotIds_)
        if (!isKnown_[id.value] && !equationOf_.count(id.value) && faults_.size() < 10)
            faults_.push_back(error(phrase("nothing sets '{}', which changes at events alone", variable(id).name),
                                    variable(id).declared,
                                    phrase("an equation that sets it has it alone on one side")));
}

// --------------------------------------------------------------------------------------------- the program

int Partition::step(ExpressionId id) {
    if (const auto known = stepOf_.find(id.value); known != stepOf_.end()) return known->second;
    const ExpressionNode node = pool()[id];
    DiscreteProgram::Step made;
    made.operation = node.operation;
    made.value = node.value;
    if (node.operation == Variable && isSlot(node.variable)) {
        const auto value = values_.find(node.variable.value);
        if (value != values_.end() && open_.insert(node.variable.value).second) {
            const int set = step(value->second);
            open_.erase(node.variable.value);
            return stepOf_[id.value] = set;
        }
        made.slot = slotOf_[node.variable.value];  // known, or set in a circle: as it was before
        return append(made);
    }
    if (node.operation == Variable && variable(node.variable).variability != FlatVariability::Continuous &&
        !isOpen(node.variable)) {
        const auto value = model_->parameterValue(node.variable);
        if (!value && variable(node.variable).type != FlatType::String)
            faults_.push_back(error(phrase("The parameter '{}' has no value.", variable(node.variable).name),
                                    variable(node.variable).declared));
        made.operation = Constant;
        made.value = value.value_or(0);
    } else if (node.operation == Variable || node.operation == Derivative) {
        made.operation = Variable;
        made.reading = readingOf(id);
    } else if (node.operation == Delay) {
        faults_.push_back(error(phrase("delay() cannot decide when 'sample' ticks")));
    } else {
        if (node.a.valid()) made.a = step(node.a);
        if (node.b.valid()) made.b = step(node.b);
        if (node.c.valid()) made.c = step(node.c);
    }
    return stepOf_[id.value] = append(made);
}

int Partition::append(const DiscreteProgram::Step& made) {
    out_.program.steps.push_back(made);
    return static_cast<int>(out_.program.steps.size()) - 1;
}

void Partition::buildProgram() {
    // Slots in circles are read before they are set: what was made of such a reading must not be shared with what
    // is outside of the circle.
    for (const auto& [id, value] : values_) out_.assignments.push_back({slotOf_[id], step(pool().variable({id}))});
    for (const auto& [id, value] : initial_) {
        int target = slotOf_[id.value];
        for (const auto& [before, of] : out_.pres)
            if (of == target) target = before;
        out_.initialAssignments.push_back({target, step(value)});
    }
    for (const auto& [index, rest] : relationOffsets_) out_.relations[index].offset = step(rest);
    for (const auto& [index, rest] : wholeOffsets_) out_.wholes[index].offset = step(rest);
    for (const FlatEvents::Reinit& reinit : events_.reinits) {
        const auto target = lone(reinit.variable);
        out_.reinits.push_back(
            {step(reinit.condition), step(reinit.value), target ? variable(*target).name : std::string(), reinit.span});
    }
    for (const FlatEvents::Check& check : events_.checks)
        out_.checks.push_back({step(check.condition), check.message, check.isWarning, check.isTerminate, check.span});
    for (const FlatEvents::Sample& sample : events_.samples)
        out_.samples.push_back(
            {slotOf_[sample.flag.value], step(sample.start), step(sample.interval), variable(sample.flag).declared});
    for (const FlatEvents::Subscript& subscript : events_.subscripts)
        out_.subscripts.push_back({step(subscript.index), subscript.extent, subscript.span});
    out_.program.tables = pool().tables();
    out_.program.findReaders();
}

/// Slots become parameters that keep their names, readings the only outputs.
void Partition::finish() {
    const std::set<std::uint32_t> readings = [&] {
        std::set<std::uint32_t> ids;
        for (const VariableId id : readingIds_) ids.insert(id.value);
        return ids;
    }();
    for (std::uint32_t i = 0; i < model_->variables.size(); ++i) {
        FlatVariable& v = model_->variables[i];
        if (isSlot({i})) {
            const double start = v.start.valid() ? startOf(v) : 0;
            if (v.start.valid() && speaksOfOpen(v.start))
                faults_.push_back(
                    error(phrase("'{}' changes at events alone, and begins with a value that is fitted", v.name),
                          v.declared, phrase("fit what does not decide how it begins")));
            if (signals_ == Signals::Kept && v.causality == FlatCausality::Output)
                out_.outputs.push_back({v.name, slotOf_[i]});
            v.variability = FlatVariability::Parameter;
            v.causality = FlatCausality::Local;
            v.binding = pool().constant(start);
            v.start = {};
            v.min = v.max = std::nullopt;
        } else if (!readings.count(i) && v.causality == FlatCausality::Output) {
            if (signals_ == Signals::Dropped)
                v.causality = FlatCausality::Local;
            else
                out_.outputs.push_back({v.name});
        } else if (v.causality == FlatCausality::Input && v.variability == FlatVariability::Continuous &&
                   !delayed_.count(i) && signals_ == Signals::Dropped) {
            v.causality = FlatCausality::Local;  // nobody drives it: it stays at its start
            model_->equations.push_back(
                {pool().variable({i}), pool().constant(v.start.valid() ? startOf(v) : 0), v.declared, {}, false});
        }
    }
    for (const VariableId id : slotIds_) out_.starts.push_back(pool()[variable(id).binding].value);
    out_.continuous = model_;
    if (signals_ == Signals::Kept) out_.outside = outside();
}

std::shared_ptr<const FlatModel> Partition::outside() {
    auto seen = std::make_shared<FlatModel>(*model_);
    out_.outsideSlots = out_.slots;
    for (const VariableId id : readingIds_) seen->variables[id.value].causality = FlatCausality::Local;
    for (const std::uint32_t id : delayed_) {
        FlatVariable& v = seen->variables[id];
        v.causality = FlatCausality::Local;
        v.variability = FlatVariability::Parameter;
        v.binding = pool().constant(0);
    }
    for (const HybridModel::Output& output : out_.outputs) {
        if (output.slot < 0) continue;
        const auto slot = static_cast<std::size_t>(output.slot);
        const VariableId id{static_cast<std::uint32_t>(seen->variables.size())};
        FlatVariable shown = seen->variables[slotIds_[slot].value];
        out_.outsideSlots[slot] = "$held " + output.name;
        seen->variables[slotIds_[slot].value].name = out_.outsideSlots[slot];
        seen->byName[output.name] = id;
        seen->byName[out_.outsideSlots[slot]] = slotIds_[slot];
        shown.type = FlatType::Real;
        shown.variability = FlatVariability::Continuous;
        shown.causality = FlatCausality::Output;
        shown.binding = {};
        seen->variables.push_back(shown);
        seen->equations.push_back({pool().variable(id), pool().variable(slotIds_[slot]), shown.declared, {}, false});
    }
    return seen;
}

double Partition::startOf(const FlatVariable& v) {
    const double value = pool().evaluate(v.start, [&](const ExpressionNode& leaf) {
        return leaf.operation == Variable ? model_->parameterValue(leaf.variable).value_or(0) : 0;
    });
    return std::isfinite(value) ? value : 0;
}

Outcome<HybridModel> partition(const FlatModel& model, Signals signals, const std::vector<std::string>& symbolic) {
    return guardedOutcome([&] { return Partition(model, signals, symbolic).run(); });
}

}  // namespace analogon
