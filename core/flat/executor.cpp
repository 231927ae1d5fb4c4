#include "core/flat/executor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "core/flat/binder.hpp"
#include "core/flat/class_rules.hpp"
#include "core/flat/events.hpp"
#include "core/flat/external_functions.hpp"
#include "core/flat/instantiator.hpp"
#include "core/flat/translator.hpp"

namespace analogon {
namespace {

using ExpressionKind = syntax::Expression::Kind;
using StatementKind = syntax::Equation::Kind;
using Restriction = syntax::ClassDefinition::Restriction;

constexpr int deepestCall = 40;
constexpr int deepestType = 40;
constexpr std::size_t mostTurns = 1'000'000;

}  // namespace

/// Elements of a function and of what it extends; a short class gives arguments of its own.
bool Executor::signatureOf(const LibraryClass& function, Signature& signature, std::map<std::string, Input>& preset,
                           int depth) {
    const syntax::ClassDefinition& tree = *function.definition;
    if (depth > deepestType) return false;
    work_.rules->check(function);
    work_.keepSource(tree);
    for (const LibraryClass* base : work_.library.bases(function))
        if (!signatureOf(*base, signature, preset, depth + 1)) return false;
    const auto take = [&](const std::vector<syntax::Modification>& modifications) {
        for (const syntax::Modification& m : modifications)
            if (m.value && m.name.parts.size() == 1) {
                const auto made = std::make_shared<syntax::Component>();
                made->binding = m.value;
                made_.push_back(made);
                preset[m.name.parts.front().identifier] = {made.get(), &function};
            }
    };
    take(tree.shortModifications);
    for (const syntax::Extends& base : tree.bases) take(base.modifications);
    for (const syntax::Component& component : tree.components) {
        const Input input{&component, &function};
        const auto same = std::find_if(signature.elements.begin(), signature.elements.end(),
                                       [&](const Input& known) { return known.declaration->name == component.name; });
        if (same == signature.elements.end())
            signature.elements.push_back(input);
        else
            *same = input;
    }
    if (!tree.algorithmSections.empty() || tree.external) {
        signature.body = &tree;
        signature.lexical = &function;
    }
    return true;
}

std::optional<std::vector<Value>> Executor::call(const LibraryClass& function, const syntax::Expression& call,
                                                 const Scope& caller, const Value* partly) {
    Signature signature;
    std::map<std::string, Input> preset;
    const Span& span = call.name.span.valid() ? call.name.span : call.span;
    if (!signatureOf(function, signature, preset, 0) || !signature.body || !function.definition->derivativeOf.empty()) {
        work_.messages.error(phrase("the function '{}' has no algorithm that could be run", function.qualifiedName),
                             span);
        return std::nullopt;
    }
    if (function.definition->isPartial) {
        work_.messages.error(phrase("the function '{}' is partial and cannot be called", function.qualifiedName), span,
                             phrase("call a function that extends it"));
        return std::nullopt;
    }
    std::vector<std::pair<std::string, Value>> given;
    if (partly) given = partly->members;
    std::size_t position = 0;
    const auto take = [&](const std::string& name, const syntax::Expression& expression) {
        auto value = functionValue(expression, caller);
        if (!value) value = work_.translator->translate(expression, caller);
        if (!value) return false;
        given.emplace_back(name, std::move(*value));
        return true;
    };
    for (const Input& element : signature.elements) {
        if (element.declaration->causality != syntax::Causality::Input || position >= call.operands.size()) continue;
        if (partly && partly->member(element.declaration->name)) continue;
        if (!take(element.declaration->name, call.operands[position++])) return std::nullopt;
    }
    if (position < call.operands.size() || !call.iterators.empty()) {
        work_.messages.error(phrase("'{}' takes {} arguments, not {}", function.qualifiedName, position,
                                    call.operands.size() + call.named.size()),
                             span);
        return std::nullopt;
    }
    for (const syntax::NamedArgument& argument : call.named) {
        const bool isInput = std::any_of(signature.elements.begin(), signature.elements.end(), [&](const Input& e) {
            return e.declaration->name == argument.name && e.declaration->causality == syntax::Causality::Input;
        });
        const bool isGiven =
            std::any_of(given.begin(), given.end(), [&](const auto& g) { return g.first == argument.name; });
        if (!isInput || isGiven) {
            work_.messages.error(phrase("'{}' has no free argument '{}'", function.qualifiedName, argument.name),
                                 argument.span);
            return std::nullopt;
        }
        if (!take(argument.name, argument.value)) return std::nullopt;
    }
    return each(signature, std::move(given), preset, call);
}

std::optional<std::vector<Value>> Executor::run(const Signature& signature,
                                                std::vector<std::pair<std::string, Value>> given,
                                                const std::map<std::string, Input>& preset,
                                                const syntax::Expression& call) {
    Translator& translator = *work_.translator;
    if (translator.callDepth_ >= deepestCall) {
        work_.messages.error(phrase("functions call each other more than {} deep", deepestCall), call.span);
        return std::nullopt;
    }
    ++translator.callDepth_;
    std::vector<std::pair<std::string, Value>> outside;
    outside.swap(translator.iterators_);
    const auto leave = [&](auto result) {
        translator.iterators_.swap(outside);
        --translator.callDepth_;
        return result;
    };
    const std::optional<std::vector<Value>> nothing;
    const auto findGiven = [&](const std::string& name) {
        return std::find_if(given.begin(), given.end(), [&](const auto& g) { return g.first == name; });
    };
    for (const Input& element : signature.elements) {
        const syntax::Component& declaration = *element.declaration;
        const auto argument = findGiven(declaration.name);
        std::optional<Value> value;
        if (argument != given.end()) {
            value = fitted(std::move(argument->second), element);
        } else if (const auto own = preset.find(declaration.name); own != preset.end()) {
            value = translator.translate(*own->second.declaration->binding, {nullptr, own->second.lexical});
        } else if (declaration.causality == syntax::Causality::Input && !declaration.binding) {
            work_.messages.error(phrase("the argument '{}' of '{}' is not given", declaration.name, call.name.text()),
                                 call.span);
        } else {
            value = initialValue(element, {nullptr, element.lexical});
        }
        if (!value) return leave(nothing);
        translator.iterators_.emplace_back(declaration.name, std::move(*value));
    }
    const Scope scope{nullptr, signature.lexical};
    broken_ = returned_ = {};
    guards_.clear();
    if (signature.body->external) {
        if (!callExternal(work_, *signature.body, call, scope)) return leave(nothing);
    } else {
        for (const syntax::EquationSection& section : signature.body->algorithmSections)
            if (const Flow flow = execute(section.equations, scope); flow == Flow::Failed) return leave(nothing);
    }
    std::vector<Value> results;
    for (const Input& element : signature.elements)
        if (element.declaration->causality == syntax::Causality::Output)
            for (const auto& [name, value] : translator.iterators_)
                if (name == element.declaration->name) {
                    results.push_back(value);
                    break;
                }
    return leave(std::optional(std::move(results)));
}

/// An Integer argument of a Real input is Real.
std::optional<Value> Executor::fitted(Value value, const Input& element) {
    if (value.type == FlatType::Integer && value.enumeration.empty() && !value.isRecord() && !value.isObject() &&
        builtinType(element.declaration->type) == FlatType::Real)
        value.type = FlatType::Real;
    return value;
}

std::optional<Value> Executor::initialValue(const Input& element, const Scope& scope) {
    const syntax::Component& declaration = *element.declaration;
    if (declaration.binding) {
        auto value = work_.translator->translate(*declaration.binding, scope);
        return value ? fitted(std::move(*value), element) : value;
    }
    std::vector<int> dimensions;
    for (const syntax::Expression& size : declaration.dimensions) {
        if (size.kind == ExpressionKind::Colon) {
            dimensions.push_back(0);
            continue;
        }
        const auto extent =
            work_.translator->constantInteger(size, scope, phrase("the size of '{}'", declaration.name));
        if (!extent) return std::nullopt;
        dimensions.push_back(std::max(0, *extent));
    }
    if (!work_.translator->spend(elementCount(dimensions), declaration.nameSpan)) return std::nullopt;
    auto value = emptyValue(declaration.type, element.lexical, std::move(dimensions), 0);
    if (!value || !value->isRecord() || !value->isScalar()) return value;
    for (const syntax::Modification& modification : declaration.modifications) {
        Value* const member = modification.value ? value->member(modification.name.text()) : nullptr;
        if (!member) continue;
        auto given = work_.translator->translate(*modification.value, scope);
        if (!given) return given;
        *member = std::move(*given);
    }
    return value;
}

/// A value of this type that nothing was assigned to: not a number, false, an empty text.
std::optional<Value> Executor::emptyValue(const syntax::Name& type, const LibraryClass* lexical,
                                          std::vector<int> dimensions, int depth) {
    Value value;
    value.dimensions = std::move(dimensions);
    const std::size_t count = elementCount(value.dimensions);
    if (const auto builtin = builtinType(type)) {
        value.type = *builtin;
        if (*builtin == FlatType::String)
            value.texts.assign(count, {});
        else
            value.elements.assign(
                count, work_.pool.constant(*builtin == FlatType::Real ? std::numeric_limits<double>::quiet_NaN() : 0));
        return value;
    }
    const LibraryClass* found = depth < deepestType ? work_.lookup(type, lexical) : nullptr;
    if (!found) {
        work_.lacksClass = true;
        work_.messages.error(phrase("the class '{}' is not known in '{}'", type.text(),
                                    lexical ? lexical->qualifiedName : std::string()),
                             type.span);
        return std::nullopt;
    }
    const syntax::ClassDefinition& tree = *found->definition;
    if (tree.isEnumeration) {
        value.type = FlatType::Integer;
        value.enumeration = found->qualifiedName;
        value.elements.assign(count, work_.pool.constant(1));
        return value;
    }
    const LibraryClass* outside = work_.library.find(found->scope);
    if (tree.isShort) {
        for (const syntax::Expression& size : tree.shortDimensions) {
            const auto extent =
                work_.translator->constantInteger(size, {nullptr, outside}, phrase("the size of '{}'", tree.name));
            if (!extent) return std::nullopt;
            value.dimensions.push_back(*extent);
        }
        return emptyValue(tree.shortBase, found, std::move(value.dimensions), depth + 1);
    }
    if (tree.restriction == Restriction::Type && tree.bases.size() == 1)
        return emptyValue(tree.bases[0].base, found, std::move(value.dimensions), depth + 1);
    value.record = found->qualifiedName;
    std::vector<const LibraryClass*> path{found};
    for (std::size_t i = 0; i < path.size() && i < 100; ++i)
        for (const LibraryClass* base : work_.library.bases(*path[i])) path.push_back(base);
    for (auto one = path.rbegin(); one != path.rend(); ++one)
        for (const syntax::Component& component : (*one)->definition->components) {
            std::vector<int> sizes = value.dimensions;
            for (const syntax::Expression& size : component.dimensions) {
                const auto extent = work_.translator->constantInteger(size, {nullptr, *one},
                                                                      phrase("the size of '{}'", component.name));
                if (!extent) return std::nullopt;
                sizes.push_back(*extent);
            }
            auto member = emptyValue(component.type, *one, std::move(sizes), depth + 1);
            if (!member) return std::nullopt;
            value.members.emplace_back(component.name, std::move(*member));
        }
    return value;
}

std::optional<Value> Executor::construct(const LibraryClass& record, const syntax::Expression& call,
                                         const Scope& caller) {
    Signature signature;
    std::map<std::string, Input> preset;
    if (!signatureOf(record, signature, preset, 0)) return std::nullopt;
    Value value;
    value.record = record.qualifiedName;
    std::vector<std::pair<std::string, Value>> outside;
    std::size_t position = 0;
    std::map<std::string, const syntax::Expression*> given;
    for (const Input& element : signature.elements)
        if (position < call.operands.size() && !element.declaration->isProtected)
            given[element.declaration->name] = &call.operands[position++];
    for (const syntax::NamedArgument& argument : call.named) given[argument.name] = &argument.value;
    for (const Input& element : signature.elements) {
        const std::string& name = element.declaration->name;
        std::optional<Value> member;
        if (const auto own = given.find(name); own != given.end()) {
            member = work_.translator->translate(*own->second, caller);
        } else if (const auto set = preset.find(name); set != preset.end() || element.declaration->binding) {
            // a default may use what was given before it
            std::vector<std::pair<std::string, Value>> frame = value.members;
            frame.swap(work_.translator->iterators_);
            const bool isPreset = set != preset.end();
            member = work_.translator->translate(
                isPreset ? *set->second.declaration->binding : *element.declaration->binding,
                {nullptr, isPreset ? set->second.lexical : element.lexical});
            frame.swap(work_.translator->iterators_);
        } else {
            work_.messages.error(phrase("the argument '{}' of '{}' is not given", name, record.qualifiedName),
                                 call.span);
        }
        if (!member) return std::nullopt;
        given.erase(name);
        auto kept = fitted(std::move(*member), element);
        value.members.emplace_back(name, std::move(*kept));
    }
    if (!given.empty()) {
        work_.messages.error(phrase("'{}' has no free argument '{}'", record.qualifiedName, given.begin()->first),
                             call.span);
        return std::nullopt;
    }
    return value;
}

// ------------------------------------------------------------------------------------------------- statements

Executor::Flow Executor::execute(const std::vector<Statement>& statements, const Scope& scope) {
    ExpressionPool& pool = work_.pool;
    for (const Statement& statement : statements) {
        ExpressionId gone = pool.constant(0);
        for (const ExpressionId left : {broken_, returned_})
            if (left.valid()) gone = pool.binary(Operation::Or, gone, left);
        if (pool.isConstant(gone, 0)) {
            if (const Flow flow = execute(statement, scope); flow != Flow::Next) return flow;
            continue;
        }
        // where the control has left, all stays as it is
        const Memory before = remember();
        guards_.push_back(pool.unary(Operation::Not, gone));
        const Flow flow = execute(statement, scope);
        if (flow == Flow::Failed) return flow;
        leave(flow);
        guards_.pop_back();
        if (!join(gone, before, statement.span)) return Flow::Failed;
    }
    return Flow::Next;
}

/// `break` or `return` under the conditions in force.
void Executor::leave(Flow flow) {
    if (flow == Flow::Next) return;
    ExpressionPool& pool = work_.pool;
    ExpressionId here = pool.constant(1);
    for (const ExpressionId guard : guards_) here = pool.binary(Operation::And, here, guard);
    ExpressionId& left = flow == Flow::Break ? broken_ : returned_;
    left = left.valid() ? pool.binary(Operation::Or, left, here) : here;
}

Executor::Flow Executor::execute(const Statement& statement, const Scope& scope) {
    if (!work_.translator->spend(1, statement.span)) return Flow::Failed;
    switch (statement.kind) {
        case StatementKind::Assign:
            return assign(statement, scope);
        case StatementKind::If:
            return conditional(statement, 0, scope);
        case StatementKind::For:
            return loop(statement, 0, scope);
        case StatementKind::While:
            return repeat(statement, scope);
        case StatementKind::When:
            return when(statement, scope);
        case StatementKind::Call:
            return callOf(statement, scope);
        case StatementKind::Break:
            return Flow::Break;
        case StatementKind::Return:
            return Flow::Return;
        default:
            return Flow::Failed;
    }
}

Executor::Flow Executor::assign(const Statement& statement, const Scope& scope) {
    if (statement.left.kind == ExpressionKind::Tuple) {
        const auto results = work_.translator->outputsOf(statement.right, scope);
        if (!results) return Flow::Failed;
        for (std::size_t i = 0; i < statement.left.operands.size(); ++i) {
            const syntax::Expression& target = statement.left.operands[i];
            if (target.kind == ExpressionKind::Empty) continue;
            if (i >= results->size()) {
                work_.messages.error(phrase("'{}' has {} outputs, not {}", statement.right.name.text(), results->size(),
                                            statement.left.operands.size()),
                                     statement.span);
                return Flow::Failed;
            }
            if (!store(target, (*results)[i], scope)) return Flow::Failed;
        }
        return Flow::Next;
    }
    const auto value = work_.translator->translate(statement.right, scope);
    return value && store(statement.left, *value, scope) ? Flow::Next : Flow::Failed;
}

bool Executor::store(const syntax::Expression& target, const Value& value, const Scope& scope) {
    Translator& translator = *work_.translator;
    const syntax::Name& name = target.name;
    for (auto local = translator.iterators_.rbegin(); local != translator.iterators_.rend(); ++local)
        if (local->first == name.parts.front().identifier) {
            Value copy = std::move(local->second);
            const bool isStored = storeIn(copy, name.parts, 0, value, scope, target.span);
            // the place may have moved while subscripts were read
            for (auto again = translator.iterators_.rbegin(); again != translator.iterators_.rend(); ++again)
                if (again->first == name.parts.front().identifier) {
                    again->second = std::move(copy);
                    break;
                }
            return isStored;
        }
    if (!scope.instance) {
        work_.messages.error(phrase("'{}' is not a variable of the function", name.text()), target.span);
        return false;
    }
    const auto slice = [&] {
        const Messages::Quiet quiet(work_.messages);
        return translator.resolve(name, scope);
    }();
    if (!slice) return storeWhereItRuns(target, value, scope) || (translator.resolve(name, scope), false);
    const std::vector<ScalarValue> scalars = scalarsOf(work_, *slice, value, target.span);
    if (scalars.empty() && !slice->variables.empty()) return false;
    for (const auto& [variable, expression] : scalars) translator.overlay_[variable.value] = expression;
    return true;
}

namespace {

/// One record of an array of them.
bool storeRecord(Value& array, std::size_t place, const Value& record) {
    const std::size_t places = std::max<std::size_t>(1, elementCount(array.dimensions));
    for (auto& [name, member] : array.members) {
        const Value* const from = record.member(name);
        const std::size_t count = member.elements.size() / places;
        if (!from || from->isRecord() || from->elements.size() != count || member.type == FlatType::String)
            return false;
        std::copy(from->elements.begin(), from->elements.end(),
                  member.elements.begin() + static_cast<std::ptrdiff_t>(place * count));
    }
    return !array.members.empty();
}

}  // namespace

/// Stores into a local value: `x`, `x[i]`, `r.a[2, :]`.
bool Executor::storeIn(Value& target, const std::vector<syntax::NamePart>& parts, std::size_t part, const Value& value,
                       const Scope& scope, const Span& span) {
    const syntax::NamePart& here = parts[part];
    const auto refuse = [&] {
        work_.messages.error(phrase("{} cannot be assigned to '{}'", typeText(value), span.text()), span);
        return false;
    };
    if (here.subscripts.empty() && part + 1 == parts.size()) {
        const bool isOpen = target.size() == 0 && !target.isRecord();
        const bool fits = target.dimensions.size() == value.dimensions.size() &&
                          (isOpen || target.dimensions == value.dimensions) && target.isRecord() == value.isRecord() &&
                          (target.type == FlatType::String) == (value.type == FlatType::String);
        if (!fits) return refuse();
        const FlatType type = target.type;
        target = value;
        if (type == FlatType::Real && value.type == FlatType::Integer) target.type = FlatType::Real;
        return true;
    }
    if (!here.subscripts.empty()) {
        std::vector<int> remaining;
        const bool isOne = part + 1 == parts.size() && !target.isRecord() && value.isScalar() &&
                           value.elements.size() == 1 && target.type != FlatType::String;
        const auto known = [&] {
            const Messages::Quiet quiet(work_.messages);
            return work_.translator->subscriptLists(target.dimensions, here.subscripts, scope, span, remaining);
        }();
        if (const auto meant =
                known || !isOne ? std::nullopt : elementsMeant(target.dimensions, here.subscripts, scope, span)) {
            for (std::size_t k = 0; k < meant->size(); ++k)
                target.elements[k] = work_.pool.ifThenElse((*meant)[k], value.elements[0], target.elements[k]);
            return true;
        }
        if (!known) remaining.clear();
        const auto lists =
            known ? known
                  : work_.translator->subscriptLists(target.dimensions, here.subscripts, scope, span, remaining);
        if (!lists) return false;
        std::vector<std::size_t> places = elementOffsets(*lists, target.dimensions);
        if (target.isRecord() && part + 1 == parts.size() && value.isRecord() && value.isScalar() && places.size() == 1)
            return storeRecord(target, places[0], value) || refuse();
        if (target.isRecord() || part + 1 < parts.size()) {
            if (!target.isRecord() || part + 1 >= parts.size() || places.size() != 1) return refuse();
            Value* member = target.member(parts[part + 1].identifier);
            if (!member || !parts[part + 1].subscripts.empty() || part + 2 < parts.size()) return refuse();
            const std::size_t count =
                member->elements.size() / std::max<std::size_t>(1, elementCount(target.dimensions));
            if (value.elements.size() != count) return refuse();
            std::copy(value.elements.begin(), value.elements.end(),
                      member->elements.begin() + static_cast<std::ptrdiff_t>(places[0] * count));
            return true;
        }
        const bool isText = target.type == FlatType::String;
        if (value.size() != places.size() || value.dimensions != remaining ||
            isText != (value.type == FlatType::String))
            return refuse();
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (isText)
                target.texts[places[i]] = value.texts[i];
            else
                target.elements[places[i]] = value.elements[i];
        }
        return true;
    }
    Value* member = target.member(parts[part + 1].identifier);
    return member ? storeIn(*member, parts, part + 1, value, scope, span) : refuse();
}

