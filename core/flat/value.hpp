#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/flat/expression.hpp"
#include "core/flat/flat_model.hpp"

namespace analogon {

/// What an expression of a class means: a scalar or a rectangular array, row-major.
struct Value {
    FlatType type{FlatType::Real};
    std::vector<int> dimensions;         // empty: a scalar
    std::vector<ExpressionId> elements;  // String: empty ids
    std::vector<std::string> texts;      // String only
    /// Of a text that is known no sooner than the simulation: what it may be, and when. `isOpen` without: who knows.
    std::vector<std::pair<std::string, ExpressionId>> choices;
    bool isOpen{};
    std::string enumeration;  // qualified class of an enumeration value (its type is Integer)
    std::string record;       // qualified class of a record; its dimensions lead those of the members
    std::vector<std::pair<std::string, Value>> members;
    const LibraryClass* function{};  // a function as a value; members: the arguments that it was given
    int object{-1};                  // an external object: its number among Flattening::tables

    bool isRecord() const { return !record.empty(); }
    bool isObject() const { return object >= 0; }
    bool isFunction() const { return function != nullptr; }
    Value* member(std::string_view name);
    const Value* member(std::string_view name) const { return const_cast<Value*>(this)->member(name); }
    bool isScalar() const { return dimensions.empty(); }
    std::size_t size() const { return type == FlatType::String ? texts.size() : elements.size(); }
    bool isNumeric() const {
        return !isRecord() && !isObject() && !isFunction() && (type == FlatType::Real || type == FlatType::Integer) &&
               enumeration.empty();
    }

    static Value scalar(FlatType type, ExpressionId element) {
        Value value;
        value.type = type;
        value.elements = {element};
        return value;
    }
    static Value text(std::string text) {
        Value value;
        value.type = FlatType::String;
        value.texts = {std::move(text)};
        return value;
    }
    /// The part at the leading subscript (1-based).
    Value part(int subscript) const;
};

/// Product of the dimensions; 1 for a scalar.
std::size_t elementCount(const std::vector<int>& dimensions);
/// "[2,3]", empty for a scalar.
std::string sizeText(const std::vector<int>& dimensions);
/// The subscripts (1-based) of an element in row-major order.
std::vector<int> subscriptsOf(std::size_t element, const std::vector<int>& dimensions);
/// "Real", "Boolean", "Integer[3]", "String" or the enumeration's name.
std::string typeText(const Value& value);
const char* typeName(FlatType type);

}  // namespace analogon
