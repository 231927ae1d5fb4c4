#include "core/flat/value.hpp"

namespace analogon {

Value Value::part(int subscript) const {
    Value result;
    result.type = type;
    result.enumeration = enumeration;
    result.dimensions.assign(dimensions.begin() + 1, dimensions.end());
    if (isRecord()) {
        result.record = record;
        for (const auto& [name, value] : members) result.members.emplace_back(name, value.part(subscript));
        return result;
    }
    const auto count = static_cast<std::ptrdiff_t>(elementCount(result.dimensions));
    const std::ptrdiff_t first = (subscript - 1) * count;
    if (type == FlatType::String)
        result.texts.assign(texts.begin() + first, texts.begin() + first + count);
    else
        result.elements.assign(elements.begin() + first, elements.begin() + first + count);
    return result;
}

Value* Value::member(std::string_view name) {
    for (auto& [own, value] : members)
        if (own == name) return &value;
    return nullptr;
}

std::size_t elementCount(const std::vector<int>& dimensions) {
    std::size_t count = 1;
    for (int d : dimensions) count *= static_cast<std::size_t>(d);
    return count;
}

std::string sizeText(const std::vector<int>& dimensions) {
    if (dimensions.empty()) return {};
    std::string text = "[";
    for (std::size_t i = 0; i < dimensions.size(); ++i) {
        if (i) text += ',';
        text += std::to_string(dimensions[i]);
    }
    return text + "]";
}

std::vector<int> subscriptsOf(std::size_t element, const std::vector<int>& dimensions) {
    std::vector<int> subscripts(dimensions.size());
    for (std::size_t d = dimensions.size(); d-- > 0;) {
        const auto extent = static_cast<std::size_t>(dimensions[d]);
        subscripts[d] = static_cast<int>(element % extent) + 1;
        element /= extent;
    }
    return subscripts;
}

const char* typeName(FlatType type) {
    switch (type) {
        case FlatType::Real:
            return "Real";
        case FlatType::Integer:
            return "Integer";
        case FlatType::Boolean:
            return "Boolean";
        case FlatType::String:
            return "String";
    }
    return "";
}

std::string typeText(const Value& value) {
    if (value.isRecord()) return value.record + sizeText(value.dimensions);
    if (value.isObject()) return "ExternalObject";
    if (value.isFunction()) return "function";
    return (value.enumeration.empty() ? typeName(value.type) : value.enumeration) + sizeText(value.dimensions);
}

}  // namespace analogon