Executor::Flow Executor::conditional(const Statement& statement, std::size_t branch, const Scope& scope) {
    if (branch == statement.branches.size()) return Flow::Next;
    const auto& here = statement.branches[branch];
    if (!here.condition) return execute(here.body, scope);
    const auto condition = work_.translator->translate(*here.condition, scope);
    if (!condition) return Flow::Failed;
    if (condition->type != FlatType::Boolean || !condition->isScalar()) {
        work_.messages.error(phrase("the condition after 'if' must be Boolean, not {}", typeText(*condition)),
                             here.condition->span);
        return Flow::Failed;
    }
    // a function makes no events (section 8.5): a branch that does not count now may have no value
    const ExpressionId test = hasOpenLoop_ && !isModel_ ? work_.pool.unary(Operation::NoEvent, condition->elements[0])
                                                        : condition->elements[0];
    if (const auto known = work_.translator->knownNow(test))
        return *known != 0 ? execute(here.body, scope) : conditional(statement, branch + 1, scope);
    const Memory before = remember();
    guards_.push_back(test);
    const Flow then = execute(here.body, scope);
    if (then != Flow::Failed) leave(then);
    guards_.back() = work_.pool.unary(Operation::Not, test);
    const Memory after = remember();
    recall(before);
    const Flow otherwise = then == Flow::Failed ? Flow::Failed : conditional(statement, branch + 1, scope);
    if (otherwise != Flow::Failed) leave(otherwise);
    guards_.pop_back();
    if (then == Flow::Failed || otherwise == Flow::Failed) return Flow::Failed;
    return join(test, after, statement.span) ? Flow::Next : Flow::Failed;
}

