#include <utility>

#include "core/syntax/grammar.hpp"

namespace analogon::syntax {

/// Reads statements up to the next section or the `end` of the class, going on behind a faulty one.
void Grammar::statements(EquationSection& section) {
    while (!cursor_.atEnd() && !cursor_.gaveUp() && !atSection() && !cursor_.at("end") && !cursor_.at("annotation")) {
        const std::size_t begin = cursor_.index();
        try {
            section.equations.push_back(statement());
        } catch (const SyntaxFault&) {
            recoverEquation(begin);
        }
    }
}

std::vector<Equation> Grammar::statementBody() {
    std::vector<Equation> body;
    while (!atBodyEnd()) {
        const std::size_t begin = cursor_.index();
        try {
            body.push_back(statement());
        } catch (const SyntaxFault&) {
            recoverEquation(begin);
        }
    }
    return body;
}

Equation Grammar::statement() {
    const Cursor::Nesting nesting(cursor_);
    const std::size_t begin = cursor_.index();
    const Span word = cursor_.here();
    Equation result = cursor_.at("if")      ? conditional(Equation::Kind::If, Body::Statements)
                      : cursor_.at("when")  ? conditional(Equation::Kind::When, Body::Statements)
                      : cursor_.at("while") ? conditional(Equation::Kind::While, Body::Statements)
                      : cursor_.at("for")   ? forLoop(Body::Statements)
                                            : simpleStatement();
    result.keyword = word;
    result.description = description();
    result.annotation = annotation();
    cursor_.expectSemicolon("the statement");
    result.span = cursor_.spanFrom(begin);
    return result;
}

/// `break`, `return`, `x := …`, `(x, y) := f(…)`, `f(…)`
Equation Grammar::simpleStatement() {
    Equation result;
    if (cursor_.at("break") || cursor_.at("return")) {
        result.kind = cursor_.at("break") ? Equation::Kind::Break : Equation::Kind::Return;
        cursor_.next();
        return result;
    }
    result.left = primary();
    const bool isTarget =
        result.left.kind == Expression::Kind::Reference || result.left.kind == Expression::Kind::Tuple;
    if (isTarget && cursor_.take(":=")) {
        result.kind = Equation::Kind::Assign;
        result.right = expression();
        return result;
    }
    if (result.left.kind == Expression::Kind::Call) {
        result.kind = Equation::Kind::Call;
        return result;
    }
    if (cursor_.at("="))
        cursor_.fault(phrase("\"=\" is an equation"), cursor_.here(), phrase("a statement is written with \":=\""));
    cursor_.faultExpected(phrase("\":=\" in the statement"));
}

void Grammar::externalClause(ClassDefinition& definition) {
    const std::size_t begin = cursor_.index();
    cursor_.next();
    External result;
    if (cursor_.peek().kind == Token::Kind::String) result.language = unescape(cursor_.next());
    if (cursor_.atIdentifier() || cursor_.at(".")) {
        Expression first = referenceOrCall();
        if (cursor_.take("=")) {
            result.result = std::move(first);
            first = referenceOrCall();
        }
        if (first.kind != Expression::Kind::Call)
            cursor_.faultExpected(phrase("the arguments of the external function"));
        result.function = first.name.text();
        result.arguments = std::move(first.operands);
    }
    result.annotation = annotation();
    cursor_.expectSemicolon("the external function");
    result.span = cursor_.spanFrom(begin);
    definition.external = std::move(result);
}

}  // namespace analogon::syntax
