#include "core/flat/events.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/flat/instantiator.hpp"
#include "core/flat/refused_construct.hpp"

namespace analogon {

using ExpressionKind = syntax::Expression::Kind;
using Kind = syntax::Equation::Kind;

namespace {

void collectVariables(const Instance& instance, std::vector<VariableId>& found) {
    for (const Element& element : instance.elements) {
        for (std::uint32_t k = 0; element.isVariable() && element.firstVariable.valid() && k < element.count(); ++k)
            found.push_back({element.firstVariable.value + k});
        for (const Instance* item : element.items) collectVariables(*item, found);
    }
}

void collectScalars(const Value& value, std::vector<ExpressionId>& found) {
    if (!value.isRecord()) {
        found.insert(found.end(), value.elements.begin(), value.elements.end());
        return;
    }
    for (const auto& [name, member] : value.members) collectScalars(member, found);
}

}  // namespace

std::vector<VariableId> variablesOf(const Slice& slice) {
    std::vector<VariableId> found = slice.variables;
    for (const Instance* instance : slice.instances) collectVariables(*instance, found);
    return found;
}

std::vector<ScalarValue> scalarsOf(Flattening& work, const Slice& slice, const Value& value, const Span& span) {
    const std::vector<VariableId> variables = variablesOf(slice);
    std::vector<ExpressionId> expressions;
    collectScalars(value, expressions);
    const bool fits = variables.size() == expressions.size() && value.dimensions == slice.dimensions &&
                      (slice.instances.size() <= 1 || !value.isRecord());
    if (!fits) {
        work.messages.error(phrase("{} cannot be assigned to '{}'", typeText(value), span.text()), span);
        return {};
    }
    std::vector<ScalarValue> result;
    for (std::size_t i = 0; i < variables.size(); ++i) result.emplace_back(variables[i], expressions[i]);
    return result;
}

std::vector<std::size_t> elementOffsets(const std::vector<std::vector<int>>& lists,
                                        const std::vector<int>& dimensions) {
    std::vector<std::size_t> result{0};
    for (std::size_t d = 0; d < dimensions.size(); ++d) {
        std::vector<std::size_t> next;
        next.reserve(result.size() * lists[d].size());
        for (std::size_t base : result)
            for (int i : lists[d])
                next.push_back(base * static_cast<std::size_t>(dimensions[d]) + static_cast<std::size_t>(i));
        result = std::move(next);
    }
    return result;
}

void Events::refuse(const Text& message, const Span& span, const Text& hint) {
    if (whens_ > 0) return;  // of a when equation that says it is one is enough
    Diagnostics& all = work_.model.events.refusals;
    if (all.size() < Messages::most) all.push_back(error(message, span, hint));
}

/// A quantity that no declaration names; one that is known comes from outside of the equations.
VariableId Events::newVariable(const std::string& name, FlatType type, bool isKnown, const Span& span) {
    const VariableId id{static_cast<std::uint32_t>(work_.model.variables.size())};
    FlatVariable variable;
    variable.name = name;
    variable.type = type;
    variable.isDiscrete = true;
    variable.isProtected = true;
    variable.causality = isKnown ? FlatCausality::Input : FlatCausality::Local;
    variable.declared = span;
    work_.model.byName.emplace(name, id);
    work_.model.variables.push_back(std::move(variable));
    VariableRecord record;
    record.owner = work_.components.front();
    record.position = 0xfffffffeu;  // of no declaration
    record.causality = syntax::Causality::None;
    record.isBound = true;
    work_.records.push_back(record);
    return id;
}

ExpressionId Events::pre(VariableId id) {
    if (!work_.isContinuous(id)) return work_.pool.variable(id);
    const auto [entry, isNew] = pres_.try_emplace(id);
    if (isNew) {
        const FlatVariable of = work_.variable(id);
        entry->second = newVariable(fmt::format("pre({})", of.name), of.type, true, of.declared);
        FlatVariable& made = work_.model.variables[entry->second.value];
        made.start = of.start;
        made.unit = of.unit;
        work_.model.events.pres.emplace_back(entry->second, id);
    }
    return work_.pool.variable(entry->second);
}

ExpressionId Events::flag(VariableId& variable, const char* name) {
    if (!variable.valid()) variable = newVariable(name, FlatType::Boolean, true, {});
    return work_.pool.variable(variable);
}

std::optional<Value> Events::call(const syntax::Expression& call, const Scope& scope, bool& isKnown) {
    const std::string name = call.name.text();
    isKnown = true;
    if (name == "pre" || name == "edge" || name == "change") return memory(call, scope, name);
    if (name == "sample") return sample(call, scope);
    if (name == "initial" && call.operands.empty())
        return Value::scalar(FlatType::Boolean, flag(work_.model.events.initial, "initial()"));
    if (name == "terminal" && call.operands.empty())
        return Value::scalar(FlatType::Boolean, flag(work_.model.events.terminal, "terminal()"));
    isKnown = false;
    return std::nullopt;
}

std::optional<Value> Events::memory(const syntax::Expression& call, const Scope& scope, const std::string& name) {
    const bool isReference = call.operands.size() == 1 && call.named.empty() &&
                             call.operands[0].kind == ExpressionKind::Reference && scope.instance;
    if (!isReference) {
        work_.messages.error(phrase("the function '{}' is not supported", name),
                             call.name.span.valid() ? call.name.span : call.span);
        return std::nullopt;
    }
    const auto slice = work_.translator->resolve(call.operands[0].name, scope);
    if (!slice) return std::nullopt;
    if (!slice->instances.empty() || !slice->element || slice->element->type.builtin == FlatType::String) {
        work_.messages.error(phrase("'{}' needs the name of a variable", name), call.span);
        return std::nullopt;
    }
    refuse(phrase("the function '{}' is not supported", name), call.name.span.valid() ? call.name.span : call.span);
    Value value;
    value.type = name == "pre" ? slice->element->type.builtin : FlatType::Boolean;
    if (name == "pre") value.enumeration = slice->element->type.enumerationName();
    value.dimensions = slice->dimensions;
    ExpressionPool& pool = work_.pool;
    for (const VariableId id : slice->variables) {
        const ExpressionId before = pre(id), now = pool.variable(id);
        value.elements.push_back(name == "pre"    ? before
                                 : name == "edge" ? pool.binary(Operation::And, now, pool.unary(Operation::Not, before))
                                                  : pool.binary(Operation::NotEqual, now, before));
    }
    return value;
}

/// Of parameters only, those that the start finds included.
bool Events::staysTheSame(ExpressionId id) const {
    bool stays = true;
    work_.pool.evaluate(id, [&](const ExpressionNode& leaf) {
        if (leaf.operation != Operation::Variable ||
            (work_.isContinuous(leaf.variable) && !work_.variable(leaf.variable).isFoundAtStart))
            stays = false;
        return 0.0;
    });
    return stays;
}

std::optional<Value> Events::sample(const syntax::Expression& call, const Scope& scope) {
    std::vector<ExpressionId> arguments;
    for (const syntax::Expression& operand : call.operands) {
        const auto value = work_.translator->translate(operand, scope);
        if (!value) return std::nullopt;
        if (value->isNumeric() && value->isScalar() && staysTheSame(value->elements[0]))
            arguments.push_back(value->elements[0]);
    }
    if (call.operands.size() == 1 && call.named.empty()) {  // sample(u), by the clock of its surroundings
        tellRefused(work_.messages, "sample", call.name.span);
        return std::nullopt;
    }
    if (arguments.size() != 2 || !call.named.empty()) {
        work_.messages.error(phrase("'sample' takes a start and an interval that are known before the simulation"),
                             call.span);
        return std::nullopt;
    }
    refuse(phrase("the function '{}' is not supported", "sample"), call.name.span.valid() ? call.name.span : call.span);
    const auto [entry, isNew] = samples_.try_emplace({arguments[0].value, arguments[1].value});
    if (isNew) {
        entry->second = newVariable(fmt::format("$sample{}", ++count_), FlatType::Boolean, true, call.span);
        work_.model.events.samples.push_back({entry->second, arguments[0], arguments[1]});
    }
    return Value::scalar(FlatType::Boolean, work_.pool.variable(entry->second));
}

/// initial() and sample() are true for one evaluation; of anything else it counts when it becomes true, and not at the
/// start (section 8.6).
std::optional<ExpressionId> Events::activation(const syntax::Expression& condition, const Scope& scope) {
    ExpressionPool& pool = work_.pool;
    const auto value = work_.translator->translate(condition, scope);
    if (!value) return std::nullopt;
    if (value->type != FlatType::Boolean || value->dimensions.size() > 1) {
        work_.messages.error(phrase("the condition after 'when' must be Boolean, not {}", typeText(*value)),
                             condition.span);
        return std::nullopt;
    }
    const ExpressionId atStart = flag(work_.model.events.initial, "initial()");
    ExpressionId any = pool.constant(0);
    for (const ExpressionId each : value->elements) {
        const ExpressionNode node = pool[each];
        const bool isVariable = node.operation == Operation::Variable;
        const bool isSample = isVariable && std::any_of(samples_.begin(), samples_.end(),
                                                        [&](const auto& s) { return s.second == node.variable; });
        if (each == atStart || isSample || pool.isConstant(each)) {
            if (!pool.isConstant(each)) any = pool.binary(Operation::Or, any, each);
            continue;
        }
        VariableId variable = node.variable;
        if (!isVariable || !work_.isContinuous(variable) ||
            work_.variable(variable).causality == FlatCausality::Input) {
            const auto [entry, isNew] = conditions_.try_emplace(each.value);
            if (isNew) {
                entry->second = newVariable(fmt::format("$when{}", ++count_), FlatType::Boolean, false, condition.span);
                work_.model.equations.push_back(
                    {pool.variable(entry->second), each, condition.span, scope.instance->name, false, true});
            }
            variable = entry->second;
        }
        const ExpressionId rises =
            pool.binary(Operation::And, pool.variable(variable), pool.unary(Operation::Not, pre(variable)));
        any = pool.binary(Operation::Or, any, pool.binary(Operation::And, rises, pool.unary(Operation::Not, atStart)));
    }
    return any;
}

void Events::when(const syntax::Equation& equation, const Scope& scope) {
    refuse(phrase("when equations are not supported"), equation.keyword,
           phrase("a relation outside noEvent already is an event: write the equation with if"));
    struct Inside {
        explicit Inside(int& depth) : depth_(depth) { ++depth_; }
        ~Inside() { --depth_; }
        int& depth_;
    };
    const Inside inside(whens_);
    ExpressionPool& pool = work_.pool;
    std::vector<ExpressionId> active;
    std::vector<std::vector<ScalarValue>> sets;
    ExpressionId earlier = pool.constant(0);
    for (const auto& branch : equation.branches) {
        const auto condition = activation(*branch.condition, scope);
        if (!condition) return;
        active.push_back(*condition);
        const ExpressionId guard = pool.binary(Operation::And, *condition, pool.unary(Operation::Not, earlier));
        if (!body(branch.body, guard, scope, sets.emplace_back())) return;
        earlier = pool.binary(Operation::Or, earlier, *condition);
    }
    std::vector<VariableId> order;
    for (const auto& set : sets)
        for (const auto& [id, value] : set)
            if (std::find(order.begin(), order.end(), id) == order.end()) order.push_back(id);
    for (const VariableId id : order) {
        work_.model.variables[id.value].isDiscrete = true;
        ExpressionId value = pre(id);
        for (std::size_t b = sets.size(); b-- > 0;)
            for (const auto& [variable, expression] : sets[b])
                if (variable == id) value = pool.ifThenElse(active[b], expression, value);
        work_.model.equations.push_back({pool.variable(id), value, equation.span, scope.instance->name, false, true});
        ++scope.instance->component().equations;
    }
}

bool Events::body(const std::vector<syntax::Equation>& equations, ExpressionId guard, const Scope& scope,
                  std::vector<ScalarValue>& set) {
    for (const syntax::Equation& equation : equations) {
        bool isDone = true;
        if (equation.kind == Kind::Equality)
            isDone = bodyEquality(equation, scope, set);
        else if (equation.kind == Kind::If)
            isDone = bodyConditional(equation, 0, guard, scope, set);
        else if (equation.kind == Kind::For)
            isDone = bodyLoop(equation, 0, guard, scope, set);
        else if (equation.kind == Kind::Call)
            isDone = action(equation, guard, scope);
        else {
            work_.messages.error(phrase("'{}' cannot stand within 'when'", equation.keyword.text()), equation.span);
            return false;
        }
        if (!isDone) return false;
    }
    return true;
}

bool Events::bodyEquality(const syntax::Equation& equation, const Scope& scope, std::vector<ScalarValue>& set) {
    const auto take = [&](const syntax::Expression& target, const Value& value) {
        if (target.kind != ExpressionKind::Reference) {
            work_.messages.error(phrase("an equation within 'when' begins with the variable that it sets"),
                                 equation.left.span);
            return false;
        }
        const auto slice = work_.translator->resolve(target.name, scope);
        if (!slice) return false;
        const auto scalars = scalarsOf(work_, *slice, value, target.span);
        set.insert(set.end(), scalars.begin(), scalars.end());
        return !scalars.empty() || value.size() == 0;
    };
    if (equation.left.kind == ExpressionKind::Tuple) {
        const auto results = work_.translator->outputsOf(equation.right, scope);
        if (!results) return false;
        for (std::size_t i = 0; i < equation.left.operands.size() && i < results->size(); ++i)
            if (equation.left.operands[i].kind != ExpressionKind::Empty &&
                !take(equation.left.operands[i], (*results)[i]))
                return false;
        return true;
    }
    const auto value = work_.translator->translate(equation.right, scope);
    return value && take(equation.left, *value);
}

bool Events::bodyConditional(const syntax::Equation& equation, std::size_t branch, ExpressionId guard,
                             const Scope& scope, std::vector<ScalarValue>& set) {
    if (branch == equation.branches.size()) return true;
    const auto& here = equation.branches[branch];
    if (!here.condition) return body(here.body, guard, scope, set);
    const auto condition = work_.translator->translate(*here.condition, scope);
    if (!condition) return false;
    if (condition->type != FlatType::Boolean || !condition->isScalar()) {
        work_.messages.error(phrase("the condition after 'if' must be Boolean, not {}", typeText(*condition)),
                             here.condition->span);
        return false;
    }
    ExpressionPool& pool = work_.pool;
    const ExpressionId test = condition->elements[0];
    if (const auto known = work_.translator->knownNow(test))
        return *known != 0 ? body(here.body, guard, scope, set)
                           : bodyConditional(equation, branch + 1, guard, scope, set);
    std::vector<ScalarValue> then, otherwise;
    if (!body(here.body, pool.binary(Operation::And, guard, test), scope, then)) return false;
    if (!bodyConditional(equation, branch + 1, pool.binary(Operation::And, guard, pool.unary(Operation::Not, test)),
                         scope, otherwise))
        return false;
    const auto valueIn = [&](const std::vector<ScalarValue>& list, VariableId id) {
        for (const auto& [variable, expression] : list)
            if (variable == id) return expression;
        return pre(id);
    };
    std::set<VariableId> all;
    for (const auto& [id, value] : then) all.insert(id);
    for (const auto& [id, value] : otherwise) all.insert(id);
    for (const VariableId id : all)
        set.emplace_back(id, pool.ifThenElse(test, valueIn(then, id), valueIn(otherwise, id)));
    return true;
}

bool Events::bodyLoop(const syntax::Equation& equation, std::size_t iterator, ExpressionId guard, const Scope& scope,
                      std::vector<ScalarValue>& set) {
    if (iterator == equation.iterators.size()) return body(equation.body, guard, scope, set);
    const auto values = work_.translator->rangeOf(equation, iterator, scope);
    if (!values) return false;
    for (int k = 1; k <= values->dimensions[0]; ++k) {
        work_.translator->pushIterator(equation.iterators[iterator].name, values->part(k));
        const bool isDone = bodyLoop(equation, iterator + 1, guard, scope, set);
        work_.translator->popIterator();
        if (!isDone) return false;
    }
    return true;
}

bool Events::action(const syntax::Equation& statement, ExpressionId guard, const Scope& scope) {
    const syntax::Expression& call = statement.left;
    const std::string name = call.name.text();
    if (name == "assert") return check(call, guard, scope, false);
    if (name == "terminate") return check(call, guard, scope, true);
    if (name == "reinit") return reinit(call, guard, scope);
    const LibraryClass* definition = work_.lookup(call.name, scope.lexical);
    if (definition && definition->qualifiedName == "Modelica.Utilities.Streams.print") return true;  // for people
    return work_.translator->outputsOf(call, scope).has_value();
}

bool Events::reinit(const syntax::Expression& call, ExpressionId guard, const Scope& scope) {
    const bool isSound =
        call.operands.size() == 2 && call.operands[0].kind == ExpressionKind::Reference && scope.instance;
    const auto slice = isSound ? work_.translator->resolve(call.operands[0].name, scope) : std::nullopt;
    const auto value = slice ? work_.translator->translate(call.operands[1], scope) : std::nullopt;
    if (!value || !slice->instances.empty() || value->elements.size() != slice->variables.size()) {
        work_.messages.error(phrase("'reinit' needs a variable and its new value"), call.span);
        return false;
    }
    for (std::size_t i = 0; i < slice->variables.size(); ++i) {
        FlatVariable& variable = work_.model.variables[slice->variables[i].value];
        if (variable.stateSelect != StateSelect::Always) variable.stateSelect = StateSelect::Always;
        work_.model.events.reinits.push_back(
            {guard, work_.pool.variable(slice->variables[i]), value->elements[i], call.span});
    }
    return true;
}

/// The condition of an assertion that cannot be judged now, with what it says.
bool Events::check(const syntax::Expression& call, ExpressionId guard, const Scope& scope, bool isTerminate) {
    ExpressionPool& pool = work_.pool;
    const std::size_t textAt = isTerminate ? 0 : 1;
    std::optional<Value> condition = Value::scalar(FlatType::Boolean, guard);
    if (!isTerminate && !call.operands.empty()) condition = work_.translator->translate(call.operands[0], scope);
    if (!condition) return false;
    bool isWarning = false;
    const syntax::Expression* level = call.operands.size() > 2 ? &call.operands[2] : nullptr;
    for (const syntax::NamedArgument& argument : call.named)
        if (argument.name == "level") level = &argument.value;
    if (level && !isTerminate) {
        const auto said = work_.translator->translate(*level, scope);
        const auto number = said && said->elements.size() == 1
                                ? work_.translator->constantNumber(said->elements[0], true)
                                : std::nullopt;
        isWarning = number && *number == 2;
    }
    const auto text =
        call.operands.size() > textAt ? work_.translator->translate(call.operands[textAt], scope) : std::nullopt;
    const bool isSound = text && text->type == FlatType::String && text->isScalar() &&
                         condition->type == FlatType::Boolean && condition->isScalar();
    if (!isSound) {
        work_.messages.error(phrase("'{}' needs a Boolean condition and a text", call.name.text()), call.span);
        return false;
    }
    const ExpressionId holds =
        isTerminate ? guard : pool.binary(Operation::Or, pool.unary(Operation::Not, guard), condition->elements[0]);
    const bool isConstant = pool.isConstant(holds);
    const bool mayBeKnown = !isTerminate && (isConstant || work_.translator->isParametric(holds));
    if (const auto known = mayBeKnown ? work_.translator->constantNumber(holds, false) : std::nullopt) {
        if (*known == 0 && !isWarning) {
            work_.messages.error(phrase("{}", text->texts[0]), call.span,
                                 phrase("the condition of 'assert' does not hold"));
            return false;
        }
        if (isConstant) return true;  // a parameter may come to another value in a fit
    }
    work_.model.events.checks.push_back({holds, text->texts[0], isWarning, isTerminate, call.span});
    return true;
}

}  // namespace analogon