Executor::Flow Executor::loop(const Statement& statement, std::size_t iterator, const Scope& scope) {
    if (iterator == statement.iterators.size()) return execute(statement.body, scope);
    const std::string& name = statement.iterators[iterator].name;
    const auto values = work_.translator->rangeOf(statement, iterator, scope);
    if (!values) return Flow::Failed;
    const ExpressionId outside = std::exchange(broken_, ExpressionId{});
    for (int k = 1; k <= values->dimensions[0]; ++k) {
        if (broken_.valid() && work_.pool.isConstant(broken_, 1)) break;
        work_.translator->pushIterator(name, values->part(k));
        const Flow flow = loop(statement, iterator + 1, scope);
        work_.translator->popIterator();
        if (flow == Flow::Break) break;
        if (flow != Flow::Next) return flow;
    }
    broken_ = outside;
    return Flow::Next;
}

Executor::Flow Executor::repeat(const Statement& statement, const Scope& scope) {
    const auto& branch = statement.branches.front();
    const ExpressionId outside = std::exchange(broken_, ExpressionId{});
    for (std::size_t turn = 0; turn < mostTurns; ++turn) {
        const auto condition = work_.translator->translate(*branch.condition, scope);
        if (!condition) return Flow::Failed;
        if (condition->type != FlatType::Boolean || !condition->isScalar()) {
            work_.messages.error(phrase("the condition after 'while' must be Boolean, not {}", typeText(*condition)),
                                 branch.condition->span);
            return Flow::Failed;
        }
        const auto known = work_.translator->knownNow(condition->elements[0]);
        if (!known) {
            const Flow flow = repeatOpen(statement, scope);
            broken_ = outside;
            return flow;
        }
        if (*known == 0 || (broken_.valid() && work_.pool.isConstant(broken_, 1))) {
            broken_ = outside;
            return Flow::Next;
        }
        const Flow flow = execute(branch.body, scope);
        if (flow == Flow::Break) {
            broken_ = outside;
            return Flow::Next;
        }
        if (flow != Flow::Next) return flow;
    }
    work_.messages.error(phrase("the loop runs more than {} times", mostTurns), statement.keyword);
    return Flow::Failed;
}

