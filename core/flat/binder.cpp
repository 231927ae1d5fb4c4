#include "core/flat/binder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/flat/translator.hpp"
#include "core/syntax/printer.hpp"

namespace analogon {
namespace {

constexpr std::array textAttributes{"unit", "displayUnit", "quantity"};

bool isText(std::string_view name) {
    return std::find(textAttributes.begin(), textAttributes.end(), name) != textAttributes.end();
}

bool isParameterElement(const Flattening& work, const Element& element) {
    return element.count() > 0 && work.variable(element.firstVariable).variability != FlatVariability::Continuous;
}

}  // namespace

void Binder::bindAll() {
    // der(der(x)) may add variables on the way; they are bound already.
    for (std::size_t i = 0; i < work_.records.size() && !work_.messages.full(); ++i) {
        const VariableRecord record = work_.records[i];
        Element& element = record.owner->elements[record.element];
        if (!element.firstVariable.valid() || element.firstVariable.value + record.position != i) continue;
        if (record.position != 0) continue;
        if (isParameterElement(work_, element)) {
            bindParameter(*record.owner, element);
        } else if (element.binding == Element::Binding::Pending) {
            element.binding = Element::Binding::Done;
            bindAttributes(*record.owner, element);
            bindValue(*record.owner, element);
        }
    }
}

bool Binder::bindParameter(Instance& instance, Element& element) {
    if (element.binding == Element::Binding::Done) return true;
    if (element.binding == Element::Binding::Busy) {
        work_.messages.error(
            phrase("the value of '{}' depends on itself", instance.memberName(element.declaration->name)),
            element.declaration->nameSpan, phrase("break the circle of parameters"));
        return false;
    }
    element.binding = Element::Binding::Busy;
    bindAttributes(instance, element);
    const bool succeeded = bindValue(instance, element);
    element.binding = Element::Binding::Done;
    freeParameters(instance, element);
    return succeeded;
}

/// A parameter with fixed = false and no value is found at the start, from an initial equation (section 8.6): an
/// unknown that stays as it is from then on. Its start value is where the search begins.
void Binder::freeParameters(Instance& instance, Element& element) {
    for (std::size_t k = 0; k < element.count(); ++k) {
        const VariableId id{static_cast<std::uint32_t>(element.firstVariable.value + k)};
        FlatVariable& variable = work_.model.variables[id.value];
        if (!free_.contains(id) || variable.binding.valid() || variable.type != FlatType::Real) continue;
        variable.variability = FlatVariability::Continuous;
        variable.isFoundAtStart = true;
        Instance& component = instance.component();
        work_.model.equations.push_back(
            {work_.pool.derivativeOf(id), work_.pool.constant(0), variable.declared, component.name, false});
        ++component.equations;
    }
}

/// The value of a modification, of the size of the element; `each` repeats a scalar.
std::optional<Value> Binder::valueFor(Instance& instance, Element& element, const Modifier& modifier,
                                      const Text& what) {
    auto value = work_.translator->translate(modifier.value);
    if (!value) return std::nullopt;
    const Span& span = modifier.value.expression->span;
    if (modifier.each && value->isScalar() && !element.dimensions.empty()) {
        value->elements.assign(element.count(), value->elements.empty() ? ExpressionId{} : value->elements[0]);
        if (value->type == FlatType::String) {
            value->texts.assign(element.count(), value->texts[0]);
            value->elements.clear();
        }
        value->dimensions = element.dimensions;
    }
    const bool bothEmpty = value->size() == 0 && element.count() == 0;
    if (value->dimensions == element.dimensions || bothEmpty) return value;
    const std::string name = instance.memberName(element.declaration->name);
    const Text hint = value->isScalar() ? phrase("write 'each' before the attribute, or fill(value, size)") : Text();
    work_.messages.error(
        phrase("{} of '{}' has size {}, the variable {}", what, name,
               value->isScalar() ? phrase("of a single value") : Text(sizeText(value->dimensions)),
               element.dimensions.empty() ? phrase("is a single value") : Text(sizeText(element.dimensions))),
        span, hint);
    return std::nullopt;
}

bool Binder::fitsType(const Element& element, const Value& value) const {
    if (value.isRecord() || value.isObject() || value.isFunction()) return false;  // no scalars of its own
    if (element.type.enumeration) return value.enumeration == element.type.enumerationName();
    if (!value.enumeration.empty()) return false;
    if (value.type == element.type.builtin) return true;
    return element.type.builtin == FlatType::Real && value.type == FlatType::Integer;
}

// ------------------------------------------------------------------------------------------------- attributes

void Binder::bindAttributes(Instance& instance, Element& element) {
    for (const auto& [name, modifier] : element.modifier.children) {
        if (std::find(attributeNames.begin(), attributeNames.end(), name) == attributeNames.end()) {
            std::vector<std::string> names(attributeNames.begin(), attributeNames.end());
            work_.messages.error(phrase("'{}' is not an attribute of {}", name, typeName(element.type.builtin)),
                                 modifier.span, didYouMean(name, names));
            continue;
        }
        if (modifier.value.valid() && element.count() > 0) setAttribute(instance, element, name, modifier);
    }
}

void Binder::setAttribute(Instance& instance, Element& element, const std::string& name, const Modifier& modifier) {
    if (name == "stateSelect") return setStateSelect(element, modifier);
    if (name == "unbounded") return;  // says nothing about the values
    const auto value = valueFor(instance, element, modifier, phrase("the attribute '{}'", name));
    if (!value) return;
    const Span& span = modifier.value.expression->span;
    const bool isBoolean = name == "fixed";
    const bool sameAsVariable = name == "start" || name == "min" || name == "max";
    const bool fits = isText(name)     ? value->type == FlatType::String
                      : isBoolean      ? value->type == FlatType::Boolean
                      : sameAsVariable ? fitsType(element, *value)
                                       : value->isNumeric();
    if (!fits) {
        work_.messages.error(phrase("the attribute '{}' of '{}' cannot be {}", name,
                                    instance.memberName(element.declaration->name), typeText(*value)),
                             span);
        return;
    }
    if (name == "start")
        for (ExpressionId start : value->elements)
            if (!work_.pool.isConstant(start) && !work_.translator->isParametric(start)) {
                work_.messages.error(phrase("the start value of '{}' changes while the model runs",
                                            instance.memberName(element.declaration->name)),
                                     span, phrase("use numbers and parameters"));
                return;
            }
    for (std::size_t k = 0; k < element.count(); ++k) {
        const std::size_t id = element.firstVariable.value + k;
        if (isText(name)) {
            setText(work_.model.variables[id], name, *value, k);
        } else if (name == "start") {
            if (value->type == FlatType::String)
                work_.model.variables[id].text = value->texts[k];
            else
                work_.model.variables[id].start = value->elements[k];
        } else if (const auto number = work_.translator->constantNumber(value->elements[k], false)) {
            setNumber(work_.model.variables[id], name, *number);
            if (name == "fixed" && *number == 0 && work_.model.variables[id].variability == FlatVariability::Parameter)
                free_.insert({static_cast<std::uint32_t>(id)});
        } else {
            work_.messages.error(phrase("the attribute '{}' must be known before the simulation", name), span);
            return;
        }
    }
}

void Binder::setText(FlatVariable& variable, const std::string& name, const Value& value, std::size_t at) {
    if (name == "unit")
        variable.unit = value.texts[at];
    else if (name == "displayUnit")
        variable.displayUnit = value.texts[at];
    else
        variable.quantity = value.texts[at];
}

void Binder::setNumber(FlatVariable& variable, const std::string& name, double number) {
    if (name == "min")
        variable.min = number;
    else if (name == "max")
        variable.max = number;
    else if (name == "nominal")
        variable.nominal = number;
    else
        variable.isFixed = number != 0;
}

void Binder::setStateSelect(Element& element, const Modifier& modifier) {
    static const std::vector<std::string> names{"never", "avoid", "default", "prefer", "always"};
    const syntax::Expression& expression = *modifier.value.expression;
    const auto& parts = expression.name.parts;
    if (expression.kind == syntax::Expression::Kind::Reference && parts.size() == 2 &&
        parts[0].identifier == "StateSelect") {
        const auto found = std::find(names.begin(), names.end(), parts[1].identifier);
        if (found != names.end()) {
            for (std::size_t k = 0; k < element.count(); ++k)
                work_.model.variables[element.firstVariable.value + k].stateSelect =
                    static_cast<StateSelect>(found - names.begin());
            return;
        }
    }
    const auto value = work_.translator->translate(modifier.value);
    if (!value) return;
    const auto number = value->enumeration == "StateSelect" && value->elements.size() == 1
                            ? work_.translator->constantNumber(value->elements[0], true)
                            : std::nullopt;
    if (number) {
        for (std::size_t k = 0; k < element.count(); ++k)
            work_.model.variables[element.firstVariable.value + k].stateSelect =
                static_cast<StateSelect>(static_cast<int>(*number) - 1);
        return;
    }
    work_.messages.error(phrase("'stateSelect' is one of StateSelect.never, avoid, default, prefer, always"),
                         expression.span);
}

// ----------------------------------------------------------------------------------------------------- values

bool Binder::bindValue(Instance& instance, Element& element) {
    const Modifier& modifier = element.modifier;
    if (!modifier.value.valid() || element.count() == 0) return true;
    const std::string name = instance.memberName(element.declaration->name);
    const auto value = valueFor(instance, element, modifier, phrase("the value"));
    if (!value) return false;
    const Span& span = modifier.value.expression->span;
    if (!fitsType(element, *value)) {
        const std::string expected = element.type.enumeration ? element.type.className : typeName(element.type.builtin);
        work_.messages.error(phrase("'{}' is {} and cannot be {}", name, expected, typeText(*value)), span);
        return false;
    }
    const bool isParameter = isParameterElement(work_, element);
    const auto& scoped = modifier.value;
    for (std::size_t k = 0; k < element.count(); ++k) {
        const VariableId id{static_cast<std::uint32_t>(element.firstVariable.value + k)};
        FlatVariable& variable = work_.model.variables[id.value];
        // One element of { … } is the place to edit, when there is one.
        const syntax::Expression* place = scoped.expression;
        std::vector<int> path = scoped.subscripts;
        if (!modifier.each) {
            const std::vector<int> own = subscriptsOf(k, element.dimensions);
            path.insert(path.end(), own.begin(), own.end());
        }
        for (int i : path) {
            const bool isList = place->kind == syntax::Expression::Kind::Array && place->iterators.empty();
            if (!isList || static_cast<std::size_t>(i) > place->operands.size()) break;
            place = &place->operands[static_cast<std::size_t>(i) - 1];
        }
        variable.value = place->span;
        if (value->type == FlatType::String) {
            variable.text = value->texts[k];
            work_.records[id.value].isBound = true;
        } else if (isParameter) {
            variable.binding = value->elements[k];
        } else {
            work_.records[id.value].isBound = true;
            Instance& component = instance.component();
            work_.model.equations.push_back(
                {work_.pool.variable(id), value->elements[k], place->span, component.name, false});
            ++component.equations;
        }
    }
    return true;
}

// ----------------------------------------------------------------------------------------------------- checks

void Binder::checkParameter(VariableId id) {
    FlatVariable& variable = work_.model.variables[id.value];
    if (variable.type == FlatType::String) return;
    if (!variable.binding.valid()) {
        if (variable.start.valid() && variable.variability == FlatVariability::Parameter) {
            variable.binding = variable.start;
            return;
        }
        const bool isConstant = variable.variability == FlatVariability::Constant;
        work_.messages.error(isConstant ? phrase("the constant '{}' has no value", variable.name)
                                        : phrase("the parameter '{}' has no value", variable.name),
                             variable.declared,
                             phrase("give it one, for example {} = 1", work_.elementOf(id).declaration->name));
        return;
    }
    bool usesTime = false;
    VariableId used, parameter;
    work_.pool.evaluate(variable.binding, [&](const ExpressionNode& leaf) {
        if (leaf.variable.valid() && work_.variable(leaf.variable).variability == FlatVariability::Parameter)
            parameter = leaf.variable;
        if (leaf.operation != Operation::Variable && leaf.operation != Operation::Derivative)
            usesTime = true;
        else if (work_.isContinuous(leaf.variable))
            used = leaf.variable;
        return 0.0;
    });
    if (variable.variability == FlatVariability::Constant && parameter.valid())
        work_.messages.error(
            phrase("the constant '{}' depends on the parameter '{}'", variable.name, work_.variable(parameter).name),
            variable.value, phrase("declare it as parameter"));
    if (!used.valid() && !usesTime) return;
    work_.messages.error(phrase("the parameter '{}' depends on {}, which changes while the model runs", variable.name,
                                used.valid() ? fmt::format("'{}'", work_.variable(used).name) : "time"),
                         variable.value, phrase("remove the prefix 'parameter', or use parameters only"));
}

bool Binder::takeInitialValue(const FlatEquation& equation) {
    for (const auto& [target, value] :
         {std::pair(equation.left, equation.right), std::pair(equation.right, equation.left)}) {
        const ExpressionNode node = work_.pool[target];
        if (node.operation != Operation::Variable || !free_.contains(node.variable)) continue;
        FlatVariable& variable = work_.model.variables[node.variable.value];
        if (variable.binding.valid() || !work_.translator->isParametric(value)) continue;
        variable.binding = value;
        variable.value = equation.span;
        if (variable.type != FlatType::Real) return true;
        variable.variability = FlatVariability::Parameter;
        variable.isFinal = true;  // nobody else may give it another value
        bound_.insert(node.variable);
        return true;
    }
    return false;
}

/// Initial equations that speak of each other's parameters may stand in any order.
void Binder::bindFreeParameters() {
    while (std::erase_if(work_.model.initialEquations, [this](const FlatEquation& e) { return takeInitialValue(e); })) {
    }
    std::erase_if(work_.model.equations, [this](const FlatEquation& equation) {
        const ExpressionNode left = work_.pool[equation.left];
        if (left.operation != Operation::Derivative || !bound_.contains(left.variable)) return false;
        --work_.records[left.variable.value].owner->component().equations;
        return true;
    });
}

/// Whether a parameter speaks of one that is found at the start, and of nothing else that runs.
bool Binder::followsFoundAtStart(const FlatVariable& variable) {
    bool follows = false, runs = false;
    work_.pool.evaluate(variable.binding, [&](const ExpressionNode& leaf) {
        if (leaf.operation != Operation::Variable)
            runs = true;
        else if (const FlatVariable& used = work_.variable(leaf.variable);
                 used.variability == FlatVariability::Continuous)
            (used.isFoundAtStart ? follows : runs) = true;
        return 0.0;
    });
    return follows && !runs;
}

/// A parameter that is computed from one that is found at the start is known when that is: an equation gives it.
void Binder::freeFollowers() {
    auto& variables = work_.model.variables;
    for (bool isNew = !free_.empty(); isNew;) {
        isNew = false;
        for (std::uint32_t i = 0; i < variables.size(); ++i) {
            FlatVariable& variable = variables[i];
            if (variable.variability != FlatVariability::Parameter || variable.type != FlatType::Real ||
                !variable.binding.valid() || !followsFoundAtStart(variable))
                continue;
            isNew = variable.isFoundAtStart = true;
            variable.variability = FlatVariability::Continuous;
            Instance& component = work_.records[i].owner->component();
            work_.model.equations.push_back(
                {work_.pool.variable({i}), variable.binding, variable.value, component.name, false});
            variable.binding = {};
            ++component.equations;
        }
    }
}

void Binder::checkParameters() {
    bindFreeParameters();
    freeFollowers();
    auto& variables = work_.model.variables;
    for (std::uint32_t i = 0; i < variables.size() && !work_.messages.full(); ++i)
        if (variables[i].variability != FlatVariability::Continuous) checkParameter({i});
    if (work_.messages.hasErrors()) return;

    // Depth-first search with an explicit stack; a parameter met again while it is open closes a circle.
    enum class Mark : char { New, Open, Closed };
    std::vector<Mark> marks(variables.size(), Mark::New);
    struct Frame {
        VariableId id;
        std::vector<ExpressionId> uses;
        std::size_t next{};
    };
    std::vector<Frame> stack;
    const auto open = [&](VariableId id) {
        marks[id.value] = Mark::Open;
        Frame frame{id, {}, 0};
        const ExpressionId binding = variables[id.value].binding;
        if (binding.valid()) frame.uses = work_.pool.leaves(std::span(&binding, 1));
        stack.push_back(std::move(frame));
    };
    for (std::uint32_t i = 0; i < variables.size(); ++i) {
        if (variables[i].variability == FlatVariability::Continuous || marks[i] != Mark::New) continue;
        open({i});
        while (!stack.empty()) {
            Frame& top = stack.back();
            if (top.next == top.uses.size()) {
                marks[top.id.value] = Mark::Closed;
                stack.pop_back();
                continue;
            }
            const VariableId used = work_.pool[top.uses[top.next++]].variable;
            if (marks[used.value] == Mark::New) {
                open(used);
            } else if (marks[used.value] == Mark::Open) {
                std::string circle = variables[used.value].name;
                auto from = std::find_if(stack.begin(), stack.end(), [&](const Frame& f) { return f.id == used; });
                const Span span = variables[used.value].value;
                for (++from; from != stack.end() && circle.size() < 500; ++from)
                    circle += " -> " + variables[from->id.value].name;
                work_.messages.error(
                    phrase("parameters depend on each other: {} -> {}", circle, variables[used.value].name), span,
                    phrase("give one of them a value of its own"));
                return;
            }
        }
    }
}

}  // namespace analogon
