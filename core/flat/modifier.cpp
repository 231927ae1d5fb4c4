#include "core/flat/modifier.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace analogon {

const Modifier* Modifier::find(std::string_view name) const {
    for (const auto& [childName, modifier] : children)
        if (childName == name) return &modifier;
    return nullptr;
}

Modifier& Modifier::child(const std::string& name) {
    for (auto& [childName, modifier] : children)
        if (childName == name) return modifier;
    return children.emplace_back(name, Modifier{}).second;
}

void Modifier::markEach() {
    each = true;
    for (auto& [name, modifier] : children) modifier.markEach();
}

namespace {

void addArguments(Modifier& target, const std::vector<syntax::Modification>& arguments, const Scope& scope,
                  Messages& messages);

void addArgument(Modifier& target, const syntax::Modification& argument, const Scope& scope, Messages& messages) {
    if (argument.isBreak)
        return messages.error(phrase("\"break\" is not supported"), argument.span,
                              phrase("inherit a class without the element instead"));
    Modifier* node = &target;
    for (const auto& part : argument.name.parts) node = &node->child(part.identifier);
    if (node == &target) return;
    if (argument.value && node->value.valid()) {
        messages.error(phrase("'{}' is modified twice", argument.name.text()), argument.span,
                       phrase("keep one of the two modifications"));
        return;
    }
    if (argument.value) node->value = {&*argument.value, scope, {}, {}};
    node->each = node->each || argument.each;
    node->isFinal = node->isFinal || argument.isFinal;
    node->span = argument.span;
    if (argument.redeclaredComponent || argument.redeclaredClass) {
        node->redeclaredComponent = argument.redeclaredComponent.get();
        node->redeclaredClass = argument.redeclaredClass.get();
        node->redeclareScope = scope;
    }
    if (argument.redeclaredComponent) {
        const syntax::Component& component = *argument.redeclaredComponent;
        if (component.binding) node->value = {&*component.binding, scope, {}, {}};
        Modifier own = modifierOf(component.modifications, scope, messages);
        if (component.constrainedBy)
            own = overConstraint(std::move(own), modifierOf(component.constrainedByModifications, scope, messages),
                                 messages);
        node->children = std::move(own.children);
    }
    addArguments(*node, argument.arguments, scope, messages);
    if (argument.each) node->markEach();
}

void addArguments(Modifier& target, const std::vector<syntax::Modification>& arguments, const Scope& scope,
                  Messages& messages) {
    for (const auto& argument : arguments) addArgument(target, argument, scope, messages);
}

}  // namespace

Modifier modifierOf(const std::vector<syntax::Modification>& arguments, const Scope& scope, Messages& messages) {
    Modifier result;
    addArguments(result, arguments, scope, messages);
    return result;
}

namespace {

/// What stands in the declaration is not what its constraining clause would forbid.
void yieldTo(const Modifier& own, Modifier& constraint) {
    constraint.isFinal = false;
    for (const auto& [name, child] : own.children)
        for (auto& [known, below] : constraint.children)
            if (known == name) yieldTo(child, below);
}

}  // namespace

Modifier overConstraint(const Modifier& own, Modifier constraint, Messages& messages) {
    yieldTo(own, constraint);
    return merge(own, std::move(constraint), messages);
}

namespace {

/// The value of a record as a whole stands above what was said of its members before; attributes of a number stay.
void forgetMembers(Modifier& modifier) {
    for (auto& [name, child] : modifier.children) {
        if (std::find(attributeNames.begin(), attributeNames.end(), name) != attributeNames.end()) continue;
        if (!child.isFinal) child.value = {};
        forgetMembers(child);
    }
}

}  // namespace

Modifier merge(const Modifier& outer, Modifier inner, Messages& messages, const std::string& name) {
    if (outer.empty()) return inner;
    // of a redeclaration that is redeclared again its constraining clause stays in force, if it has one
    const syntax::Component* const before = outer.redeclaredComponent ? inner.redeclaredComponent : nullptr;
    if (before && before->constrainedBy) {
        inner.value = {};
        inner.children = modifierOf(before->constrainedByModifications, inner.redeclareScope, messages).children;
    }
    if (inner.isFinal) {
        messages.error(phrase("'{}' is final and cannot be modified", name), outer.span,
                       phrase("remove the modification; the value is fixed where the element is declared"));
        return inner;
    }
    if (outer.value.valid()) {
        forgetMembers(inner);
        inner.value = outer.value;
        inner.each = outer.each;
    }
    if (outer.redeclaredComponent || outer.redeclaredClass) {
        const bool isSettled = (inner.redeclaredComponent && !inner.redeclaredComponent->isReplaceable) ||
                               (inner.redeclaredClass && !inner.redeclaredClass->isReplaceable);
        if (isSettled)
            messages.error(phrase("'{}' was redeclared before, and is not replaceable since", name), outer.span,
                           phrase("write \"redeclare replaceable\" where it is redeclared first"));
        inner.redeclaredComponent = outer.redeclaredComponent;
        inner.redeclaredClass = outer.redeclaredClass;
        inner.redeclareScope = outer.redeclareScope;
    }
    inner.isFinal = outer.isFinal;
    if (outer.span.valid()) inner.span = outer.span;
    for (const auto& [childName, child] : outer.children) {
        Modifier& target = inner.child(childName);
        target = merge(child, std::move(target), messages, childName);
    }
    return inner;
}

Modifier elementModifier(const Modifier& ofArray, const std::vector<int>& subscripts) {
    Modifier result = ofArray;
    if (result.value.valid() && !result.each)
        result.value.subscripts.insert(result.value.subscripts.end(), subscripts.begin(), subscripts.end());
    for (auto& [name, child] : result.children) child = elementModifier(child, subscripts);
    return result;
}

}  // namespace analogon
