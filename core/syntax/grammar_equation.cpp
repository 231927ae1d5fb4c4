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
    if (cursor_.at("when")) {
        cursor_.fault(phrase("when equations are not supported"), cursor_.here(),
                      phrase("a relation outside noEvent already is an event: write the equation with if"));
    }
    Equation result = cursor_.at("if")        ? ifEquation()
                      : cursor_.at("for")     ? forEquation()
                      : cursor_.at("connect") ? connectEquation()
                                              : simpleEquation();
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

std::vector<Equation> Grammar::equationBody() {
    std::vector<Equation> body;
    while (!cursor_.atEnd() && !cursor_.gaveUp() && !atSection() && !cursor_.at("end") && !cursor_.at("else") &&
           !cursor_.at("elseif")) {
        const std::size_t begin = cursor_.index();
        try {
            body.push_back(equation());
        } catch (const SyntaxFault&) {
            recoverEquation(begin);
        }
    }
    return body;
}

Equation Grammar::ifEquation() {
    Equation result;
    result.kind = Equation::Kind::If;
    cursor_.expect("if", "here");
    do {
        Equation::Branch branch;
        branch.condition = expression();
        cursor_.expect("then", "behind the condition");
        branch.body = equationBody();
        result.branches.push_back(std::move(branch));
    } while (cursor_.take("elseif"));
    if (cursor_.take("else")) result.branches.push_back({std::nullopt, equationBody()});
    endOf("if");
    return result;
}

Equation Grammar::forEquation() {
    Equation result;
    result.kind = Equation::Kind::For;
    cursor_.expect("for", "here");
    do {
        const std::size_t begin = cursor_.index();
        Equation::Iterator iterator;
        iterator.name = cursor_.textOf(cursor_.expectIdentifier("the name of an iterator"));
        cursor_.expect("in", "behind the iterator", "say what it runs over: for i in 1:3 loop");
        iterator.range = expression();
        iterator.span = cursor_.spanFrom(begin);
        result.iterators.push_back(std::move(iterator));
    } while (cursor_.take(","));
    cursor_.expect("loop", "behind the range");
    result.body = equationBody();
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
