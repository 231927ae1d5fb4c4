#include "core/syntax/ast.hpp"

namespace analogon::syntax {

std::string Name::text() const {
    std::string result;
    if (absolute) result += '.';
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (i > 0) result += '.';
        result += parts[i].identifier;
    }
    return result;
}

const Modification* Annotation::find(std::string_view name) const {
    for (const Modification& argument : arguments) {
        if (argument.name.parts.size() == 1 && argument.name.parts.front().identifier == name) return &argument;
    }
    return nullptr;
}

const char* keyword(ClassDefinition::Restriction restriction) {
    switch (restriction) {
        case ClassDefinition::Restriction::Model:
            return "model";
        case ClassDefinition::Restriction::Block:
            return "block";
        case ClassDefinition::Restriction::Connector:
            return "connector";
        case ClassDefinition::Restriction::Record:
            return "record";
        case ClassDefinition::Restriction::Package:
            return "package";
        case ClassDefinition::Restriction::Type:
            return "type";
        case ClassDefinition::Restriction::Class:
            return "class";
        case ClassDefinition::Restriction::Function:
            return "function";
        case ClassDefinition::Restriction::Operator:
            return "operator";
    }
    return "class";
}

}  // namespace analogon::syntax
