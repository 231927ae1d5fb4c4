#include <fmt/format.h>

#include <utility>

#include "core/syntax/grammar.hpp"

namespace analogon::syntax {

/// Reads equations up to the next section or the `end` of the class, going on behind a faulty one.
void Grammar::equations(EquationSection& section) {
    while (!cursor_.atEnd() && !cursor_.gaveUp() && !atSection() && !cursor_.at("end") && !cursor_.at("annotation")) {
        const std::size_t begin = cursor_.index();
        try {
            section.equations.push_back(equation());
        } catch (const SyntaxFault&) {
            recoverEquation(begin);
        }
    }
}

/// Behind the faulty equation: past the `end for` of a loop, past the `;` of anything else, but never past the end
/// of the section.
void Grammar::recoverEquation(std::size_t begin) {
    restart();
    if (cursor_.atEnd()) return;
    const std::size_t faulty = cursor_.index();
    cursor_.moveTo(begin);
    if (atBlock()) {
        skipBlock();
    } else {
        cursor_.moveTo(faulty);
        while (!cursor_.atEnd() && !cursor_.at(";") && !atSection() && !cursor_.at("end")) cursor_.next();
    }
    cursor_.take(";");
    if (cursor_.index() == begin) cursor_.next();
}

bool Grammar::atBlock() const {
    return cursor_.at("if") || cursor_.at("for") || cursor_.at("when") || cursor_.at("while");
}

/// Moves behind the `end if` (for, when, while) of the block that begins here.
void Grammar::skipBlock() {
    int open = 0;
    bool startsEquation = true;  // an `if` elsewhere is an expression and has no end
    while (!cursor_.atEnd() && !atSection()) {
        if (cursor_.at("end")) {
            if (cursor_.atIdentifier(1)) return;
            cursor_.next();
            if (atBlock()) cursor_.next();
            if (--open <= 0) return;
            startsEquation = false;
            continue;
        }
        if (startsEquation && atBlock()) ++open;
        startsEquation = cursor_.at(";") || cursor_.at("then") || cursor_.at("loop") || cursor_.at("else");
        cursor_.next();
    }
}

bool Grammar::atSection() const {
    return cursor_.at("equation") || cursor_.at("algorithm") || cursor_.at("public") || cursor_.at("protected") ||
           cursor_.at("external") ||
           (cursor_.at("initial") && (cursor_.at("equation", 1) || cursor_.at("algorithm", 1)));
}

Equation Grammar::equation() {
    const Cursor::Nesting nesting(cursor_);
    const std::size_t begin = cursor_.index();
    const Span word = cursor_.here();
    Equation result = cursor_.at("if")        ? conditional(Equation::Kind::If, Body::Equations)
                      : cursor_.at("when")    ? conditional(Equation::Kind::When, Body::Equations)
                      : cursor_.at("for")     ? forLoop(Body::Equations)
                      : cursor_.at("connect") ? connectEquation()
                                              : simpleEquation();
    result.keyword = word;
    result.description = description();
    result.annotation = annotation();
    cursor_.expectSemicolon("the equation");
    result.span = cursor_.spanFrom(begin);
    return result;
}

void Grammar::endOf(std::string_view word) {
    cursor_.expect("end", [word] { return phrase("to close \"{}\"", word); });
    if (!cursor_.take(word))
        cursor_.faultExpected(phrase("\"{}\" behind \"end\"", word),
                              phrase("the innermost open block is \"{}\"", word));
}

bool Grammar::atBodyEnd() const {
    return cursor_.atEnd() || cursor_.gaveUp() || atSection() || cursor_.at("end") || cursor_.at("else") ||
           cursor_.at("elseif") || cursor_.at("elsewhen");
}

std::vector<Equation> Grammar::equationBody() {
    std::vector<Equation> body;
    while (!atBodyEnd()) {
        const std::size_t begin = cursor_.index();
        try {
            body.push_back(equation());
        } catch (const SyntaxFault&) {
            recoverEquation(begin);
        }
    }
    return body;
}

/// `if … then … elseif … then … else … end if`, `when … then … elsewhen … then … end when`, `while … loop … end while`
Equation Grammar::conditional(Equation::Kind kind, Body of) {
    const bool isWhen = kind == Equation::Kind::When, isWhile = kind == Equation::Kind::While;
    Equation result;
    result.kind = kind;
    cursor_.next();
    do {
        Equation::Branch branch;
        branch.condition = expression();
        cursor_.expect(isWhile ? "loop" : "then", "behind the condition");
        branch.body = body(of);
        result.branches.push_back(std::move(branch));
    } while (!isWhile && cursor_.take(isWhen ? "elsewhen" : "elseif"));
    if (kind == Equation::Kind::If && cursor_.take("else")) result.branches.push_back({std::nullopt, body(of)});
    endOf(isWhen ? "when" : isWhile ? "while" : "if");
    return result;
}

Equation Grammar::forLoop(Body of) {
    Equation result;
    result.kind = Equation::Kind::For;
    cursor_.expect("for", "here");
    do {
        const std::size_t begin = cursor_.index();
        Equation::Iterator iterator;
        iterator.name = cursor_.textOf(cursor_.expectIdentifier("the name of an iterator"));
        iterator.range.kind = Expression::Kind::Empty;  // for i loop: as far as the subscripts reach
        iterator.range.span = cursor_.behind();
        if (cursor_.take("in")) iterator.range = expression();
        iterator.span = cursor_.spanFrom(begin);
        result.iterators.push_back(std::move(iterator));
    } while (cursor_.take(","));
    cursor_.expect("loop", "behind the range");
    result.body = body(of);
    endOf("for");
    return result;
}

Equation Grammar::connectEquation() {
    Equation result;
    result.kind = Equation::Kind::Connect;
    const auto connector = [this] {
        Expression reference;
        reference.kind = Expression::Kind::Reference;
        reference.name = componentReference();
        reference.span = reference.name.span;
        return reference;
    };
    cursor_.expect("connect", "here");
    cursor_.expect("(", "behind \"connect\"");
    result.left = connector();
    cursor_.expect(",", "between the two connectors", "connect(a.port, b.port)");
    result.right = connector();
    cursor_.expect(")", "behind the two connectors", "connect joins exactly two; chain more of them pairwise");
    return result;
}

Equation Grammar::simpleEquation() {
    Equation result;
    result.left = simpleExpression();
    if (cursor_.take("=")) {
        result.right = expression();
        return result;
    }
    if (cursor_.at(":=")) {
        cursor_.fault(phrase("\":=\" is an assignment of an algorithm"), cursor_.here(),
                      phrase("an equation is written with \"=\""));
    }
    const bool isComparison = result.left.kind == Expression::Kind::Binary && result.left.text == "==";
    if (isComparison) {
        cursor_.fault(phrase("\"==\" compares; an equation is written with \"=\""), result.left.span);
    }
    if (result.left.kind == Expression::Kind::Call) {
        result.kind = Equation::Kind::Call;
        return result;
    }
    if (result.left.kind == Expression::Kind::Reference && cursor_.atIdentifier()) {
        cursor_.fault(phrase("a declaration cannot stand in the equation section"), result.left.span,
                      phrase("move it before \"equation\", or write an equation \"left = right\""));
    }
    cursor_.faultExpected(phrase("\"=\" in the equation"));
}

}  // namespace analogon::syntax