Executor::Flow Executor::when(const Statement& statement, const Scope& scope) {
    if (!isModel_) {
        work_.messages.error(phrase("'when' has no meaning in a function"), statement.keyword);
        return Flow::Failed;
    }
    std::vector<ExpressionId> active;
    for (const auto& branch : statement.branches) {
        const auto condition = work_.events->activation(*branch.condition, scope);
        if (!condition) return Flow::Failed;
        active.push_back(*condition);
    }
    // from the last on: each of them counts where none before it does
    const Memory before = remember();
    std::vector<Memory> after;
    for (std::size_t b = 0; b < statement.branches.size(); ++b) {
        recall(before);
        guards_.push_back(active[b]);
        const Flow flow = execute(statement.branches[b].body, scope);
        guards_.pop_back();
        if (flow != Flow::Next) return Flow::Failed;
        after.push_back(remember());
    }
    recall(before);
    for (std::size_t b = statement.branches.size(); b-- > 0;)
        if (!join(active[b], after[b], statement.span)) return Flow::Failed;
    return Flow::Next;
}

Executor::Flow Executor::callOf(const Statement& statement, const Scope& scope) {
    ExpressionId guard = work_.pool.constant(1);
    for (const ExpressionId condition : guards_) guard = work_.pool.binary(Operation::And, guard, condition);
    if (isModel_ || statement.left.name.text() == "assert")
        return work_.events->action(statement, guard, scope) ? Flow::Next : Flow::Failed;
    return work_.translator->outputsOf(statement.left, scope) ? Flow::Next : Flow::Failed;
}

