#include "core/structure/hybrid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "core/base/guard.hpp"

namespace analogon {
namespace {

using enum Operation;

bool isRelation(Operation operation) {
    return operation == Less || operation == LessEqual || operation == Greater || operation == GreaterEqual;
}

class Partition {
public:
    Partition(const FlatModel& model, Signals signals, const std::vector<std::string>& symbolic)
        : signals_(signals), symbolic_(symbolic.begin(), symbolic.end()), model_(std::make_shared<FlatModel>(model)) {
        model_->pool = std::make_shared<ExpressionPool>(*model.pool);
        model_->events = {};
        events_ = model.events;
    }

    Outcome<HybridModel> run() {
        findSlots();
        splitEquations();
        if (!faults_.empty()) return faults_;
        match();
        if (!faults_.empty()) return faults_;
        rewriteContinuous();
        rewriteDiscrete();
        buildProgram();
        if (!faults_.empty()) return faults_;
        finish();
        if (!faults_.empty()) return faults_;
        return std::move(out_);
    }

private:
    ExpressionPool& pool() { return *model_->pool; }
    FlatVariable& variable(VariableId id) { return model_->variables[id.value]; }

    bool isSlot(VariableId id) const { return id.value < slotOf_.size() && slotOf_[id.value] >= 0; }

    int addSlot(VariableId id) {
        slotOf_.resize(std::max<std::size_t>(slotOf_.size(), model_->variables.size()), -1);
        const int slot = static_cast<int>(out_.slots.size());
        slotOf_[id.value] = slot;
        out_.slots.push_back(variable(id).name);
        slotIds_.push_back(id);
        return slot;
    }

    VariableId addVariable(std::string name, FlatType type) {
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
    void findSlots() {
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
            if (slotOf_[of.value] >= 0)
                out_.pres.emplace_back(slotOf_[before.value], slotOf_[of.value]);
            else
                running_.emplace_back(before, of);
        }
        if (events_.initial.valid()) out_.initial = slotOf_[events_.initial.value];
        if (events_.terminal.valid()) out_.terminal = slotOf_[events_.terminal.value];
    }

    std::optional<VariableId> lone(ExpressionId id) {
        const ExpressionNode& node = pool()[id];
        if (node.operation != Variable) return std::nullopt;
        return node.variable;
    }
    bool isUnknownSlot(std::optional<VariableId> id) { return id && isSlot(*id) && !isKnown_[id->value]; }
    bool isContinuousVariable(std::optional<VariableId> id) {
        return id && !isSlot(*id) && variable(*id).variability == FlatVariability::Continuous;
    }
    /// Of a type that changes at events, as far as the expression tells.
    bool isDiscreteTyped(std::optional<VariableId> id) { return id && variable(*id).type != FlatType::Real; }

    struct DiscreteEquation {
        FlatEquation equation;
        std::vector<std::pair<VariableId, ExpressionId>> ways;  // variable := expression
    };

    void splitEquations() {
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
        std::vector<FlatEquation> initial;
        for (const FlatEquation& e : model_->initialEquations) {
            if (const auto left = lone(e.left); left && isSlot(*left))
                initial_.emplace_back(*left, e.right);
            else if (const auto right = lone(e.right); right && isSlot(*right))
                initial_.emplace_back(*right, e.left);
            else
                initial.push_back(e);
        }
        model_->initialEquations = std::move(initial);
    }

