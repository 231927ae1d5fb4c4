#include "core/diagram/references.hpp"

namespace analogon {

using syntax::Component;
using syntax::Equation;
using syntax::Expression;
using syntax::Modification;

void FirstNames::visit(const Expression& e) {
    if (e.kind == Expression::Kind::Reference && !e.name.absolute && !e.name.parts.empty() &&
        !shadowed_.contains(e.name.parts.front().identifier))
        found.push_back(&e.name);
    for (const syntax::NamePart& part : e.name.parts)
        for (const Expression& subscript : part.subscripts) visit(subscript);
    for (const auto& [name, range] : e.iterators) {
        for (const Expression& r : range) visit(r);
        shadowed_.insert(name);
    }
    for (const Expression& operand : e.operands) visit(operand);
    for (const syntax::NamedArgument& argument : e.named) visit(argument.value);
    for (const auto& iterator : e.iterators) shadowed_.erase(shadowed_.find(iterator.first));
}

void FirstNames::visit(const Modification& m) {
    if (m.value) visit(*m.value);
    for (const Modification& a : m.arguments) visit(a);
    if (m.redeclaredComponent) visit(*m.redeclaredComponent);
}

void FirstNames::visit(const Component& c) {
    for (const Expression& dimension : c.dimensions) visit(dimension);
    for (const Modification& m : c.modifications) visit(m);
    if (c.binding) visit(*c.binding);
    if (c.condition) visit(*c.condition);
}

void FirstNames::visit(const Equation& e) {
    visit(e.left);
    visit(e.right);
    for (const Equation::Iterator& iterator : e.iterators) {
        visit(iterator.range);
        shadowed_.insert(iterator.name);
    }
    for (const Equation::Branch& branch : e.branches) {
        if (branch.condition) visit(*branch.condition);
        for (const Equation& inner : branch.body) visit(inner);
    }
    for (const Equation& inner : e.body) visit(inner);
    for (const Equation::Iterator& iterator : e.iterators) shadowed_.erase(shadowed_.find(iterator.name));
}

}  // namespace analogon
