#pragma once

#include <string>

#include "core/syntax/ast.hpp"

namespace analogon::syntax {

/// Modelica text of a tree. parse(print(x)) is x up to spans and layout. (A round trip of a file does not
/// go through the printer: text edits leave everything outside their place as it was.)
/// An equation and a component (printed as a clause of its own) end with `;`, a class does not.
std::string print(const Expression& expression);
std::string print(const Modification& modification);
std::string print(const Equation& equation);
std::string print(const Component& component);
std::string print(const ClassDefinition& definition);
std::string print(const StoredDefinition& definition);

/// Shortest decimal text that reads back as the same double, as a Modelica literal. The value must be finite.
std::string printNumber(double value);

/// A string literal with its quotes; what must be escaped is.
std::string printString(const std::string& text);

}  // namespace analogon::syntax