// ------------------------------------------------------------------------------------------- memory and branches

Executor::Memory Executor::remember() const { return {work_.translator->iterators_, work_.translator->overlay_}; }

void Executor::recall(Memory memory) {
    work_.translator->iterators_ = std::move(memory.locals);
    work_.translator->overlay_ = std::move(memory.variables);
}

/// What is in force becomes `if condition then … else` what is.
bool Executor::join(ExpressionId condition, const Memory& then, const Span& span) {
    Translator& translator = *work_.translator;
    for (std::size_t i = 0; i < translator.iterators_.size() && i < then.locals.size(); ++i)
        if (!join(condition, then.locals[i].second, translator.iterators_[i].second, span)) return false;
    for (const auto& [variable, expression] : then.variables) {
        ExpressionId& mine = translator.overlay_[variable];
        mine = mine.valid() ? work_.pool.ifThenElse(condition, expression, mine) : expression;
    }
    return true;
}

bool Executor::join(ExpressionId condition, const Value& then, Value& otherwise, const Span& span) {
    if (then.isRecord() && otherwise.isRecord()) {
        for (auto& [name, member] : otherwise.members)
            if (const Value* other = then.member(name); other && !join(condition, *other, member, span)) return false;
        return true;
    }
    if (then.dimensions != otherwise.dimensions || then.texts != otherwise.texts || then.object != otherwise.object) {
        work_.messages.error(phrase("the branches differ in a size or a text, and their condition is not known before "
                                    "the simulation"),
                             span);
        return false;
    }
    for (std::size_t k = 0; k < otherwise.elements.size(); ++k)
        otherwise.elements[k] = work_.pool.ifThenElse(condition, then.elements[k], otherwise.elements[k]);
    return true;
}