    bool augment(std::size_t equation, std::vector<char>& seen) {
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

    void match() {
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

    // ------------------------------------------------------------------------------------- relations and readings

    /// Whether a quantity that runs between events is below the node.
    bool runs(ExpressionId id) {
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
                for (const ExpressionId part : {node.a, node.b, node.c})
                    result = result || (part.valid() && runs(part));
        }
        runs_[id.value] = result;
        return result;
    }

    int readingOf(ExpressionId expression) {
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
    bool isOpen(VariableId id) {
        const auto [entry, isNew] = isOpen_.try_emplace(id.value, false);
        if (!isNew) return entry->second;
        const ExpressionId binding = variable(id).binding;
        const bool result = symbolic_.count(variable(id).name) > 0 || (binding.valid() && speaksOfOpen(binding));
        return isOpen_[id.value] = result;
    }
    bool speaksOfOpen(ExpressionId id) {
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
    std::optional<double> number(ExpressionId of) {
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

    /// factor*time + rest, where the rest keeps still between events.
    struct OfTime {
        double factor{};
        ExpressionId rest;
    };
    std::optional<OfTime> ofTime(ExpressionId id) {
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

    ExpressionId relationSlot(Operation operation, ExpressionId a, ExpressionId b) {
        const auto key = std::tuple(operation, a.value, b.value);
        const auto known = relationOf_.find(key);
        if (known != relationOf_.end()) return known->second;
        const VariableId id = addVariable(fmt::format("$relation{}", out_.relations.size()), FlatType::Boolean);
        const int slot = addSlot(id);
        isKnown_.resize(model_->variables.size(), 0);
        isKnown_[id.value] = 1;
        const ExpressionId difference = pool().subtract(a, b);
        HybridModel::Relation relation{slot, readingOf(difference), operation, false, 0, -1};
        if (const auto of = ofTime(difference); of && of->factor != 0) {
            relation.isOfTime = true;
            relation.factor = of->factor;
            relationOffsets_.emplace_back(out_.relations.size(), of->rest);
        }
        out_.relations.push_back(relation);
        return relationOf_[key] = pool().variable(id);
    }

    ExpressionId wholeSlot(ExpressionId of) {
        const auto known = wholeOf_.find(of.value);
        if (known != wholeOf_.end()) return known->second;
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
        return wholeOf_[of.value] = pool().variable(id);
    }

    /// The expression with a slot for each relation of quantities that run, but within noEvent and smooth.
    ExpressionId frozen(ExpressionId id) {
        if (const auto known = frozen_.find(id.value); known != frozen_.end()) return known->second;
        const ExpressionNode node = pool()[id];
        ExpressionId result = id;
        if (node.operation == NoEvent || node.operation == Smooth) {
            result = pool().substitute(id, [&](const ExpressionNode& leaf) {
                return leaf.operation == Delay ? frozen(pool().delay(leaf.a, leaf.b)) : ExpressionId{};
            });
        } else if (!hasParts(node)) {
            result = id;
        } else if (node.operation == Delay) {
            result = delayed(node);
        } else {
            const ExpressionId a = frozen(node.a), b = node.b.valid() ? frozen(node.b) : node.b,
                               c = node.c.valid() ? frozen(node.c) : node.c;
            result = frozenOf(node, a, b, c);
        }
        return frozen_[id.value] = result;
    }

    /// An input that is fed with what the signal was.
    ExpressionId delayed(const ExpressionNode& node) {
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

    static bool hasParts(const ExpressionNode& node) { return node.a.valid(); }

    ExpressionId frozenOf(const ExpressionNode& node, ExpressionId a, ExpressionId b, ExpressionId c) {
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
            case If:
                return p.ifThenElse(a, b, c);
            case Table:
                return p.table(LookupTable(p.tables()[static_cast<std::size_t>(node.value)]), a);
            case TableDerivative:
                return p.tableDerivative(static_cast<std::size_t>(node.value), a);
            default:
                return b.valid() ? p.binary(node.operation, a, b) : p.unary(node.operation, a);
        }
    }

    void rewriteContinuous() {
        const std::size_t count = model_->equations.size();  // readings are added behind
        for (std::size_t e = 0; e < count; ++e) {
            const ExpressionId left = frozen(model_->equations[e].left), right = frozen(model_->equations[e].right);
            model_->equations[e].left = left;
            model_->equations[e].right = right;
        }
        for (FlatEquation& e : model_->initialEquations) {
            e.left = frozen(e.left);
            e.right = frozen(e.right);
        }
    }

    void rewriteDiscrete() {
        for (const auto& [id, equation] : equationOf_)
            for (const auto& [target, value] : discrete_[equation].ways)
                if (target.value == id) values_[id] = frozen(value);
        for (auto& [id, value] : initial_) value = frozen(value);
        for (const auto& [before, of] : running_)
            out_.leftLimits.emplace_back(slotOf_[before.value], readingOf(pool().variable(of)));
        for (FlatEvents::Reinit& reinit : events_.reinits) {
            reinit.condition = frozen(reinit.condition);
            reinit.value = frozen(reinit.value);
        }
        for (FlatEvents::Check& check : events_.checks) check.condition = frozen(check.condition);
        for (FlatEvents::Subscript& subscript : events_.subscripts) subscript.index = frozen(subscript.index);
    }

    // --------------------------------------------------------------------------------------------- the program

    int step(ExpressionId id) {
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

    int append(const DiscreteProgram::Step& made) {
        out_.program.steps.push_back(made);
        return static_cast<int>(out_.program.steps.size()) - 1;
    }

    void buildProgram() {
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
            out_.reinits.push_back({step(reinit.condition), step(reinit.value),
                                    target ? variable(*target).name : std::string(), reinit.span});
        }
        for (const FlatEvents::Check& check : events_.checks)
            out_.checks.push_back(
                {step(check.condition), check.message, check.isWarning, check.isTerminate, check.span});
        for (const FlatEvents::Sample& sample : events_.samples)
            out_.samples.push_back({slotOf_[sample.flag.value], step(sample.start), step(sample.interval),
                                    variable(sample.flag).declared});
        for (const FlatEvents::Subscript& subscript : events_.subscripts)
            out_.subscripts.push_back({step(subscript.index), subscript.extent, subscript.span});
        out_.program.tables = pool().tables();
    }

    /// Slots become parameters that keep their names, readings the only outputs.
    void finish() {
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

    std::shared_ptr<const FlatModel> outside() {
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
            seen->equations.push_back(
                {pool().variable(id), pool().variable(slotIds_[slot]), shown.declared, {}, false});
        }
        return seen;
    }

    double startOf(const FlatVariable& v) {
        const double value = pool().evaluate(v.start, [&](const ExpressionNode& leaf) {
            return leaf.operation == Variable ? model_->parameterValue(leaf.variable).value_or(0) : 0;
        });
        return std::isfinite(value) ? value : 0;
    }

    Signals signals_;
    std::set<std::string> symbolic_;
    std::map<std::uint32_t, bool> isOpen_;  // by parameter
    std::shared_ptr<FlatModel> model_;
    FlatEvents events_;
    HybridModel out_;
    Diagnostics faults_;
    std::vector<int> slotOf_;    // by variable; -1: none
    std::vector<char> isKnown_;  // by variable: a slot that no equation sets
    std::vector<VariableId> slotIds_, readingIds_;
    std::vector<std::pair<VariableId, VariableId>> running_;  // pre(x) and x, which is no slot
    std::vector<DiscreteEquation> discrete_;
    std::vector<std::pair<VariableId, ExpressionId>> initial_;
    std::map<std::uint32_t, std::size_t> equationOf_;  // by variable
    std::map<std::uint32_t, ExpressionId> values_;     // by variable: what sets it
    std::map<std::uint32_t, bool> runs_;
    std::map<std::uint32_t, ExpressionId> frozen_;
    std::map<std::uint32_t, int> readings_, stepOf_;
    std::map<std::tuple<Operation, std::uint32_t, std::uint32_t>, ExpressionId> relationOf_;
    std::map<std::uint32_t, ExpressionId> wholeOf_;
    std::vector<std::pair<std::size_t, ExpressionId>> relationOffsets_, wholeOffsets_;
    std::set<std::uint32_t> open_, delayed_;
};

}  // namespace

void DiscreteProgram::run(const std::vector<double>& slots, const std::vector<double>& readings, double time,
                          std::vector<double>& values) const {
    values.resize(steps.size());
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const Step& s = steps[i];
        const auto at = [&](int step) { return values[static_cast<std::size_t>(step)]; };
        switch (s.operation) {
            case Constant:
                values[i] = s.value;
                break;
            case Variable:
                values[i] = s.slot >= 0 ? slots[static_cast<std::size_t>(s.slot)]
                                        : readings[static_cast<std::size_t>(s.reading)];
                break;
            case Time:
                values[i] = time;
                break;
            case If:
                values[i] = at(s.a) != 0 ? at(s.b) : at(s.c);
                break;
            case Table:
                values[i] = tables[static_cast<std::size_t>(s.value)].value(at(s.a));
                break;
            case TableDerivative:
                values[i] = tables[static_cast<std::size_t>(s.value)].derivative(at(s.a));
                break;
            default:
                values[i] = apply(s.operation, at(s.a), s.b >= 0 ? at(s.b) : 0);
        }
    }
}

namespace {

/// How the result of an operation on numbers moves with them: by a small change of both, which is exact to the root of
/// the rounding; what compares or counts does not move.
double movementOf(Operation operation, double a, double b, double da, double db) {
    switch (operation) {
        case Less:
        case LessEqual:
        case Greater:
        case GreaterEqual:
        case Equal:
        case NotEqual:
        case Not:
        case And:
        case Or:
        case Floor:
        case Ceil:
        case Sign:
        case Div:
            return 0;
        default: {
            if (da == 0 && db == 0) return 0;
            constexpr double small = 1e-6;
            const double size = std::max({std::fabs(a), std::fabs(b), 1e-3});
            const double h = small * size / std::max(std::fabs(da), std::fabs(db));
            return (apply(operation, a + h * da, b + h * db) - apply(operation, a - h * da, b - h * db)) / (2 * h);
        }
    }
}

}  // namespace

void DiscreteProgram::runTangents(const std::vector<double>& values, const std::vector<double>& slots,
                                  const std::vector<double>& readings, const std::vector<double>& time,
                                  std::vector<double>& tangents) const {
    const std::size_t K = time.size();
    tangents.assign(steps.size() * K, 0);
    const auto at = [&](int step) { return step >= 0 ? values[static_cast<std::size_t>(step)] : 0; };
    const auto of = [&](int step, std::size_t k) {
        return step >= 0 ? tangents[static_cast<std::size_t>(step) * K + k] : 0;
    };
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const Step& s = steps[i];
        for (std::size_t k = 0; k < K; ++k) {
            double& to = tangents[i * K + k];
            if (s.operation == Constant)
                to = 0;
            else if (s.operation == Variable)
                to = s.slot >= 0 ? slots[static_cast<std::size_t>(s.slot) * K + k]
                                 : readings[static_cast<std::size_t>(s.reading) * K + k];
            else if (s.operation == Time)
                to = time[k];
            else if (s.operation == If)
                to = at(s.a) != 0 ? of(s.b, k) : of(s.c, k);
            else if (s.operation == Table)
                to = tables[static_cast<std::size_t>(s.value)].derivative(at(s.a)) * of(s.a, k);
            else if (s.operation == TableDerivative)
                to = 0;
            else
                to = movementOf(s.operation, at(s.a), at(s.b), of(s.a, k), of(s.b, k));
        }
    }
}

Outcome<HybridModel> partition(const FlatModel& model, Signals signals, const std::vector<std::string>& symbolic) {
    return guardedOutcome([&] { return Partition(model, signals, symbolic).run(); });
}

}  // namespace analogon
