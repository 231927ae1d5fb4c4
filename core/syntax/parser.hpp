#pragma once

#include <string_view>

#include "core/base/outcome.hpp"
#include "core/syntax/ast.hpp"

namespace analogon::syntax {

struct ParseResult {
    StoredDefinition definition;  // what could be read; usable when there is no error
    Diagnostics diagnostics;      // several independent faults in one run
};

/// Reads a Modelica text. Constructs outside the subset are refused by name with their place; after a fault
/// the parser goes on at the next `;` or section, so that one bad element does not hide the rest.
ParseResult parse(SourcePtr source);

/// A single expression (an inspector field, a test).
Outcome<Expression> parseExpression(SourcePtr source);

/// Whether a word belongs to the language (Modelica 3.6, section 2.3.3), so that nothing can be called by it.
bool isKeyword(std::string_view word);

}  // namespace analogon::syntax
