#include "core/effect/model/shape_value.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/syntax/parser.hpp"

namespace analogon {
namespace {

using syntax::Expression;

double evaluate(const Expression& e, const ShapeContext& context) {
    const auto operand = [&](std::size_t i) { return evaluate(e.operands[i], context); };
    switch (e.kind) {
        case Expression::Kind::Number:
            return e.number;
        case Expression::Kind::Reference:
            return context.quantity(e.name.text());
        case Expression::Kind::Unary:
            return e.text == "-" ? -operand(0) : operand(0);
        case Expression::Kind::Binary:
            if (e.text == "+") return operand(0) + operand(1);
            if (e.text == "-") return operand(0) - operand(1);
            if (e.text == "*") return operand(0) * operand(1);
            if (e.text == "/") return operand(0) / operand(1);
            if (e.text == "^") return std::pow(operand(0), operand(1));
            return std::nan("");
        case Expression::Kind::Call: {
            const std::string function = e.name.text();
            if (e.operands.size() == 2 && (function == "max" || function == "min"))
                return function == "max" ? std::max(operand(0), operand(1)) : std::min(operand(0), operand(1));
            if (e.operands.size() == 1 && function == "sqrt") return std::sqrt(operand(0));
            if (e.operands.size() != 1 || e.operands[0].kind != Expression::Kind::Reference) return std::nan("");
            return context.statistic(function, e.operands[0].name.text());
        }
        case Expression::Kind::Tuple:
            return e.operands.size() == 1 ? operand(0) : std::nan("");
        default:
            return std::nan("");
    }
}

void collect(const Expression& e, std::vector<std::string>& variables) {
    const bool isOfVariable = e.kind == Expression::Kind::Call && e.name.text() != "through";
    if (isOfVariable && e.operands.size() == 1 && e.operands[0].kind == Expression::Kind::Reference)
        variables.push_back(e.operands[0].name.text());
    for (const Expression& o : e.operands) collect(o, variables);
}

Outcome<Expression> parsed(const std::string& text) {
    return syntax::parseExpression(std::make_shared<Source>("effect annotation", text));
}

}  // namespace

Outcome<double> shapeValue(const std::string& text, const ShapeContext& context) {
    Outcome<Expression> expression = parsed(text);
    if (!expression) return expression.diagnostics();
    const double value = evaluate(*expression, context);
    if (!std::isfinite(value))
        return error(phrase("'{}' has no value here", text), {},
                     phrase("it may use sample, duration and range(v), maxabs(v), rms(v), mean(v), start(v) of the "
                            "effect's variables"));
    return value;
}

std::vector<std::string> shapeVariables(const std::string& text) {
    std::vector<std::string> variables;
    if (Outcome<Expression> expression = parsed(text)) collect(*expression, variables);
    return variables;
}

}  // namespace analogon
