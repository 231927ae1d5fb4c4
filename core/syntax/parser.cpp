#include "core/syntax/parser.hpp"

#include <utility>

#include "core/syntax/grammar.hpp"

namespace analogon::syntax {

ParseResult parse(SourcePtr source) {
    Cursor cursor(source, lex(*source));
    ParseResult result;
    if (!(cursor.atEnd() && hasError(cursor.diagnostics()))) result.definition = Grammar(cursor).storedDefinition();
    result.definition.source = std::move(source);
    result.diagnostics = std::move(cursor.diagnostics());
    return result;
}

Outcome<Expression> parseExpression(SourcePtr source) {
    Cursor cursor(source, lex(*source));
    if (hasError(cursor.diagnostics())) return std::move(cursor.diagnostics());
    try {
        Expression result = Grammar(cursor).expression();
        if (!cursor.atEnd()) cursor.faultExpected("the end of the expression");
        if (!hasError(cursor.diagnostics())) return result;
    } catch (const SyntaxFault&) {  // reported
    }
    return std::move(cursor.diagnostics());
}

}  // namespace analogon::syntax
