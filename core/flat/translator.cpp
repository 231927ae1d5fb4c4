#include "core/flat/translator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/flat/binder.hpp"
#include "core/flat/executor.hpp"
#include "core/flat/instantiator.hpp"

namespace analogon {
namespace {

using Kind = syntax::Expression::Kind;

}  // namespace

std::optional<Value> Translator::translate(const Expression& expression, const Scope& scope) {
    if (depth_ >= deepestNesting) {
        work_.messages.error(phrase("the expression is nested too deeply"), expression.span,
                             phrase("split it with variables"));
        return std::nullopt;
    }
    ++depth_;
    auto result = translateNested(expression, scope);
    --depth_;
    return result;
}

std::optional<Value> Translator::translateNested(const Expression& expression, const Scope& scope) {
    switch (expression.kind) {
        case Kind::Number:
            return Value::scalar(expression.isInteger ? FlatType::Integer : FlatType::Real,
                                 work_.pool.constant(expression.number));
        case Kind::String:
            return Value::text(expression.text);
        case Kind::Boolean:
            return Value::scalar(FlatType::Boolean, work_.pool.constant(expression.number));
        case Kind::Reference:
            return reference(expression.name, scope, expression.span);
        case Kind::Unary:
            return unary(expression, scope);
        case Kind::Binary:
            return binaryChain(expression, scope);
        case Kind::If:
            return conditional(expression, scope);
        case Kind::Call:
            return callFunction(work_, expression, scope);
        case Kind::Array:
            return array(expression, scope);
        case Kind::Range:
            return range(expression, scope);
        case Kind::End:
            if (ends_.empty()) break;
            return Value::scalar(FlatType::Integer, work_.pool.constant(ends_.back()));
        case Kind::Colon:
            break;
        case Kind::Tuple:
            if (expression.operands.size() == 1) return translate(expression.operands[0], scope);
            work_.messages.error(phrase("a list in parentheses is not a value here"), expression.span,
                                 phrase("write one equation for each member"));
            return std::nullopt;
        case Kind::Matrix:
            return matrix(expression, scope);
        case Kind::Select:
            return selected(expression, scope);
        case Kind::Function:
            work_.messages.error(phrase("functions as arguments are not supported"), expression.span,
                                 phrase("write the relation as equations"));
            return std::nullopt;
        case Kind::Break:
            work_.messages.error(phrase("\"break\" is not supported"), expression.span,
                                 phrase("give the value itself"));
            return std::nullopt;
        case Kind::Empty:
            work_.messages.error(phrase("a value is missing here"), expression.span);
            return std::nullopt;
    }
    work_.messages.error(phrase("'{}' has a meaning in a subscript only", expression.span.text()), expression.span);
    return std::nullopt;
}

std::optional<Value> Translator::translate(const ModifierValue& modifier) {
    const Expression* expression = modifier.expression;
    const auto subscripts = modifier.subscripts;
    std::size_t used = 0;
    if (!modifier.members.empty()) {
        const bool isComponent = expression->kind == Kind::Reference && !expression->name.absolute &&
                                 modifier.scope.instance &&
                                 modifier.scope.instance->find(expression->name.parts.front().identifier);
        if (isComponent) {
            const auto slice = resolve(expression->name, modifier.scope, modifier.members);
            if (!slice) return std::nullopt;
            auto value = valueOf(*slice);
            for (; value && used < subscripts.size() && !value->isScalar(); ++used)
                value = value->part(subscripts[used]);
            return value;
        }
        auto value = translate(*expression, modifier.scope);
        if (value && !value->isRecord()) {
            work_.messages.error(phrase("a record can be set to another record only"), expression->span,
                                 phrase("modify its parameters: name(parameter = value)"));
            return std::nullopt;
        }
        for (const std::string& name : modifier.members) {
            const Value* const member = value ? value->member(name) : nullptr;
            if (!member) {
                if (value)
                    work_.messages.error(phrase("'{}' has no member '{}'", typeText(*value), name), expression->span);
                return std::nullopt;
            }
            value = Value(*member);
        }
        for (; value && used < subscripts.size() && !value->isScalar(); ++used) {
            if (subscripts[used] > value->dimensions[0]) return std::nullopt;
            value = value->part(subscripts[used]);
        }
        return value;
    }
    // {a, b, c}[2] needs only b.
    while (used < subscripts.size() && expression->kind == Kind::Array && expression->iterators.empty() &&
           static_cast<std::size_t>(subscripts[used]) <= expression->operands.size())
        expression = &expression->operands[static_cast<std::size_t>(subscripts[used++]) - 1];
    auto value = translate(*expression, modifier.scope);
    for (; value && used < subscripts.size(); ++used) {
        if (value->isScalar()) {
            work_.messages.error(phrase("a single value is given to an array of components"), expression->span,
                                 phrase("write 'each' before the name, or one value per element: {{a, b, …}}"));
            return std::nullopt;
        }
        if (subscripts[used] > value->dimensions[0]) {
            work_.messages.error(
                phrase("the value has size {}, the array of components is larger", sizeText(value->dimensions)),
                expression->span);
            return std::nullopt;
        }
        value = value->part(subscripts[used]);
    }
    return value;
}

bool Translator::spend(std::size_t elements, const Span& span) {
    constexpr std::size_t most = 10'000'000;
    spent_ += elements;
    if (spent_ <= most) return true;
    work_.messages.fatal(phrase("the arrays of the model are too large to be worked out"), span,
                         phrase("use smaller sizes"));
    return false;
}

std::optional<Value> Translator::unary(const Expression& expression, const Scope& scope) {
    auto value = translate(expression.operands[0], scope);
    if (!value) return value;
    if (value->isRecord() && (expression.text == "-" || expression.text == "+"))
        if (const LibraryClass* type = work_.library.find(value->record); type && hasOperators(*type)) {
            if (expression.text == "+") return value;
            return Executor(work_).operate("-", {std::move(*value)}, expression.span);
        }
    const bool isNot = expression.text == "not";
    if (isNot ? value->type != FlatType::Boolean : !value->isNumeric()) {
        work_.messages.error(isNot ? phrase("'{}' needs a Boolean value, not {}", expression.text, typeText(*value))
                                   : phrase("'{}' needs a numeric value, not {}", expression.text, typeText(*value)),
                             expression.operands[0].span);
        return std::nullopt;
    }
    if (isNot || expression.text == "-" || expression.text == ".-")
        for (ExpressionId& element : value->elements)
            element = work_.pool.unary(isNot ? Operation::Not : Operation::Negate, element);
    return value;
}

/// Long sums lean to the left: a loop down the left side instead of recursion.
std::optional<Value> Translator::binaryChain(const Expression& expression, const Scope& scope) {
    std::vector<const Expression*> chain;
    const Expression* leftmost = &expression;
    for (; leftmost->kind == Kind::Binary; leftmost = &leftmost->operands[0]) chain.push_back(leftmost);
    auto value = translate(*leftmost, scope);
    for (auto link = chain.rbegin(); link != chain.rend(); ++link) {
        const auto right = translate((*link)->operands[1], scope);
        if (!value || !right) return std::nullopt;
        value = combine(work_, (*link)->text, *value, *right, (*link)->span);
    }
    return value;
}

/// The branch that is taken whatever happens, where a branch that is not taken would have another size or no value.
const syntax::Expression* Translator::decided(const Expression& expression, const Scope& scope) {
    const auto& operands = expression.operands;
    for (std::size_t i = 0; i + 1 < operands.size(); i += 2) {
        const Messages::Quiet quiet(work_.messages);
        const auto condition = translate(operands[i], scope);
        if (!condition || condition->type != FlatType::Boolean || !condition->isScalar()) return nullptr;
        const ExpressionId test = condition->elements[0];
        if (!work_.pool.isConstant(test) && !isParametric(test)) return nullptr;
        const auto known = constantNumber(test, true);
        if (!known) return nullptr;
        if (*known != 0) return &operands[i + 1];
        if (i + 2 == operands.size() - 1) return &operands.back();
    }
    return nullptr;
}

/// Both branches count, as a parameter may decide when the model runs; unless one that is not taken has another size
/// or no value.
std::optional<Value> Translator::conditional(const Expression& expression, const Scope& scope) {
    const auto allBranches = [&]() -> std::optional<Value> {
        const auto& operands = expression.operands;  // condition, value, (condition, value)…, else
        auto result = translate(operands.back(), scope);
        bool sound = result.has_value();
        for (std::size_t i = operands.size() - 1; i >= 2; i -= 2) {
            const auto condition = translate(operands[i - 2], scope);
            const auto branch = translate(operands[i - 1], scope);
            if (condition && (condition->type != FlatType::Boolean || !condition->isScalar())) {
                work_.messages.error(phrase("the condition after 'if' must be Boolean, not {}", typeText(*condition)),
                                     operands[i - 2].span);
                sound = false;
            }
            if (!condition || !branch) sound = false;
            if (!sound) continue;
            const bool bothNumeric = branch->isNumeric() && result->isNumeric();
            if (branch->dimensions != result->dimensions ||
                (!bothNumeric && (branch->type != result->type || branch->enumeration != result->enumeration))) {
                work_.messages.error(
                    phrase("the branches of 'if' differ in type: {} and {}", typeText(*branch), typeText(*result)),
                    operands[i - 1].span);
                sound = false;
                continue;
            }
            if (result->type == FlatType::String) {
                const auto chosen = constantNumber(condition->elements[0], true);
                if (!chosen) {
                    work_.messages.error(phrase("a text cannot change while the model runs"), operands[i - 2].span);
                    sound = false;
                } else if (*chosen != 0) {
                    result = branch;
                }
                continue;
            }
            if (branch->isRecord() && result->isRecord()) {
                if (!chooseMembers(condition->elements[0], *branch, *result, operands[i - 1].span)) return std::nullopt;
                continue;
            }
            if (branch->isRecord() || branch->isObject()) {
                work_.messages.error(
                    phrase("the branches of 'if' differ in type: {} and {}", typeText(*branch), typeText(*result)),
                    operands[i - 1].span);
                return std::nullopt;
            }
            if (branch->type == FlatType::Real) result->type = FlatType::Real;
            for (std::size_t k = 0; k < result->elements.size(); ++k)
                result->elements[k] =
                    work_.pool.ifThenElse(condition->elements[0], branch->elements[k], result->elements[k]);
        }
        return sound ? result : std::nullopt;
    };
    // What fails is tried again: far down that would multiply.
    constexpr int deepestTrial = 6;
    if (depth_ > deepestTrial) return allBranches();
    std::optional<Value> value;
    {
        const Messages::Quiet quiet(work_.messages);
        value = allBranches();
        if (!value)
            if (const syntax::Expression* chosen = decided(expression, scope)) value = translate(*chosen, scope);
    }
    return value ? value : allBranches();
}

/// Records are chosen member by member.
bool Translator::chooseMembers(ExpressionId condition, const Value& branch, Value& result, const Span& span) {
    for (auto& [name, member] : result.members) {
        const Value* const other = branch.member(name);
        const bool fits = other && other->dimensions == member.dimensions && other->texts == member.texts &&
                          other->elements.size() == member.elements.size() && other->isRecord() == member.isRecord();
        if (!fits) {
            work_.messages.error(
                phrase("the branches of 'if' differ in type: {} and {}", typeText(branch), typeText(result)), span);
            return false;
        }
        if (member.isRecord() && !chooseMembers(condition, *other, member, span)) return false;
        for (std::size_t k = 0; k < member.elements.size(); ++k)
            member.elements[k] = work_.pool.ifThenElse(condition, other->elements[k], member.elements[k]);
    }
    return true;
}

// --------------------------------------------------------------------------------------------------- arrays

std::optional<Value> Translator::array(const Expression& expression, const Scope& scope) {
    if (!expression.iterators.empty()) return comprehension(expression, scope, expression.iterators.size());
    Value result;
    result.dimensions = {0};
    for (const auto& operand : expression.operands) {
        const auto part = translate(operand, scope);
        if (!part || !spend(part->size() + 1, operand.span) || !append(result, *part, operand.span))
            return std::nullopt;
    }
    return result;
}

/// `(…)[2]`
std::optional<Value> Translator::selected(const Expression& expression, const Scope& scope) {
    const syntax::NamePart& part = expression.name.parts.front();
    if (!part.identifier.empty()) {
        work_.messages.error(phrase("'{}': a member of an expression is not supported", expression.span.text()),
                             expression.span, phrase("name the record by a variable of its own"));
        return std::nullopt;
    }
    auto value = translate(expression.operands[0], scope);
    return value ? selectFromValue(std::move(*value), part.subscripts, scope, expression.span) : std::nullopt;
}

/// `[a, b; c, d]`: parts side by side in a row, rows below each other (section 10.4.2.1). A vector is a column.
std::optional<Value> Translator::matrix(const Expression& expression, const Scope& scope) {
    if (expression.operands.size() == 1 && expression.operands[0].operands.size() == 1) {
        auto only = translate(expression.operands[0].operands[0], scope);  // an array of any rank is itself
        while (only && only->dimensions.size() < 2) only->dimensions.push_back(1);
        return only;
    }
    std::vector<Value> rows;
    for (const Expression& row : expression.operands) {
        std::vector<Value> parts;
        for (const Expression& operand : row.operands) {
            auto part = translate(operand, scope);
            if (!part) return std::nullopt;
            if (part->dimensions.size() > 2) {
                work_.messages.error(phrase("'{}' has more than two dimensions and is no part of a matrix in brackets",
                                            operand.span.text()),
                                     operand.span);
                return std::nullopt;
            }
            while (part->dimensions.size() < 2) part->dimensions.push_back(1);
            parts.push_back(std::move(*part));
        }
        auto joined = concatenated(parts, 1, row.span);
        if (!joined) return std::nullopt;
        rows.push_back(std::move(*joined));
    }
    return concatenated(rows, 0, expression.span);
}

/// Arrays one behind the other along a dimension (0-based); the other sizes must agree.
std::optional<Value> Translator::concatenated(const std::vector<Value>& parts, std::size_t along, const Span& span) {
    Value result = parts.front();
    for (std::size_t p = 1; p < parts.size(); ++p) {
        const Value& part = parts[p];
        const bool bothNumeric = part.isNumeric() && result.isNumeric();
        bool fits = part.dimensions.size() == result.dimensions.size() &&
                    (bothNumeric || (part.type == result.type && part.enumeration == result.enumeration));
        for (std::size_t d = 0; fits && d < part.dimensions.size(); ++d)
            fits = d == along || part.dimensions[d] == result.dimensions[d];
        if (!fits) {
            work_.messages.error(
                phrase("{} and {} cannot stand side by side in one array", typeText(result), typeText(part)), span);
            return std::nullopt;
        }
        result.dimensions[along] += part.dimensions[along];
        if (part.type == FlatType::Real) result.type = FlatType::Real;
    }
    std::size_t outer = 1;
    for (std::size_t d = 0; d < along; ++d) outer *= static_cast<std::size_t>(result.dimensions[d]);
    if (!spend(elementCount(result.dimensions), span)) return std::nullopt;
    result.elements.clear();
    result.texts.clear();
    for (std::size_t o = 0; o < outer; ++o)
        for (const Value& part : parts) {
            const auto count = static_cast<std::ptrdiff_t>(part.size() / std::max<std::size_t>(outer, 1));
            const auto first = static_cast<std::ptrdiff_t>(o) * count;
            if (part.type == FlatType::String)
                result.texts.insert(result.texts.end(), part.texts.begin() + first, part.texts.begin() + first + count);
            else
                result.elements.insert(result.elements.end(), part.elements.begin() + first,
                                       part.elements.begin() + first + count);
        }
    return result;
}

/// { e for i in a, j in b } is {{ e for i in a } for j in b } (section 10.4.1).
std::optional<Value> Translator::comprehension(const Expression& expression, const Scope& scope,
                                               std::size_t outermost) {
    if (outermost == 0) return translate(expression.operands[0], scope);
    const auto& [name, ranges] = expression.iterators[outermost - 1];
    const auto values = ranges.empty() ? impliedRange(name, {&expression.operands[0]}, scope, expression.span)
                                       : range(ranges[0], scope);
    if (!values) return std::nullopt;
    Value result;
    result.dimensions = {0};
    const int count = values->dimensions[0];
    for (int k = 1; k <= count; ++k) {
        pushIterator(name, values->part(k));
        const auto part = comprehension(expression, scope, outermost - 1);
        popIterator();
        if (!part) return std::nullopt;
        // All parts are as large as the first one: what is too large is refused before it is made.
        if (k == 1 && !spend(static_cast<std::size_t>(count) * (part->size() + 1), expression.span))
            return std::nullopt;
        if (!append(result, *part, expression.span)) return std::nullopt;
    }
    return result;
}

/// One more part of an array that is written down part by part; the first one says what the others are.
bool Translator::append(Value& array, const Value& part, const Span& span) {
    if (part.isRecord()) {
        const bool isFirst = array.dimensions[0] == 0;
        if (isFirst) {
            array.record = part.record;
            array.dimensions.insert(array.dimensions.end(), part.dimensions.begin(), part.dimensions.end());
        }
        if (array.record != part.record) {
            work_.messages.error(
                phrase("the elements of an array must be alike: {} and {}", typeText(array), typeText(part)), span);
            return false;
        }
        ++array.dimensions[0];
        for (const auto& [name, value] : part.members) {
            if (isFirst) {
                Value empty;
                empty.dimensions = {0};
                array.members.emplace_back(name, std::move(empty));
            }
            Value* const member = array.member(name);
            if (!member || !append(*member, value, span)) return false;
        }
        return true;
    }
    if (array.dimensions[0] == 0) {
        array.type = part.type;
        array.enumeration = part.enumeration;
        array.dimensions.insert(array.dimensions.end(), part.dimensions.begin(), part.dimensions.end());
    }
    const bool sameSize = std::equal(array.dimensions.begin() + 1, array.dimensions.end(), part.dimensions.begin(),
                                     part.dimensions.end());
    const bool bothNumeric = part.isNumeric() && array.isNumeric();
    if (!sameSize || (!bothNumeric && (part.type != array.type || part.enumeration != array.enumeration))) {
        Value first = array;
        first.dimensions.erase(first.dimensions.begin());
        work_.messages.error(
            phrase("the elements of an array must be alike: {} and {}", typeText(first), typeText(part)), span);
        return false;
    }
    ++array.dimensions[0];
    if (part.type == FlatType::Real) array.type = FlatType::Real;
    array.elements.insert(array.elements.end(), part.elements.begin(), part.elements.end());
    array.texts.insert(array.texts.end(), part.texts.begin(), part.texts.end());
    return true;
}

std::optional<Value> Translator::range(const Expression& expression, const Scope& scope) {
    if (expression.kind != Kind::Range) {
        if (auto all = valuesOfType(expression, scope)) return all;
        auto value = translate(expression, scope);
        if (value && value->dimensions.size() == 1) return value;
        if (value)
            work_.messages.error(phrase("a range is expected, not {}", typeText(*value)), expression.span,
                                 phrase("write: first:last"));
        return std::nullopt;
    }
    Value result;
    result.type = FlatType::Integer;
    double limits[3]{};  // first, step, last
    for (std::size_t i = 0; i < expression.operands.size(); ++i) {
        const auto limit = translate(expression.operands[i], scope);
        if (!limit) return std::nullopt;
        const bool isOrdered = limit->isNumeric() || !limit->enumeration.empty() || limit->type == FlatType::Boolean;
        const auto number = limit->isScalar() && isOrdered ? constantNumber(limit->elements[0], true) : std::nullopt;
        if (!number) {
            work_.messages.error(phrase("the limits of a range must be numbers that are known before the simulation"),
                                 expression.operands[i].span, phrase("use a parameter or a constant"));
            return std::nullopt;
        }
        if (limit->type != FlatType::Integer) result.type = limit->type;
        result.enumeration = limit->enumeration;
        limits[i] = *number;
    }
    const double first = limits[0];
    const double step = expression.operands.size() == 3 ? limits[1] : 1;
    const double last = limits[expression.operands.size() - 1];
    const double steps = std::floor((last - first) / step * (1 + 1e-12) + 1e-12);
    if (step == 0 || !(steps < static_cast<double>(Instantiator::mostScalars))) {
        work_.messages.error(phrase("the range has more than {} values", Instantiator::mostScalars), expression.span);
        return std::nullopt;
    }
    const int count = steps < 0 ? 0 : static_cast<int>(steps) + 1;
    result.dimensions = {count};
    if (!spend(static_cast<std::size_t>(count), expression.span)) return std::nullopt;
    for (int i = 0; i < count; ++i) result.elements.push_back(work_.pool.constant(first + i * step));
    return result;
}

// ------------------------------------------------------------------------------------------------ derivatives

/// der() of an expression by the chain rule; der(der(x)) gets a variable of its own.
ExpressionId Translator::derivative(ExpressionId of, const Span& span) {
    return work_.pool.timeDerivative(of, [&](const ExpressionNode& leaf) -> ExpressionId {
        if (!work_.isContinuous(leaf.variable)) return work_.pool.constant(0);
        if (leaf.operation == Operation::Variable) return work_.pool.derivativeOf(leaf.variable);
        const FlatVariable of1 = work_.variable(leaf.variable);
        const std::string name = fmt::format("der({})", of1.name);
        const VariableId known = work_.model.find(name);
        if (known.valid()) return work_.pool.derivativeOf(known);
        const VariableId id{static_cast<std::uint32_t>(work_.model.variables.size())};
        FlatVariable velocity;
        velocity.name = name;
        velocity.description = fmt::format("derivative of {}", of1.name);
        velocity.isProtected = true;
        velocity.declared = of1.declared;
        if (!of1.unit.empty()) velocity.unit = of1.unit == "1" ? "1/s" : of1.unit + "/s";
        VariableRecord record = work_.records[leaf.variable.value];
        record.causality = syntax::Causality::None;
        record.isBound = true;
        Instance& component = record.owner->component();
        work_.model.byName.emplace(name, id);
        work_.model.variables.push_back(std::move(velocity));
        work_.records.push_back(record);
        work_.model.equations.push_back(
            {work_.pool.variable(id), work_.pool.derivativeOf(leaf.variable), span, component.name, false});
        ++component.unknowns;
        ++component.equations;
        return work_.pool.derivativeOf(id);
    });
}

}  // namespace analogon