// ------------------------------------------------------------------------------------ algorithm sections of models

void Executor::collectTargets(const std::vector<Statement>& statements, const Scope& scope, bool isInWhen,
                              std::vector<std::pair<VariableId, bool>>& targets) {
    const auto take = [&](const syntax::Expression& target) {
        if (target.kind != ExpressionKind::Reference) return;
        for (const auto& [name, value] : work_.translator->iterators_)
            if (name == target.name.parts.front().identifier) return;
        syntax::Name whole = target.name;
        for (syntax::NamePart& part : whole.parts) part.subscripts.clear();  // subscripts may need a loop
        const auto slice = work_.translator->resolve(whole, scope);
        if (!slice || !work_.translator->mayBeUsed(*slice, target.span)) return;
        for (const VariableId id : variablesOf(*slice)) targets.emplace_back(id, isInWhen);
    };
    for (const Statement& statement : statements) {
        if (statement.kind == StatementKind::Assign) {
            take(statement.left);
            for (const syntax::Expression& part : statement.left.operands)
                if (statement.left.kind == ExpressionKind::Tuple) take(part);
        }
        for (const auto& branch : statement.branches)
            collectTargets(branch.body, scope, isInWhen || statement.kind == StatementKind::When, targets);
        collectTargets(statement.body, scope, isInWhen, targets);
    }
}

