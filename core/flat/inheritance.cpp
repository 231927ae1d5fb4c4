#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "core/flat/class_rules.hpp"
#include "core/flat/instantiator.hpp"

/// Collecting the elements of a class and its bases (Modelica 3.6, chapter 7).
namespace analogon {
namespace {

bool isBuiltinName(const syntax::Name& name) {
    if (name.parts.size() != 1) return false;
    const std::string& n = name.parts[0].identifier;
    return n == "Real" || n == "Integer" || n == "Boolean" || n == "String";
}

/// The name that is meant, or the few that there are.
Text whatThereIs(const std::string& name, const Instance& instance) {
    Text hint = didYouMean(name, instance.elementNames());
    if (!hint.empty()) return hint;
    constexpr std::size_t most = 8;
    std::string names;
    std::size_t count = 0;
    for (const Element& element : instance.elements) {
        const syntax::Component& declared = *element.declaration;
        if (declared.variability != syntax::Variability::Parameter || declared.isProtected || declared.isFinal)
            continue;
        if (++count > most) return {};
        names += (names.empty() ? "" : ", ") + declared.name;
    }
    return names.empty() ? Text() : phrase("its parameters are {}", names);
}

/// Alike but for white space.
bool sameText(std::string_view a, std::string_view b) {
    const auto bare = [](std::string_view text) {
        std::string kept;
        for (const char c : text)
            if (c != ' ' && c != '\t' && c != '\n' && c != '\r') kept += c;
        return kept;
    };
    return a == b || bare(a) == bare(b);
}

bool sameText(const std::optional<syntax::Expression>& a, const std::optional<syntax::Expression>& b) {
    return a.has_value() == b.has_value() && (!a || sameText(a->span.text(), b->span.text()));
}

/// Whether two declarations of one name say the same: descriptions and annotations may differ (section 7.1.3).
bool isSameDeclaration(const syntax::Component& a, const syntax::Component& b) {
    const auto prefixes = [](const syntax::Component& c) {
        return std::tuple(c.variability, c.causality, c.isFlow, c.isStream, c.isProtected, c.isFinal, c.isReplaceable,
                          c.isInner, c.isOuter);
    };
    const auto sameSizes = [](const syntax::Expression& x, const syntax::Expression& y) {
        return sameText(x.span.text(), y.span.text());
    };
    return prefixes(a) == prefixes(b) && a.type.text() == b.type.text() &&
           std::equal(a.dimensions.begin(), a.dimensions.end(), b.dimensions.begin(), b.dimensions.end(), sameSizes) &&
           sameText(a.modificationsSpan.text(), b.modificationsSpan.text()) && sameText(a.binding, b.binding) &&
           sameText(a.condition, b.condition);
}

std::string qualifiedOrEmpty(const LibraryClass* definition) { return definition ? definition->qualifiedName : ""; }

}  // namespace

/// A base class is looked up among the class's own nested classes, then outward from where the class stands; not
/// among what it inherits (section 5.6.1).
const LibraryClass* Instantiator::lookupBase(const syntax::Name& name, const LibraryClass& derived) {
    if (!name.absolute && !name.parts.empty() &&
        work_.library.find(fmt::format("{}.{}", derived.qualifiedName, name.parts[0].identifier)))
        return work_.lookup(name, &derived);
    if (const LibraryClass* viaImport = work_.library.lookup(name, derived.scope)) return viaImport;
    for (const auto& import : derived.definition->imports)
        if (import.wildcard || (!name.parts.empty() && import.alias == name.parts[0].identifier))
            return work_.lookup(name, &derived);
    return nullptr;
}

void Instantiator::collectBase(Instance& instance, const LibraryClass& derived, const syntax::Name& baseName,
                               const Modifier& modifications, const Modifier& outer, bool isProtected,
                               std::vector<const LibraryClass*>& path) {
    if (isBuiltinName(baseName)) {
        work_.messages.error(
            phrase("'{}' has components or equations and cannot extend {}", derived.qualifiedName, baseName.text()),
            baseName.span);
        return;
    }
    const LibraryClass* base = lookupBase(baseName, derived);
    if (base) work_.tellNewName(baseName);
    if (!base && work_.isOfMissingLibrary(baseName, &derived)) return;
    if (!base) {
        work_.messages.error(phrase("the base class '{}' of '{}' is not known", baseName.text(), derived.qualifiedName),
                             baseName.span, didYouMean(baseName.text(), work_.library.names()));
        return;
    }
    collect(instance, *base, merge(outer, modifications, work_.messages), isProtected, path);
    checkModifiedNames(instance, modifications, false);
}

void Instantiator::collect(Instance& instance, const LibraryClass& definition, const Modifier& outer, bool isProtected,
                           std::vector<const LibraryClass*>& path) {
    const syntax::ClassDefinition& tree = *definition.definition;
    if (std::find(path.begin(), path.end(), &definition) != path.end()) {
        std::string chain = definition.qualifiedName;
        const auto first = std::find(path.begin(), path.end(), &definition);
        for (auto step = first + 1; step != path.end(); ++step) chain += " extends " + (*step)->qualifiedName;
        work_.messages.error(
            phrase("'{}' extends itself: {} extends {}", definition.qualifiedName, chain, definition.qualifiedName),
            tree.nameSpan, phrase("remove one of the extends clauses"));
        return;
    }
    if (static_cast<int>(path.size()) >= deepest) {
        work_.messages.error(phrase("'{}' inherits through more than {} classes", instance.className, deepest),
                             tree.nameSpan);
        return;
    }
    if (instance.parts.size() > mostBases)
        return work_.messages.fatal(phrase("'{}' inherits too many classes", instance.className), tree.nameSpan);
    if (tree.external)
        return work_.messages.error(phrase("external functions are not supported"), tree.external->span,
                                    phrase("write the relation as equations"));
    work_.rules->check(definition);
    path.push_back(&definition);
    work_.keepSource(tree);
    for (const syntax::Import& import : tree.imports) work_.tellNewName(import.name);
    const Scope scope{&instance, &definition};
    collectClasses(instance, definition, outer);
    if (tree.isShort && !tree.isEnumeration) {
        const Scope outside{&instance, work_.library.find(definition.scope)};
        collectBase(instance, definition, tree.shortBase, modifierOf(tree.shortModifications, outside, work_.messages),
                    outer, isProtected, path);
    }
    if (tree.extendsItself) collectExtended(instance, definition, outer, isProtected, path);
    for (const auto& base : tree.bases) {
        if (work_.messages.full()) break;
        collectBase(instance, definition, base.base, modifierOf(base.modifications, scope, work_.messages), outer,
                    isProtected || base.isProtected, path);
    }
    instance.elements.reserve(instance.elements.size() + tree.components.size());
    for (const auto& component : tree.components) addElement(instance, definition, component, outer, isProtected);
    instance.parts.push_back({&tree, &definition});
    path.pop_back();
}

/// `model extends M(…)`: what the class M that is inherited around it holds, and more (section 7.3.1).
void Instantiator::collectExtended(Instance& instance, const LibraryClass& definition, const Modifier& outer,
                                   bool isProtected, std::vector<const LibraryClass*>& path) {
    const syntax::ClassDefinition& tree = *definition.definition;
    const std::vector<const LibraryClass*> found = work_.library.bases(definition);
    const auto original = std::find_if(found.begin(), found.end(), [&](const LibraryClass* base) {
        return base->definition->name == tree.name && base->scope != definition.scope;
    });
    if (original == found.end()) {
        work_.messages.error(
            phrase("'{}' continues a class of its name, but none is inherited", definition.qualifiedName),
            tree.nameSpan, phrase("give the class a name of its own"));
        return;
    }
    if (!(*original)->definition->isReplaceable)
        work_.messages.error(phrase("the class '{}' of '{}' is not replaceable", tree.name, (*original)->scope),
                             tree.nameSpan);
    const Modifier modifications = modifierOf(tree.shortModifications, {&instance, &definition}, work_.messages);
    collect(instance, **original, merge(outer, modifications, work_.messages), isProtected, path);
    checkModifiedNames(instance, modifications, false);
}

/// Local classes and their redeclarations; what is further out was entered before and wins.
void Instantiator::collectClasses(Instance& instance, const LibraryClass& definition, const Modifier& outer) {
    for (const auto& [name, modifier] : outer.children)
        if (modifier.redeclaredClass)
            instance.redeclared.try_emplace(
                name,
                Instance::RedeclaredClass{modifier.redeclaredClass, modifier.redeclareScope, modifier.span, nullptr});
    for (const auto& local : definition.definition->classes) {
        if (local->isRedeclare) {
            const LibraryClass* known = work_.library.find(fmt::format("{}.{}", definition.qualifiedName, local->name));
            if (known) mayReplace(instance, definition, *known);
            if (known)
                instance.redeclared.try_emplace(
                    local->name,
                    Instance::RedeclaredClass{local.get(), {&instance, &definition}, local->nameSpan, known});
            continue;
        }
        const auto [known, isNew] =
            instance.localClasses.try_emplace(local->name, Instance::LocalClass{local.get(), &definition});
        const bool isSame = isNew || known->second.definition == local.get() || local->extendsItself ||
                            known->second.definition->extendsItself ||
                            sameText(known->second.definition->span.text(), local->span.text());
        if (!isSame)
            work_.messages.error(phrase("'{}' is declared in '{}' and, differently, in '{}'", local->name,
                                        known->second.lexical->qualifiedName, definition.qualifiedName),
                                 known->second.definition->nameSpan, phrase("rename it, or declare it 'redeclare'"));
    }
}

/// What a class redeclares below itself: an inherited class that is not final, and as public as it was (section 7.3.3).
void Instantiator::mayReplace(const Instance& instance, const LibraryClass& definition, const LibraryClass& by) {
    for (const LibraryClass* base : work_.library.bases(definition)) {
        const LibraryClass* const original = work_.library.lookup(by.definition->name, base->qualifiedName);
        if (!original || original->scope == definition.scope || original == &by) continue;
        if (original->definition->isFinal)
            work_.messages.error(
                phrase("'{}' of '{}' is final and cannot be redeclared", by.definition->name, instance.className),
                by.definition->nameSpan);
        if (original->definition->isProtected != by.definition->isProtected && !original->scope.empty() &&
            work_.library.isDerived(definition.qualifiedName, original->scope))
            tellVisibility(by.definition->name, by.definition->isProtected, by.definition->nameSpan);
    }
}

void Instantiator::tellVisibility(const std::string& name, bool isProtected, const Span& span) {
    work_.messages.error(isProtected ? phrase("'{}' is public where it is inherited from, and protected here", name)
                                     : phrase("'{}' is protected where it is inherited from, and public here", name),
                         span, phrase("redeclare it in a section of the same kind"));
}

/// `inner outer T x` declares two: to its class x is that of an instance around, to what lies within it is the one that
/// is declared and modified here (section 5.4). The first bears the name; false: it is there already.
bool Instantiator::addOuterSide(Instance& instance, const LibraryClass& definition, const syntax::Component& component,
                                bool isProtected) {
    const bool isKnown = std::any_of(instance.elements.begin(), instance.elements.end(), [&](const Element& e) {
        return e.original->nameSpan.text().data() == component.nameSpan.text().data();
    });
    if (isKnown) return false;
    syntax::Component& side = sides_.emplace_back(component);
    side.isInner = false;
    side.modifications.clear();
    side.binding.reset();
    Element element;
    element.declaration = element.original = &side;
    element.owner = &definition;
    element.scope = {&instance, &definition};
    element.isProtected = component.isProtected || isProtected;
    instance.elements.push_back(std::move(element));
    return true;
}

void Instantiator::addElement(Instance& instance, const LibraryClass& definition, const syntax::Component& component,
                              const Modifier& outer, bool isProtected) {
    const bool isBoth = component.isInner && component.isOuter;
    if (isBoth && !addOuterSide(instance, definition, component, isProtected)) return;
    const Scope scope{&instance, &definition};
    Modifier own = modifierOf(component.modifications, scope, work_.messages);
    if (component.constrainedBy)
        own = overConstraint(own, modifierOf(component.constrainedByModifications, scope, work_.messages),
                             work_.messages);
    if (component.binding) {
        own.value = {&*component.binding, scope, {}, {}};
        own.span = component.nameSpan;
    }
    own.isFinal = component.isFinal;

    Element element;
    element.declaration = element.original = &component;
    element.owner = &definition;
    element.scope = scope;
    element.isProtected = component.isProtected || isProtected;
    const Modifier* modification = outer.find(component.name);
    if (modification && modification->redeclaredClass) modification = nullptr;
    if (modification && modification->redeclaredComponent) {
        element.modifier = std::move(own);
        element = redeclare(instance, std::move(element), component, *modification);
    } else {
        element.modifier =
            modification ? merge(*modification, std::move(own), work_.messages, component.name) : std::move(own);
    }

    if (isBoth) {
        syntax::Component& side = sides_.emplace_back(component);
        side.isOuter = false;
        element.declaration = element.original = &side;
        instance.elements.push_back(std::move(element));
    } else if (Element* existing = instance.find(component.name))
        replaceElement(instance, *existing, std::move(element));
    else if (component.isRedeclare)
        work_.messages.error(
            phrase("'{}' redeclares '{}', which it does not inherit", definition.qualifiedName, component.name),
            component.nameSpan, didYouMean(component.name, instance.elementNames()));
    else
        instance.elements.push_back(std::move(element));
}

/// Constants and what is final stay as they are declared (section 7.3.3).
bool Instantiator::mayRedeclare(const syntax::Component& original, const Span& span) {
    const bool isConstant = original.variability == syntax::Variability::Constant;
    if (!isConstant && !original.isFinal) return true;
    work_.messages.error(isConstant ? phrase("'{}' is a constant and cannot be redeclared", original.name)
                                    : phrase("'{}' is final and cannot be redeclared", original.name),
                         span, phrase("declare a component of another name"));
    return false;
}

namespace {

/// What a declaration says below its redeclarations: by its constraining clause, or all of it where it has none
/// (section 7.3.2), its value included.
Modifier staysInForce(const syntax::Component& component, const Scope& scope, Messages& messages) {
    if (component.constrainedBy) return modifierOf(component.constrainedByModifications, scope, messages);
    Modifier said = modifierOf(component.modifications, scope, messages);
    if (component.binding) {
        said.value = {&*component.binding, scope, {}, {}};
        said.span = component.nameSpan;
    }
    return said;
}

}  // namespace

/// `x(redeclare T x(…))`: the new declaration with the modifications of the constraining clause below its own.
Element Instantiator::redeclare(Instance& instance, Element element, const syntax::Component& component,
                                const Modifier& modification) {
    const syntax::Component& replacement = *modification.redeclaredComponent;
    const bool sizesOnly = !component.dimensions.empty() && component.type.text() == replacement.type.text();
    if (!mayRedeclare(component, modification.span)) return element;
    if (!component.isReplaceable && !sizesOnly) {
        work_.messages.error(phrase("'{}' of '{}' is not replaceable", component.name, instance.className),
                             modification.span, phrase("declare it 'replaceable' or modify it without 'redeclare'"));
        return element;
    }
    Modifier constraint = staysInForce(component, element.scope, work_.messages);
    if (!component.isReplaceable) constraint = element.modifier;  // other sizes, else what it was
    Modifier outer = modification;                                // with what the new declaration says itself
    outer.redeclaredComponent = nullptr;
    outer.isFinal = constraint.isFinal = false;  // of the declaration: it does not forbid itself
    element.modifier = merge(outer, std::move(constraint), work_.messages, component.name);
    element.modifier.isFinal = replacement.isFinal || modification.isFinal;
    element.declaration = &replacement;
    element.scope = modification.redeclareScope;
    return element;
}

/// An element of the same name is there already: a redeclaration, the same declaration inherited twice, or a fault.
void Instantiator::replaceElement(Instance& instance, Element& existing, Element element) {
    const syntax::Component& component = *element.original;
    const syntax::Component& known = *existing.original;
    if (&known == &component) return;
    if (component.isRedeclare) {
        if (!known.isReplaceable) {
            work_.messages.error(
                phrase("'{}' of '{}' is not replaceable", component.name, existing.owner->qualifiedName),
                component.nameSpan);
            return;
        }
        if (!mayRedeclare(known, component.nameSpan)) return;
        if (element.isProtected != existing.isProtected)
            tellVisibility(component.name, element.isProtected, component.nameSpan);
        const Scope knownScope{&instance, existing.owner};
        Modifier constraint = staysInForce(known, knownScope, work_.messages);
        element.modifier = merge(element.modifier, std::move(constraint), work_.messages, component.name);
        element.original = existing.original;
        element.owner = existing.owner;
        existing = std::move(element);
        return;
    }
    if (existing.owner == element.owner) {
        work_.messages.error(phrase("'{}' is declared twice in '{}'", component.name, element.owner->qualifiedName),
                             component.nameSpan, phrase("rename or remove one of the two declarations"));
        return;
    }
    if (isSameDeclaration(known, component)) return;
    work_.messages.error(phrase("'{}' is declared in '{}' and, differently, in '{}'", component.name,
                                existing.owner->qualifiedName, element.owner->qualifiedName),
                         component.nameSpan, phrase("rename it, or declare it 'redeclare'"));
}

/// Each name that is modified must be an element; from outside, a public one.
void Instantiator::checkModifiedNames(Instance& instance, const Modifier& modifier, bool fromOutside) {
    for (const auto& [name, child] : modifier.children) {
        const Element* element = instance.find(name);
        const auto local = instance.localClasses.find(name);
        if (element) {
            if (child.redeclaredClass)
                work_.messages.error(phrase("'{}' of '{}' is a component, not a class", name, instance.className),
                                     child.span, phrase("redeclare it as a component: redeclare TYPE NAME"));
            else if (fromOutside && element->isProtected)
                work_.messages.error(
                    phrase("'{}' of '{}' is protected and cannot be modified", name, instance.className), child.span);
        } else if (local != instance.localClasses.end()) {
            if (!child.redeclaredClass)
                work_.messages.error(
                    phrase("'{}' of '{}' is a class; it can only be redeclared", name, instance.className), child.span);
            else if (fromOutside && local->second.definition->isProtected)
                work_.messages.error(
                    phrase("'{}' of '{}' is protected and cannot be modified", name, instance.className), child.span);
            else if (local->second.definition->isFinal)
                work_.messages.error(phrase("'{}' of '{}' is final and cannot be redeclared", name, instance.className),
                                     child.span);
            else if (!local->second.definition->isReplaceable)
                work_.messages.error(
                    phrase("the class '{}' of '{}' is not replaceable", name, qualifiedOrEmpty(local->second.lexical)),
                    child.span);
        } else {
            work_.messages.error(phrase("'{}' has no element '{}' to modify", instance.className, name), child.span,
                                 whatThereIs(name, instance));
        }
    }
}

}  // namespace analogon
