#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/flat/messages.hpp"
#include "core/library/library.hpp"
#include "core/syntax/ast.hpp"

namespace analogon {

struct Instance;

/// Attributes of the predefined types (Modelica 3.6, section 4.9).
inline constexpr std::array<std::string_view, 10> attributeNames{
    "unit", "displayUnit", "quantity", "min", "max", "start", "fixed", "nominal", "stateSelect", "unbounded"};

/// Where the names of an expression are looked up: components in the instance, classes and constants from the
/// class in which the expression is written, outward.
struct Scope {
    Instance* instance{};
    const LibraryClass* lexical{};
};

/// The right-hand side of a modification, with what is picked from it: `rotor[3](J = {1, 2, 3})` gives rotor[2].J
/// the expression {1, 2, 3} and the subscript 2; `r = other` for a record gives r.a the member a of `other`.
struct ModifierValue {
    const syntax::Expression* expression{};
    Scope scope;
    std::vector<std::string> members;
    std::vector<int> subscripts;

    bool valid() const { return expression != nullptr; }
};

/// A merged modification (Modelica 3.6, section 7.2): what is said about one element and what lies below it.
struct Modifier {
    ModifierValue value;
    bool each{};
    bool isFinal{};
    const syntax::Component* redeclaredComponent{};
    const syntax::ClassDefinition* redeclaredClass{};
    Scope redeclareScope;
    Span span;
    std::vector<std::pair<std::string, Modifier>> children;

    bool empty() const {
        return !value.valid() && !redeclaredComponent && !redeclaredClass && !isFinal && children.empty();
    }
    const Modifier* find(std::string_view name) const;
    Modifier& child(const std::string& name);
    /// All values below apply to each element of an array as they stand.
    void markEach();
};

/// The argument list `( … )` of a declaration, a short class or an extends clause.
Modifier modifierOf(const std::vector<syntax::Modification>& arguments, const Scope& scope, Messages& messages);

/// The outer modification overrides the inner one; an inner `final` refuses it.
Modifier merge(const Modifier& outer, Modifier inner, Messages& messages, const std::string& name = {});

/// What is said in a declaration, above what its constraining clause says (section 7.3.2).
Modifier overConstraint(const Modifier& own, Modifier constraint, Messages& messages);

/// What an array's modification says about the element with these subscripts.
Modifier elementModifier(const Modifier& ofArray, const std::vector<int>& subscripts);

}  // namespace analogon
