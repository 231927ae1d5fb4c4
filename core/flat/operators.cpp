#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/flat/executor.hpp"
#include "core/flat/translator.hpp"

/// Operators on scalars and arrays (Modelica 3.6, sections 3.4, 3.5 and 10.6).
namespace analogon {
namespace {

struct Symbol {
    Operation operation;
    enum class Family { Arithmetic, Relation, Logic } family;
    bool elementwise;  // written with a dot
};

std::optional<Symbol> symbolOf(const std::string& text) {
    using enum Operation;
    using enum Symbol::Family;
    if (text == "+") return Symbol{Add, Arithmetic, false};
    if (text == "-") return Symbol{Subtract, Arithmetic, false};
    if (text == "*") return Symbol{Multiply, Arithmetic, false};
    if (text == "/") return Symbol{Divide, Arithmetic, false};
    if (text == "^") return Symbol{Power, Arithmetic, false};
    if (text == ".+") return Symbol{Add, Arithmetic, true};
    if (text == ".-") return Symbol{Subtract, Arithmetic, true};
    if (text == ".*") return Symbol{Multiply, Arithmetic, true};
    if (text == "./") return Symbol{Divide, Arithmetic, true};
    if (text == ".^") return Symbol{Power, Arithmetic, true};
    if (text == "<") return Symbol{Less, Relation, false};
    if (text == "<=") return Symbol{LessEqual, Relation, false};
    if (text == ">") return Symbol{Greater, Relation, false};
    if (text == ">=") return Symbol{GreaterEqual, Relation, false};
    if (text == "==") return Symbol{Equal, Relation, false};
    if (text == "<>") return Symbol{NotEqual, Relation, false};
    if (text == "and") return Symbol{And, Logic, false};
    if (text == "or") return Symbol{Or, Logic, false};
    return std::nullopt;
}

/// Inner products over the last dimension of a and the first of b: vectors and matrices.
std::optional<Value> product(Flattening& work, const Span& span, const Value& a, const Value& b, FlatType type) {
    ExpressionPool& pool = work.pool;
    Value result;
    result.type = type;
    const std::size_t inner = static_cast<std::size_t>(b.dimensions[0]);
    const std::size_t rows = a.dimensions.size() == 2 ? static_cast<std::size_t>(a.dimensions[0]) : 1;
    const std::size_t columns = b.dimensions.size() == 2 ? static_cast<std::size_t>(b.dimensions[1]) : 1;
    if (!work.translator->spend(rows * columns * inner, span)) return std::nullopt;
    if (a.dimensions.size() == 2) result.dimensions.push_back(a.dimensions[0]);
    if (b.dimensions.size() == 2) result.dimensions.push_back(b.dimensions[1]);
    for (std::size_t i = 0; i < rows; ++i)
        for (std::size_t j = 0; j < columns; ++j) {
            ExpressionId sum = pool.constant(0);
            for (std::size_t k = 0; k < inner; ++k)
                sum = pool.add(sum, pool.multiply(a.elements[i * inner + k], b.elements[k * columns + j]));
            result.elements.push_back(sum);
        }
    return result;
}

Value elementwise(ExpressionPool& pool, Operation operation, const Value& a, const Value& b, FlatType type) {
    Value result;
    result.type = type;
    result.dimensions = a.isScalar() ? b.dimensions : a.dimensions;
    const std::size_t count = elementCount(result.dimensions);
    for (std::size_t i = 0; i < count; ++i)
        result.elements.push_back(
            pool.binary(operation, a.elements[a.isScalar() ? 0 : i], b.elements[b.isScalar() ? 0 : i]));
    return result;
}

/// A square matrix times itself; its power 0 is the identity (section 10.6.8).
std::optional<Value> matrixPower(Flattening& work, const Span& span, const Value& a, int power) {
    const auto n = static_cast<std::size_t>(a.dimensions[0]);
    std::optional<Value> result = a;
    for (std::size_t k = 0; k < n * n; ++k) result->elements[k] = work.pool.constant(k % (n + 1) == 0 ? 1 : 0);
    for (int k = 0; k < power && result; ++k) result = product(work, span, *result, a, a.type);
    return result;
}

/// One text behind the other.
Value joined(const Value& a, const Value& b) {
    Value both = Value::text(a.texts[0] + b.texts[0]);
    both.isOpen = a.isOpen || b.isOpen;
    if (a.isOpen && b.isOpen) return both;
    for (const auto& [text, condition] : a.choices) both.choices.emplace_back(text + b.texts[0], condition);
    for (const auto& [text, condition] : b.choices) both.choices.emplace_back(a.texts[0] + text, condition);
    return both;
}

std::optional<Value> arithmetic(Flattening& work, const std::string& text, const Symbol& symbol, const Value& a,
                                const Value& b, const Span& span) {
    using enum Operation;
    if (a.type == FlatType::String && b.type == FlatType::String && a.isScalar() && b.isScalar() && text == "+")
        return joined(a, b);
    const auto refuse = [&](const Text& hint) {
        work.messages.error(phrase("'{}' cannot be applied to {} and {}", text, typeText(a), typeText(b)), span, hint);
        return std::nullopt;
    };
    if (!a.isNumeric() || !b.isNumeric()) return refuse(phrase("both sides must be numbers"));
    if (!work.translator->spend(std::max(a.size(), b.size()), span)) return std::nullopt;
    const bool integer = a.type == FlatType::Integer && b.type == FlatType::Integer;
    const bool staysInteger = symbol.operation != Divide && symbol.operation != Power;
    const FlatType type = integer && staysInteger ? FlatType::Integer : FlatType::Real;
    if (a.isScalar() && b.isScalar())
        return Value::scalar(type, work.pool.binary(symbol.operation, a.elements[0], b.elements[0]));
    if (symbol.elementwise) {
        if (a.isScalar() || b.isScalar() || a.dimensions == b.dimensions)
            return elementwise(work.pool, symbol.operation, a, b, type);
        return refuse(phrase("the sizes must agree"));
    }
    switch (symbol.operation) {
        case Add:
        case Subtract:
            if (a.dimensions == b.dimensions) return elementwise(work.pool, symbol.operation, a, b, type);
            return refuse(a.isScalar() || b.isScalar() ? phrase("to apply it to each element write '.{}'", text)
                                                       : phrase("the sizes must agree"));
        case Multiply:
            if (a.isScalar() || b.isScalar()) return elementwise(work.pool, Multiply, a, b, type);
            if (a.dimensions.size() <= 2 && b.dimensions.size() <= 2 && a.dimensions.back() == b.dimensions.front())
                return product(work, span, a, b, type);
            return refuse(phrase("the inner sizes of a product must agree; '.*' multiplies element by element"));
        case Divide:
            if (b.isScalar()) return elementwise(work.pool, Divide, a, b, type);
            return refuse(phrase("to divide element by element write './'"));
        default: {
            const bool isWhole = b.isScalar() && b.type == FlatType::Integer;
            const double power = isWhole ? work.translator->constantNumber(b.elements[0], true).value_or(-1) : -1;
            const bool isSquare = a.dimensions.size() == 2 && a.dimensions[0] == a.dimensions[1];
            if (isSquare && power >= 0) return matrixPower(work, span, a, static_cast<int>(power));
            return refuse(phrase("to apply it to each element write '.^'"));
        }
    }
}

double holds(const Symbol& symbol, const std::string& a, const std::string& b) {
    return apply(symbol.operation, a.compare(b), 0);
}

/// Where one text may be one of several during the simulation: whether it is one for which the relation holds.
std::optional<Value> openRelation(Flattening& work, const Symbol& symbol, const Value& a, const Value& b,
                                  const Span& span) {
    const Value& open = a.isOpen ? a : b;
    if ((a.isOpen && b.isOpen) || open.choices.empty()) {
        work.messages.error(phrase("what '{}' is changes during the simulation: it cannot be compared", open.texts[0]),
                            span, phrase("compare the values instead of their texts"));
        return std::nullopt;
    }
    ExpressionId any = work.pool.constant(0);
    for (const auto& [text, condition] : open.choices)
        if (holds(symbol, a.isOpen ? text : a.texts[0], b.isOpen ? text : b.texts[0]) != 0)
            any = work.pool.binary(Operation::Or, any, condition);
    return Value::scalar(FlatType::Boolean, any);
}

std::optional<Value> relation(Flattening& work, const std::string& text, const Symbol& symbol, const Value& a,
                              const Value& b, const Span& span) {
    if (a.type == FlatType::String && b.type == FlatType::String && a.isScalar() && b.isScalar())
        return a.isOpen || b.isOpen
                   ? openRelation(work, symbol, a, b, span)
                   : Value::scalar(FlatType::Boolean, work.pool.constant(holds(symbol, a.texts[0], b.texts[0])));
    const bool comparable = (a.isNumeric() && b.isNumeric()) || (a.type == b.type && a.enumeration == b.enumeration);
    if (!comparable || !a.isScalar() || !b.isScalar()) {
        work.messages.error(phrase("'{}' cannot compare {} with {}", text, typeText(a), typeText(b)), span);
        return std::nullopt;
    }
    return Value::scalar(FlatType::Boolean, work.pool.binary(symbol.operation, a.elements[0], b.elements[0]));
}

}  // namespace

std::optional<Value> combine(Flattening& work, const std::string& operation, const Value& a, const Value& b,
                             const Span& span) {
    const auto symbol = symbolOf(operation);
    if (!symbol) {
        work.messages.error(phrase("the operator '{}' is not supported", operation), span);
        return std::nullopt;
    }
    for (const Value* side : {&a, &b})
        if (side->isRecord())
            if (const LibraryClass* type = work.library.find(side->record); type && hasOperators(*type))
                return Executor(work).operate(operation, {a, b}, span);
    if (symbol->family == Symbol::Family::Arithmetic) return arithmetic(work, operation, *symbol, a, b, span);
    if (symbol->family == Symbol::Family::Relation) return relation(work, operation, *symbol, a, b, span);
    if (a.type != FlatType::Boolean || b.type != FlatType::Boolean || a.dimensions != b.dimensions) {
        work.messages.error(phrase("'{}' needs Boolean values, not {} and {}", operation, typeText(a), typeText(b)),
                            span);
        return std::nullopt;
    }
    return elementwise(work.pool, symbol->operation, a, b, FlatType::Boolean);
}

}  // namespace analogon
