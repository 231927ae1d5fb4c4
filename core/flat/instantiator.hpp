#pragma once

#include <deque>
#include <optional>

#include "core/flat/flattening.hpp"

namespace analogon {

/// Real, Integer, Boolean or String; nothing: another name.
std::optional<FlatType> builtinType(const syntax::Name& name);

/// Turns classes into instances: inheritance, modification, redeclaration, conditional components, arrays.
/// Elements are collected first and instantiated on demand, since a size or a condition may use parameters
/// that are declared later.
class Instantiator {
public:
    static constexpr std::size_t mostScalars = 1'000'000;
    static constexpr std::size_t mostComponents = 100'000;
    static constexpr std::size_t mostBases = 1000;  // inherited by one class
    static constexpr int deepest = 100;             // of nesting and of inheritance

    explicit Instantiator(Flattening& work) : work_(work) {}

    /// The model itself with all below it; null when it cannot be instantiated.
    Instance* instantiate(const LibraryClass& definition);
    /// Makes sizes, variables and items of an element known; false when they are faulty (reported).
    bool ensure(Instance& instance, Element& element);

private:
    struct Collection;  // one walk over an inheritance path

    void completeAll(Instance& root);
    Instance& newInstance(const LibraryClass& definition, std::string name, Instance* parent);

    void collect(Instance& instance, const LibraryClass& definition, const Modifier& outer, bool isProtected,
                 std::vector<const LibraryClass*>& path);
    void collectBase(Instance& instance, const LibraryClass& derived, const syntax::Name& baseName,
                     const Modifier& modifications, const Modifier& outer, bool isProtected,
                     std::vector<const LibraryClass*>& path);
    void collectExtended(Instance& instance, const LibraryClass& definition, const Modifier& outer, bool isProtected,
                         std::vector<const LibraryClass*>& path);
    void collectClasses(Instance& instance, const LibraryClass& definition, const Modifier& outer);
    void addElement(Instance& instance, const LibraryClass& definition, const syntax::Component& component,
                    const Modifier& outer, bool isProtected);
    bool addOuterSide(Instance& instance, const LibraryClass& definition, const syntax::Component& component,
                      bool isProtected);
    void replaceElement(Instance& instance, Element& existing, Element element);
    Element redeclare(Instance& instance, Element element, const syntax::Component& component,
                      const Modifier& modification);
    const LibraryClass* lookupBase(const syntax::Name& name, const LibraryClass& derived);
    void mayReplace(const Instance& instance, const LibraryClass& definition, const LibraryClass& by);
    void tellVisibility(const std::string& name, bool isProtected, const Span& span);
    bool mayRedeclare(const syntax::Component& original, const Span& span);
    void checkModifiedNames(Instance& instance, const Modifier& modifier, bool fromOutside);

    bool prepare(Instance& instance, Element& element);
    bool prepareOuter(Instance& instance, Element& element);
    std::optional<std::vector<int>> dimensionsOf(Instance& instance, Element& element);
    bool reserve(const Element& element, const std::string& name);
    void createVariables(Instance& instance, Element& element);
    bool mayHavePrefix(const Element& element);
    bool createItems(Instance& instance, Element& element);
    bool mayContain(const Instance& instance, const Element& element);
    bool isOverconstrained(const Instance& instance, const LibraryClass& type);
    void bindRecord(Instance& record, const Modifier& modifier);

    struct RedeclaredIn {
        Instance* instance{};  // null: none
        const Instance::RedeclaredClass* redeclared{};
    };

    std::optional<ResolvedType> resolveType(const syntax::Name& name, const Scope& scope, int depth = 0);
    RedeclaredIn redeclarationOf(const syntax::Name& name, const Scope& scope);
    bool isReachedUnmodified(const syntax::Name& name, const Scope& scope, const LibraryClass& found);
    bool satisfies(const ResolvedType& type, const syntax::Name& constraint, const Scope& scope, const Span& span);
    void constrain(ResolvedType& type, Instance& instance, const std::string& name);
    std::optional<ResolvedType> followClass(const LibraryClass& definition, const Scope& scope, int depth);
    std::optional<ResolvedType> followShort(const syntax::ClassDefinition& definition, const Scope& scope,
                                            const std::string& className, int depth);

    Flattening& work_;
    std::deque<syntax::Component> sides_;  // of what is inner and outer at once
    std::size_t scalars_{};
    std::size_t items_{};  // components, connectors and records
};

}  // namespace analogon
