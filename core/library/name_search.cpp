#include "core/library/name_search.hpp"

#include <string>

#include "core/library/lazy_packages.hpp"

namespace analogon {

const LibraryClass* NameSearch::ask(std::string_view qualifiedName) {
    const std::string_view root = qualifiedName.substr(0, qualifiedName.find('.'));
    if (!roots_.contains(root)) roots_.emplace(root);
    return library_.find(qualifiedName);
}

const LibraryClass* NameSearch::find(const syntax::Name& name, std::string_view scope) {
    if (name.parts.empty()) return nullptr;
    const std::string_view start = name.absolute ? std::string_view{} : scope;
    return findRest(findFirst(name.parts.front().identifier, start, nullptr), name, 1);
}

const LibraryClass* NameSearch::findBase(const syntax::Name& name, const LibraryClass& derived) {
    if (name.parts.empty()) return nullptr;
    const std::string_view start = name.absolute ? std::string_view{} : std::string_view(derived.qualifiedName);
    return findRest(findFirst(name.parts.front().identifier, start, &derived), name, 1);
}

/// From the scope outward. `heir` is the class whose own base is being looked for.
const LibraryClass* NameSearch::findFirst(std::string_view identifier, std::string_view scope,
                                          const LibraryClass* heir) {
    for (; !scope.empty(); scope = enclosingName(scope)) {
        if (const LibraryClass* found = nested(scope, identifier)) return found;
        const LibraryClass* here = ask(scope);
        if (!here) continue;  // `within` a package that is not loaded
        if (here != heir) {
            if (const LibraryClass* found = inherited(*here, identifier)) return found;
        }
        if (const LibraryClass* found = imported(*here, identifier)) return found;
        if (here->definition->isEncapsulated) return nullptr;
    }
    return ask(identifier);
}

const LibraryClass* NameSearch::findRest(const LibraryClass* found, const syntax::Name& name, std::size_t part) {
    for (; found && part < name.parts.size(); ++part) found = declaredOrInherited(*found, name.parts[part].identifier);
    return found;
}

const LibraryClass* NameSearch::declaredOrInherited(const LibraryClass& in, std::string_view identifier) {
    if (const LibraryClass* found = nested(in.qualifiedName, identifier)) return found;
    return inherited(in, identifier);
}

const LibraryClass* NameSearch::extended(const LibraryClass& heir) {
    const LibraryClass* const outside = ask(heir.scope);
    return outside ? inherited(*outside, heir.definition->name) : nullptr;
}

const LibraryClass* NameSearch::inherited(const LibraryClass& in, std::string_view identifier) {
    const auto [entry, isNew] = visited_.try_emplace({&in, std::string(identifier)}, nullptr);
    if (!isNew) return entry->second;
    const auto from = [&](const syntax::Name& name) -> const LibraryClass* {
        const LibraryClass* base = findBase(name, in);
        return base && base != &in ? declaredOrInherited(*base, identifier) : nullptr;
    };
    const LibraryClass* found = nullptr;
    if (in.definition->isShort && !in.definition->isEnumeration) found = from(in.definition->shortBase);
    if (in.definition->extendsItself)
        if (const LibraryClass* const original = extended(in)) found = declaredOrInherited(*original, identifier);
    for (const syntax::Extends& clause : in.definition->bases) {
        if (!found) found = from(clause.base);
    }
    entry->second = found;
    return found;
}

/// Qualified imports win over `import A.*` (section 5.3.1). What is imported is named from the top.
const LibraryClass* NameSearch::imported(const LibraryClass& in, std::string_view identifier) {
    const auto meant = [&](const syntax::Name& name) { return findRest(ask(name.parts.front().identifier), name, 1); };
    for (const syntax::Import& clause : in.definition->imports) {
        if (!clause.wildcard && clause.alias == identifier) return meant(clause.name);
    }
    for (const syntax::Import& clause : in.definition->imports) {
        if (!clause.wildcard) continue;
        const LibraryClass* package = meant(clause.name);
        const LibraryClass* found = package ? declaredOrInherited(*package, identifier) : nullptr;
        if (found && !found->definition->isProtected) return found;
    }
    return nullptr;
}

const LibraryClass* NameSearch::nested(std::string_view scope, std::string_view identifier) {
    std::string name(scope);
    name += '.';
    name += identifier;
    return ask(name);
}

}  // namespace analogon
