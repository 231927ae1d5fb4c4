#include "core/flat/class_rules.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <unordered_map>

namespace analogon {
namespace {

using Definition = syntax::ClassDefinition;
using Restriction = Definition::Restriction;
using StatementKind = syntax::Equation::Kind;

constexpr std::array<std::string_view, 4> predefined{"Real", "Integer", "Boolean", "String"};
constexpr std::array<std::string_view, 5> attributes{"quantity", "min", "max", "start", "fixed"};

template <class List>
bool holds(const List& list, std::string_view name) {
    return std::find(list.begin(), list.end(), name) != list.end();
}

bool isVariable(const syntax::Component& component) { return component.variability != syntax::Variability::Constant; }

bool hasSections(const std::vector<syntax::EquationSection>& sections) {
    return std::any_of(sections.begin(), sections.end(),
                       [](const syntax::EquationSection& section) { return !section.equations.empty(); });
}

/// The table of section 7.1.3: what a class of this kind may extend. `class` stands for any of them.
bool mayExtend(Restriction derived, Restriction base) {
    using enum Definition::Restriction;
    if (base == derived || base == Class || derived == Class) return true;
    switch (derived) {
        case Connector:
            return base == Record || base == Type;
        case Block:
            return base == Record;
        case Model:
            return base == Record || base == Block;
        default:
            return false;
    }
}

}  // namespace

bool isLikePackage(const Definition& definition) {
    return definition.restriction == Restriction::Package ||
           (std::none_of(definition.components.begin(), definition.components.end(), isVariable) &&
            !hasSections(definition.equationSections) && !hasSections(definition.algorithmSections));
}

bool isProtectedClass(const LibraryClass& of) { return of.definition->isProtected; }

void ClassRules::refuse(const Text& message, const Span& span, const Text& hint) {
    work_.messages.error(message, span, hint);
}

void ClassRules::check(const LibraryClass& definition) {
    if (!checked_.insert(&definition).second) return;
    names(definition);
    if (definition.definition->isEnumeration) return literals(definition);
    content(definition);
    bases(definition);
    imports(definition);
    if (definition.definition->restriction == Restriction::Function) function(definition);
    for (const syntax::EquationSection& section : definition.definition->algorithmSections)
        statements(section.equations, *definition.definition, false, false);
}

void ClassRules::names(const LibraryClass& definition) {
    const auto judge = [&](std::string_view name, const Span& span) {
        if (holds(predefined, name))
            refuse(phrase("'{}' is a type of the language; nothing else may have this name", name), span,
                   phrase("give it another name"));
    };
    judge(definition.definition->name, definition.definition->nameSpan);
    for (const syntax::Component& component : definition.definition->components)
        judge(component.name, component.nameSpan);
    for (const auto& local : definition.definition->classes) judge(local->name, local->nameSpan);
}

void ClassRules::literals(const LibraryClass& definition) {
    const Definition& tree = *definition.definition;
    for (auto literal = tree.enumeration.begin(); literal != tree.enumeration.end(); ++literal) {
        if (holds(attributes, *literal))
            refuse(phrase("'{}' cannot be a value of the enumeration {}: it is an attribute of all enumerations",
                          *literal, definition.qualifiedName),
                   tree.nameSpan, phrase("give it another name"));
        if (std::find(tree.enumeration.begin(), literal, *literal) != literal)
            refuse(
                phrase("'{}' stands twice among the values of the enumeration {}", *literal, definition.qualifiedName),
                tree.nameSpan, phrase("give it another name"));
    }
}

/// Records and connectors hold public variables and nothing that acts.
void ClassRules::content(const LibraryClass& definition) {
    const Definition& tree = *definition.definition;
    if (tree.restriction != Restriction::Record && tree.restriction != Restriction::Connector) return;
    for (const auto* sections : {&tree.equationSections, &tree.algorithmSections})
        for (const syntax::EquationSection& section : *sections)
            if (!section.equations.empty())
                refuse(phrase("a {} has no equations and no algorithms", keyword(tree.restriction)), section.keyword,
                       phrase("write them in the model that holds it"));
    for (const syntax::Component& component : tree.components) {
        const bool isDirected =
            tree.restriction == Restriction::Record && component.causality != syntax::Causality::None;
        if (!component.isProtected && !component.isInner && !component.isOuter && !isDirected) continue;
        refuse(phrase("'{}' cannot be {} in a {}", component.name,
                      component.isProtected                             ? "protected"
                      : component.isInner                               ? "inner"
                      : component.isOuter                               ? "outer"
                      : component.causality == syntax::Causality::Input ? "input"
                                                                        : "output",
                      keyword(tree.restriction)),
               component.nameSpan, phrase("remove the prefix, or declare it in the model that holds it"));
    }
}

void ClassRules::bases(const LibraryClass& definition) {
    const Definition& tree = *definition.definition;
    const std::vector<const LibraryClass*> found = work_.library.bases(definition);
    for (const LibraryClass* base : found) {
        Span span = tree.nameSpan;
        for (const syntax::Extends& clause : tree.bases)
            if (!clause.base.parts.empty() && clause.base.parts.back().identifier == base->definition->name)
                span = clause.base.span;
        const Definition& other = *base->definition;
        if (!mayExtend(tree.restriction, other.restriction))
            refuse(phrase("'{}' is a {} and cannot extend {}, which is a {}", definition.qualifiedName,
                          keyword(tree.restriction), base->qualifiedName, keyword(other.restriction)),
                   span);
        const bool isPlain =
            !other.isShort || (other.shortDimensions.empty() && other.shortCausality == syntax::Causality::None);
        if (!isPlain && (!tree.components.empty() || found.size() > 1))
            refuse(phrase("'{}' is an array or has a prefix: a class that extends it can hold nothing else",
                          base->qualifiedName),
                   span, phrase("declare a component of it instead"));
        const bool isModel = other.restriction == Restriction::Model || other.restriction == Restriction::Block ||
                             other.restriction == Restriction::Class;
        if (isModel && other.isReplaceable && !tree.isShort && !tree.isRedeclare && !tree.extendsItself &&
            base != &definition)
            refuse(phrase("the base class '{}' is replaceable", base->qualifiedName), span,
                   phrase("extend a class that cannot be replaced"));
    }
}

void ClassRules::imports(const LibraryClass& definition) {
    std::unordered_map<std::string_view, const syntax::Import*> known;
    for (const syntax::Import& import : definition.definition->imports) {
        if (!import.wildcard && !known.try_emplace(import.alias, &import).second) {
            refuse(phrase("two imports have the same name '{}'", import.alias), import.span,
                   phrase("name one of them: import NAME = …"));
            continue;
        }
        syntax::Name holder = import.name;
        if (!import.wildcard) holder.parts.pop_back();
        const LibraryClass* const outside = holder.parts.empty() ? nullptr : work_.library.lookup(holder, "");
        const LibraryClass* const meant = work_.library.lookup(import.name, "");
        const bool isPackage = meant && meant->definition->restriction == Restriction::Package;
        if (outside && !isPackage && outside->definition->restriction != Restriction::Package)
            refuse(phrase("'{}' is no package and no element of a package; it cannot be imported", import.name.text()),
                   import.span, phrase("name it by its full name"));
        if (!outside || import.wildcard) continue;
        const std::string& last = import.name.parts.back().identifier;
        const auto isHidden = [&](const syntax::Component& c) { return c.name == last && c.isProtected; };
        const auto& components = outside->definition->components;
        if ((meant && isProtectedClass(*meant)) || std::any_of(components.begin(), components.end(), isHidden))
            refuse(phrase("'{}' of {} is protected", last, outside->qualifiedName), import.span,
                   phrase("use a public variable, or make it public where it is declared"));
    }
}

void ClassRules::function(const LibraryClass& definition) {
    const Definition& tree = *definition.definition;
    std::unordered_set<std::string_view> inputs;
    for (const syntax::Component& component : tree.components) {
        if (component.causality == syntax::Causality::Input) inputs.insert(component.name);
        const bool isConstant = component.variability == syntax::Variability::Constant ||
                                component.variability == syntax::Variability::Parameter;
        if (component.causality == syntax::Causality::None && !component.isProtected && !isConstant)
            refuse(phrase("'{}' of the function {} is neither input nor output nor protected", component.name,
                          definition.qualifiedName),
                   component.nameSpan, phrase("declare it below \"protected\""));
    }
    for (std::size_t s = 0; s < tree.algorithmSections.size(); ++s) {
        const syntax::EquationSection& section = tree.algorithmSections[s];
        if (s > 0 || section.isInitial)
            refuse(phrase("a function has one algorithm and no initial one"), section.keyword,
                   phrase("write all statements in one algorithm"));
        targets(section.equations, inputs);
    }
}

/// Inputs keep their values.
void ClassRules::targets(const std::vector<syntax::Equation>& statements,
                         const std::unordered_set<std::string_view>& inputs) {
    const auto judge = [&](const syntax::Expression& target) {
        if (target.kind != syntax::Expression::Kind::Reference) return;
        const std::string& name = target.name.parts.front().identifier;
        if (inputs.contains(name))
            refuse(phrase("'{}' is an input of the function and cannot be assigned", name), target.span,
                   phrase("use a protected variable"));
    };
    for (const syntax::Equation& statement : statements) {
        if (statement.kind == StatementKind::Assign) {
            judge(statement.left);
            for (const syntax::Expression& part : statement.left.operands) judge(part);
        }
        for (const auto& branch : statement.branches) targets(branch.body, inputs);
        targets(statement.body, inputs);
    }
}

void ClassRules::statements(const std::vector<syntax::Equation>& statements, const Definition& of, bool isInLoop,
                            bool isInWhen) {
    for (const syntax::Equation& statement : statements) {
        if (statement.kind == StatementKind::Break && !isInLoop)
            refuse(phrase("'break' stands outside of a loop"), statement.span);
        if (statement.kind == StatementKind::Return && of.restriction != Restriction::Function)
            refuse(phrase("'return' stands outside of a function"), statement.span);
        const bool isWhen = statement.kind == StatementKind::When;
        if (isWhen && isInWhen)
            refuse(phrase("'when' cannot stand within another 'when'"), statement.keyword,
                   phrase("join the conditions by 'and'"));
        const bool isLoop = statement.kind == StatementKind::For || statement.kind == StatementKind::While;
        for (const auto& branch : statement.branches)
            this->statements(branch.body, of, isInLoop || isLoop, isInWhen || isWhen);
        this->statements(statement.body, of, isInLoop || isLoop, isInWhen);
    }
}

bool ClassRules::mayReach(const syntax::Name& name, const LibraryClass* from) {
    if (name.parts.size() < 2 || !reached_.emplace(from, name.text()).second) return true;
    syntax::Name prefix = name;
    prefix.parts.resize(1);
    const LibraryClass* holder = work_.library.lookup(prefix, from && !name.absolute ? from->qualifiedName : "");
    for (std::size_t p = 1; p < name.parts.size() && holder; ++p) {
        const std::string& part = name.parts[p].identifier;
        prefix.parts.push_back(name.parts[p]);
        const LibraryClass* const next =
            work_.library.lookup(prefix, from && !name.absolute ? from->qualifiedName : "");
        const auto& components = holder->definition->components;
        const auto component = std::find_if(components.begin(), components.end(),
                                            [&](const syntax::Component& c) { return c.name == part; });
        const bool isHidden = next ? isProtectedClass(*next) : component != components.end() && component->isProtected;
        if (isHidden) {
            refuse(phrase("'{}' of {} is protected", part, holder->qualifiedName), name.span,
                   phrase("use a public variable, or make it public where it is declared"));
            return false;
        }
        if (!isLikePackage(*holder->definition) && !(next && next->definition->isEncapsulated)) {
            refuse(phrase("'{}' is no package: '{}' in it cannot be used from outside", holder->qualifiedName, part),
                   name.span, phrase("declare it \"encapsulated\", or move it to a package"));
            return false;
        }
        holder = next;
    }
    return true;
}

}  // namespace analogon