/// Each variable that is set begins as it was before (section 11.1.2): pre(x) where it is discrete, else its start.
void Executor::section(const syntax::EquationSection& section, const Scope& scope) {
    isInitial_ = section.isInitial;
    isModel_ = true;
    Translator& translator = *work_.translator;
    std::vector<std::pair<VariableId, bool>> targets;
    collectTargets(section.equations, scope, false, targets);
    if (work_.messages.hasErrors()) return;
    translator.overlay_.clear();
    std::vector<VariableId> order;
    for (const auto& [id, isInWhen] : targets) {
        FlatVariable& variable = work_.model.variables[id.value];
        if (isInWhen && !isInitial_) variable.isDiscrete = true;
        if (std::find(order.begin(), order.end(), id) != order.end()) continue;
        order.push_back(id);
    }
    for (const VariableId id : order) {
        const FlatVariable& variable = work_.variable(id);
        const bool isDiscrete = variable.isDiscrete || variable.type != FlatType::Real;
        translator.overlay_[id.value] = isDiscrete && work_.isContinuous(id) ? work_.events->pre(id)
                                        : variable.start.valid()             ? variable.start
                                                                             : work_.pool.constant(0);
    }
    work_.events->setInitial(isInitial_);
    const Flow flow = execute(section.equations, scope);
    work_.events->setInitial(false);
    const auto values = std::move(translator.overlay_);
    translator.overlay_.clear();
    isModel_ = false;
    if (flow == Flow::Failed) {
        if (!work_.messages.hasErrors())
            work_.messages.error(phrase("the algorithm could not be run"), section.keyword);
        return;
    }
    for (const VariableId id : order) {
        FlatEquation equation{
            work_.pool.variable(id),      values.at(id.value), section.keyword, scope.instance->name, false,
            work_.variable(id).isDiscrete};
        if (isInitial_ && work_.binder->takeInitialValue(equation)) continue;
        (isInitial_ ? work_.model.initialEquations : work_.model.equations).push_back(equation);
        if (!isInitial_) ++scope.instance->component().equations;
    }
}

}  // namespace analogon
