#include <fmt/format.h>

#include <algorithm>

#include "core/flat/class_rules.hpp"
#include "core/flat/instantiator.hpp"

/// From a type name to what is instantiated (Modelica 3.6, sections 4.5 and 5.3).
namespace analogon {
namespace {

using Restriction = syntax::ClassDefinition::Restriction;

}  // namespace

std::optional<FlatType> builtinType(const syntax::Name& name) {
    if (name.parts.size() != 1) return std::nullopt;
    const std::string& n = name.parts[0].identifier;
    if (n == "Real") return FlatType::Real;
    if (n == "Integer") return FlatType::Integer;
    if (n == "Boolean") return FlatType::Boolean;
    if (n == "String") return FlatType::String;
    return std::nullopt;
}

std::optional<ResolvedType> Instantiator::resolveType(const syntax::Name& name, const Scope& scope, int depth) {
    if (const auto builtin = builtinType(name)) {
        ResolvedType type;
        type.isBuiltin = true;
        type.builtin = *builtin;
        type.className = name.text();
        return type;
    }
    if (depth > deepest) {
        work_.messages.error(phrase("the type '{}' is defined through itself", name.text()), name.span);
        return std::nullopt;
    }
    if (const RedeclaredIn replaced = redeclarationOf(name, scope); replaced.instance) {
        const Instance::RedeclaredClass& r = *replaced.redeclared;
        if (name.parts.size() > 1) {
            work_.messages.error(phrase("'{}' names a class within '{}', which is redeclared; that is not supported",
                                        name.text(), name.parts[0].identifier),
                                 name.span,
                                 phrase("declare the inner class as \"replaceable\" itself and redeclare that one"));
            return std::nullopt;
        }
        std::optional<ResolvedType> type;
        const bool isShort = r.definition->isShort && !r.definition->isEnumeration;
        if (r.asElement || isShort) {
            type = r.asElement ? followClass(*r.asElement, r.scope, depth + 1)
                               : followShort(*r.definition, r.scope, {}, depth + 1);
            if (type) constrain(*type, *replaced.instance, name.parts[0].identifier);
            return type;
        }
        work_.messages.error(phrase("the class '{}' is redeclared by a class with a body", name.text()), r.span,
                             phrase("write: redeclare model NAME = CLASS"));
        return std::nullopt;
    }
    const LibraryClass* found = work_.lookup(name, scope.lexical);
    if (!found) {
        work_.reportUnknownClass(name, scope.lexical);
        return std::nullopt;
    }
    if (!work_.rules->mayReach(name, scope.lexical)) return std::nullopt;
    if (!isReachedUnmodified(name, scope, *found)) return std::nullopt;
    auto type = followClass(*found, scope, depth + 1);
    const syntax::ClassDefinition& tree = *found->definition;
    if (!type || !tree.isReplaceable || !tree.constrainedBy) return type;
    const LibraryClass* const outside = work_.library.find(found->scope);
    ResolvedType own = *type;  // the sizes that the short class adds are not those of what it names
    own.dimensions.erase(own.dimensions.begin(),
                         own.dimensions.begin() +
                             static_cast<std::ptrdiff_t>(std::min(own.dimensions.size(), tree.shortDimensions.size())));
    if (!satisfies(own, *tree.constrainedBy, {nullptr, outside}, tree.nameSpan)) return std::nullopt;
    Modifier constraint = modifierOf(tree.constrainedByModifications, {scope.instance, outside}, work_.messages);
    constraint.markEach();
    type->modifier = overConstraint(type->modifier, std::move(constraint), work_.messages);
    return type;
}

/// The redeclaration that a name meets: in the instance itself, or in one around it when the name leads to a class
/// which that one holds.
Instantiator::RedeclaredIn Instantiator::redeclarationOf(const syntax::Name& name, const Scope& scope) {
    if (name.absolute || name.parts.empty() || !scope.instance) return {};
    const std::string& first = name.parts[0].identifier;
    const LibraryClass* meant = nullptr;
    for (Instance* instance = scope.instance; instance; instance = instance->parent) {
        const auto replaced = instance->redeclared.find(first);
        if (replaced == instance->redeclared.end()) continue;
        if (instance != scope.instance) {
            if (!meant) meant = work_.library.lookup(first, scope.lexical ? scope.lexical->qualifiedName : "");
            const auto local = instance->localClasses.find(first);
            if (!meant || local == instance->localClasses.end() || local->second.definition != meant->definition.get())
                continue;
        }
        return {instance, &replaced->second};
    }
    return {};
}

/// A class inherited by a package that modifies its base would see other constants than those of its own text.
bool Instantiator::isReachedUnmodified(const syntax::Name& name, const Scope& scope, const LibraryClass& found) {
    if (name.parts.size() < 2) return true;
    syntax::Name prefix = name;
    prefix.parts.pop_back();
    const LibraryClass* holder = work_.lookup(prefix, name.absolute ? nullptr : scope.lexical);
    for (std::size_t steps = 0; holder && holder->qualifiedName != found.scope && steps < deepest; ++steps) {
        const syntax::ClassDefinition& tree = *holder->definition;
        const bool isModified = !tree.shortModifications.empty() ||
                                std::any_of(tree.bases.begin(), tree.bases.end(),
                                            [](const syntax::Extends& base) { return !base.modifications.empty(); });
        if (isModified) {
            work_.messages.error(
                phrase("'{}' is inherited by {}, which modifies what it inherits; that is not supported for the "
                       "classes of a package",
                       name.text(), holder->qualifiedName),
                name.span, phrase("use {} and modify its parameters", found.qualifiedName));
            return false;
        }
        const std::vector<const LibraryClass*> bases = work_.library.bases(*holder);
        const auto next = std::find_if(bases.begin(), bases.end(), [&](const LibraryClass* base) {
            return work_.library.lookup(name.parts.back().identifier, base->qualifiedName) == &found;
        });
        holder = next == bases.end() ? nullptr : *next;
    }
    return true;
}

/// A class that takes the place of another has each of its public elements (section 6.4).
bool Instantiator::satisfies(const ResolvedType& type, const syntax::Name& constraint, const Scope& scope,
                             const Span& span) {
    const auto required = resolveType(constraint, scope);
    if (!required) return false;
    const auto refuse = [&](const Text& why) {
        work_.messages.error(phrase("{} cannot take the place of {}: {}", type.className, required->className, why),
                             span, phrase("use a class that extends {}", required->className));
        return false;
    };
    if (type.isBuiltin || required->isBuiltin) {
        const bool same = type.isBuiltin && required->isBuiltin && type.builtin == required->builtin;
        if (type.dimensions.size() != required->dimensions.size())
            return refuse(phrase("it has {} dimensions, not {}", type.dimensions.size(), required->dimensions.size()));
        return same || refuse(phrase("it is of another type"));
    }
    if (work_.library.isDerived(type.definition->qualifiedName, required->definition->qualifiedName)) return true;
    const auto elementsOf = [&](const LibraryClass& definition) -> Instance& {
        Instance& scratch = newInstance(definition, {}, nullptr);
        std::vector<const LibraryClass*> path;
        collect(scratch, definition, {}, false, path);
        return scratch;
    };
    Instance& offered = elementsOf(*type.definition);
    for (const Element& element : elementsOf(*required->definition).elements)
        if (!element.isProtected && !offered.find(element.declaration->name))
            return refuse(phrase("it has no '{}'", element.declaration->name));
    return true;
}

/// Modifications of the constraining clause, or of the replaced short class without one, stay in force below those
/// of the redeclaration (section 7.3.2).
void Instantiator::constrain(ResolvedType& type, Instance& instance, const std::string& name) {
    const auto local = instance.localClasses.find(name);
    if (local == instance.localClasses.end()) return;
    const syntax::ClassDefinition& original = *local->second.definition;
    const Scope scope{&instance, local->second.lexical};
    if (original.constrainedBy || (original.isShort && !original.isEnumeration))
        satisfies(type, original.constrainedBy ? *original.constrainedBy : original.shortBase, scope,
                  instance.redeclared.find(name)->second.span);
    Modifier constraint =
        modifierOf(original.constrainedBy ? original.constrainedByModifications : original.shortModifications, scope,
                   work_.messages);
    constraint.markEach();
    type.modifier = merge(type.modifier, std::move(constraint), work_.messages, name);
}

std::optional<ResolvedType> Instantiator::followClass(const LibraryClass& definition, const Scope& scope, int depth) {
    const syntax::ClassDefinition& tree = *definition.definition;
    work_.keepSource(tree);
    if (tree.isEnumeration || tree.isShort) work_.rules->check(definition);
    if (tree.isOpenEnumeration) {
        work_.messages.error(phrase("open enumerations, \"(:)\", are not supported"), tree.nameSpan,
                             phrase("list the literals"));
        return std::nullopt;
    }
    if (tree.isEnumeration) {
        ResolvedType type;
        type.isBuiltin = true;
        type.builtin = FlatType::Integer;
        type.enumeration = &tree;
        type.definition = &definition;
        type.className = definition.qualifiedName;
        return type;
    }
    // A class nested in the model at hand may use its components; one of a package may not.
    Scope inside{nullptr, work_.library.find(definition.scope)};
    if (scope.instance) {
        const auto local = scope.instance->localClasses.find(tree.name);
        if (local != scope.instance->localClasses.end() && local->second.definition == &tree)
            inside.instance = scope.instance;
        const auto replaced = scope.instance->redeclared.find(tree.name);
        if (replaced != scope.instance->redeclared.end() && replaced->second.definition == &tree)
            inside.instance = nullptr;  // a name in it must not lead back to itself
    }
    if (tree.isShort) return followShort(tree, inside, definition.qualifiedName, depth);

    // `type Angle  extends Real(unit = "rad"); end Angle;`
    const bool mayBeBuiltin = tree.restriction == Restriction::Type || tree.restriction == Restriction::Connector;
    if (mayBeBuiltin && tree.components.empty() && tree.bases.size() == 1) {
        const syntax::Name& baseName = tree.bases[0].base;
        const LibraryClass* base = builtinType(baseName) ? nullptr : lookupBase(baseName, definition);
        if (builtinType(baseName) || (base && base->definition->restriction == Restriction::Type)) {
            auto type = resolveType(baseName, inside, depth + 1);
            if (!type || !type->isBuiltin) return type;
            Modifier own = modifierOf(tree.bases[0].modifications, inside, work_.messages);
            own.markEach();
            type->modifier = merge(own, std::move(type->modifier), work_.messages, tree.name);
            type->className = definition.qualifiedName;
            type->isConnector = tree.restriction == Restriction::Connector;
            return type;
        }
    }
    ResolvedType type;
    type.definition = &definition;
    type.className = definition.qualifiedName;
    type.isConnector = tree.restriction == Restriction::Connector;
    return type;
}

std::optional<ResolvedType> Instantiator::followShort(const syntax::ClassDefinition& tree, const Scope& scope,
                                                      const std::string& className, int depth) {
    auto type = resolveType(tree.shortBase, scope, depth + 1);
    if (!type) return type;
    Modifier own = modifierOf(tree.shortModifications, scope, work_.messages);
    if (tree.shortDimensions.empty()) own.markEach();
    type->modifier = merge(own, std::move(type->modifier), work_.messages, tree.name);
    std::vector<ResolvedType::Dimension> dimensions;
    for (const auto& size : tree.shortDimensions) dimensions.push_back({&size, scope});
    type->dimensions.insert(type->dimensions.begin(), dimensions.begin(), dimensions.end());
    if (tree.shortCausality != syntax::Causality::None) type->causality = tree.shortCausality;
    if (!className.empty()) type->className = className;
    if (tree.restriction == Restriction::Connector) type->isConnector = true;
    return type;
}

}  // namespace analogon
