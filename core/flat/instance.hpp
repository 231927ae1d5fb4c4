#pragma once

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/flat/flat_model.hpp"
#include "core/flat/modifier.hpp"
#include "core/flat/value.hpp"

namespace analogon {

/// What a type name stands for after short classes (`type`, `connector C = input Real`) are followed.
struct ResolvedType {
    struct Dimension {
        const syntax::Expression* size{};
        Scope scope;
    };

    bool isBuiltin{};
    FlatType builtin{FlatType::Real};
    const syntax::ClassDefinition* enumeration{};  // its literals
    const LibraryClass* definition{};              // what is instantiated; null for a built-in type
    std::string className;                         // qualified, as it was named ("Analogon.Interfaces.RealInput")
    Modifier modifier;                             // of the short classes on the way
    std::vector<Dimension> dimensions;
    /// Of an enumeration, whatever short class leads to it; empty: it is none.
    std::string enumerationName() const { return enumeration ? definition->qualifiedName : std::string(); }
    syntax::Causality causality{syntax::Causality::None};
    bool isConnector{};
};

/// A declared component inside an instance, after modification.
struct Element {
    enum class State { Pending, Busy, Ready, Failed };

    enum class Binding { Pending, Busy, Done };

    const syntax::Component* declaration{};
    const syntax::Component* original{};  // what a redeclaration replaces; else the declaration itself
    const LibraryClass* owner{};          // the class that declares it
    Scope scope;                          // of its type, sizes and condition (a redeclaration brings its own)
    Modifier modifier;
    bool isProtected{};

    State state{State::Pending};
    bool isDisabled{};  // conditional component whose condition is false
    ResolvedType type;
    std::vector<int> dimensions;
    VariableId firstVariable;           // built-in type: the scalars follow each other
    std::vector<Instance*> items;       // of a class, row-major
    bool isElsewhere{};                 // `outer`: what it names is that of an instance around this one
    Binding binding{Binding::Pending};  // whether the scalars' values are translated

    std::size_t count() const { return elementCount(dimensions); }
    bool isVariable() const { return type.isBuiltin; }
    bool isObject{};  // an external object; its value is that of its modification
    int object{-1};   // its number, once it was made
};

/// A class at work: one component of class type, or the model itself.
struct Instance {
    /// A class on the inheritance path whose equations belong to the instance, base first.
    struct Part {
        const syntax::ClassDefinition* definition{};
        const LibraryClass* lexical{};
    };
    struct LocalClass {
        const syntax::ClassDefinition* definition{};
        const LibraryClass* lexical{};  // where it is declared
    };
    struct RedeclaredClass {
        const syntax::ClassDefinition* definition{};
        Scope scope;
        Span span;
        const LibraryClass* asElement{};  // redeclared in a derived class: a class of the library
    };

    std::string name;  // "drive.rotor"; empty for the model itself
    Instance* parent{};
    const LibraryClass* definition{};
    std::string className;
    syntax::ClassDefinition::Restriction restriction{};
    syntax::Variability variability{syntax::Variability::Continuous};
    syntax::Causality causality{syntax::Causality::None};
    bool isFlow{};
    bool isProtected{};
    bool isHidden{};  // a connector or record that is protected within its component
    bool isFinal{};
    Span declared;
    int depth{};

    std::vector<Part> parts;
    std::vector<Element> elements;
    std::map<std::string, LocalClass, std::less<>> localClasses;
    std::map<std::string, RedeclaredClass, std::less<>> redeclared;

    int unknowns{};   // Modelica 3.6, section 4.7: local number of unknowns
    int equations{};  // and local equation size

    Element* find(std::string_view elementName);
    std::vector<std::string> elementNames() const;
    std::string memberName(std::string_view member) const;
    bool isConnector() const { return restriction == syntax::ClassDefinition::Restriction::Connector; }
    bool isRecord() const { return restriction == syntax::ClassDefinition::Restriction::Record; }
    /// A record, or a connector that is one (`connector C = output Complex`): it has a value.
    bool isOfRecord() const;
    /// A model or block: has equations of its own and is counted in the balance.
    bool isComponent() const { return !isConnector() && !isRecord(); }
    /// The innermost model or block it belongs to (itself when it is one).
    Instance& component();
    /// "component 'rotor'" or "model 'Motor'".
    Text label() const;

private:
    std::unordered_map<std::string_view, std::size_t> index_;  // of large classes
};

/// What flattening knows of a flat variable beyond the result.
struct VariableRecord {
    Instance* owner{};
    std::uint32_t element{};   // index in owner->elements
    std::uint32_t position{};  // in the element's array
    syntax::Causality causality{syntax::Causality::None};
    bool isProtected{};            // within its component: whoever holds that cannot reach it
    bool isBound{};                // a continuous variable with a binding equation
    std::optional<double> number;  // a parameter's value, once it was needed
};

}  // namespace analogon
