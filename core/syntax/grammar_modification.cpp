#include <fmt/format.h>

#include <utility>

#include "core/syntax/grammar.hpp"

namespace analogon::syntax {

std::vector<Modification> Grammar::classModification() {
    const Cursor::Nesting nesting(cursor_);
    std::vector<Modification> arguments;
    cursor_.expect("(", "before the modifications");
    if (cursor_.take(")")) return arguments;
    do {
        arguments.push_back(argument());
    } while (cursor_.take(","));
    cursor_.expect(")", "to close the modifications");
    return arguments;
}

Modification Grammar::argument() {
    const std::size_t begin = cursor_.index();
    const bool isRedeclare = cursor_.take("redeclare");
    Modification modification;
    modification.each = cursor_.take("each");
    modification.isFinal = cursor_.take("final");
    modification.isReplaceable = cursor_.take("replaceable");
    if (cursor_.at("break")) {
        modification = breakModification();
    } else if (isRedeclare || modification.isReplaceable) {
        modification = redeclaration(std::move(modification), isRedeclare);
    } else {
        if (!cursor_.atIdentifier()) {
            cursor_.faultExpected(phrase("a modification"),
                                  cursor_.at("each") ? phrase("\"each\" stands before \"final\"") : Text());
        }
        modification.name = typeName();
        if (cursor_.at("[")) {
            cursor_.fault(phrase("a modification cannot name one element of an array"), cursor_.here(),
                          phrase("modify the whole array: x(start={{1, 2, 3}})"));
        }
        modificationValue(modification);
        modification.description = description();
    }
    modification.span = cursor_.spanFrom(begin);
    return modification;
}

/// `[( … )] [= value]` behind the name.
void Grammar::modificationValue(Modification& modification) {
    if (cursor_.at("(")) {
        modification.hasArguments = true;
        modification.arguments = classModification();
    }
    if (cursor_.at(":="))
        cursor_.fault(phrase("\":=\" is an assignment"), cursor_.here(), phrase("a value is given with \"=\""));
    if (!cursor_.take("=")) return;
    if (cursor_.at("break")) {
        Expression none;
        none.kind = Expression::Kind::Break;
        none.span = cursor_.here();
        cursor_.next();
        modification.value = std::move(none);
    } else {
        modification.value = expression();
    }
}

/// `break x` or `break connect(a, b)`: what is not inherited (section 7.4).
Modification Grammar::breakModification() {
    Modification modification;
    modification.isBreak = true;
    cursor_.next();
    if (cursor_.at("connect")) {
        const Equation connection = connectEquation();
        modification.brokenConnect = {connection.left, connection.right};
        return modification;
    }
    const Token name = cursor_.expectIdentifier("the name of the element that is left out");
    modification.name.parts.push_back({std::string(cursor_.textOf(name)), {}, cursor_.spanOf(name)});
    modification.name.span = cursor_.spanOf(name);
    return modification;
}

Modification Grammar::redeclaration(Modification modification, bool isRedeclare) {
    const std::size_t begin = cursor_.index();
    if (atClassDefinition()) {
        const auto definition = classDefinition();
        if (!definition->isShort) {
            cursor_.fault(phrase("a redeclared class is given as \"M = Other\""), definition->nameSpan);
        }
        definition->isRedeclare = isRedeclare;
        definition->isReplaceable = modification.isReplaceable;
        definition->isFinal = modification.isFinal;
        if (modification.isReplaceable) {
            constrainingClause(definition->constrainedBy, definition->constrainedByModifications);
        }
        modification.name.parts.push_back({definition->name, {}, definition->nameSpan});
        modification.name.span = definition->nameSpan;
        modification.redeclaredClass = definition;
        return modification;
    }
    Component component = componentPrototype();
    component.isRedeclare = isRedeclare;
    component.isReplaceable = modification.isReplaceable;
    component.isFinal = modification.isFinal;
    const Component prototype = component;
    declaration(component, prototype);
    if (modification.isReplaceable) {
        constrainingClause(component.constrainedBy, component.constrainedByModifications);
    }
    component.clauseSpan = cursor_.spanFrom(begin);
    modification.name.parts.push_back({component.name, {}, component.nameSpan});
    modification.name.span = component.nameSpan;
    modification.redeclaredComponent = std::make_shared<const Component>(std::move(component));
    return modification;
}

void Grammar::constrainingClause(std::optional<Name>& base, std::vector<Modification>& modifications) {
    if (!cursor_.take("constrainedby")) return;
    base = typeName();
    if (cursor_.at("(")) modifications = classModification();
}

/// "a text" or "a text " + "in parts"; empty when there is none.
std::string Grammar::description() {
    std::string text;
    if (cursor_.peek().kind != Token::Kind::String) return text;
    do {
        if (cursor_.peek().kind != Token::Kind::String) cursor_.faultExpected(phrase("a string behind \"+\""));
        text += unescape(cursor_.next());
    } while (cursor_.take("+"));
    return text;
}

std::optional<Annotation> Grammar::annotation() {
    if (!cursor_.at("annotation")) return std::nullopt;
    const std::size_t begin = cursor_.index();
    cursor_.next();
    Annotation result;
    ++annotationDepth_;
    result.arguments = classModification();
    --annotationDepth_;
    result.span = cursor_.spanFrom(begin);
    return result;
}

}  // namespace analogon::syntax
