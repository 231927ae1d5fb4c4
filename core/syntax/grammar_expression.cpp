#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <utility>

#include "core/syntax/grammar.hpp"

namespace analogon::syntax {

namespace {

/// From this many operands on, a chain of + and - (or of * and /, and, or) becomes a balanced tree: its depth is
/// then the logarithm of its length, so that nothing that recurses over it runs out of stack.
constexpr std::size_t longChain = 64;
constexpr std::size_t longestMixedChain = 1000;

/// + stays, - turns; likewise * and /. Empty for operators that cannot be regrouped.
std::string_view inverseOf(std::string_view op) {
    if (op == "+") return "-";
    if (op == "-") return "+";
    if (op == "*") return "/";
    if (op == "/") return "*";
    if (op == ".+") return ".-";
    if (op == ".-") return ".+";
    if (op == ".*") return "./";
    if (op == "./") return ".*";
    return {};
}

bool isInverting(std::string_view op) { return op == "-" || op == "/" || op == ".-" || op == "./"; }

Expression binary(std::string op, Expression left, Expression right) {
    Expression result;
    result.kind = Expression::Kind::Binary;
    result.span = cover(left.span, right.span);
    result.text = std::move(op);
    result.operands.reserve(2);
    result.operands.push_back(std::move(left));
    result.operands.push_back(std::move(right));
    return result;
}

/// a0 op1 a1 op2 a2 … over [first, last) as a balanced tree: the right half of a split at a minus or a division
/// is grouped with its operators inverted, a - b + c - d = (a - b) + (c - d), a - b - c - d = (a - b) - (c + d).
class BalancedChain {
public:
    BalancedChain(std::vector<Expression>& operands, const std::vector<std::string>& operators)
        : operands_(operands), operators_(operators) {}

    Expression build(std::size_t first, std::size_t last, bool isInverted = false) {
        if (last - first == 1) return std::move(operands_[first]);
        const std::size_t middle = first + (last - first) / 2;
        std::string op = operators_[middle - 1];
        if (isInverted) op = inverseOf(op);
        Expression left = build(first, middle, isInverted);
        Expression right = build(middle, last, isInverted != isInverting(op));
        return binary(std::move(op), std::move(left), std::move(right));
    }

private:
    std::vector<Expression>& operands_;
    const std::vector<std::string>& operators_;
};

/// Whether all operators are of one kind: scalar, element-wise, or the same logical one.
bool canRegroup(const std::vector<std::string>& operators) {
    const std::string& first = operators.front();
    for (const std::string& op : operators) {
        if (op != first && op != inverseOf(first)) return false;
    }
    return true;
}

}  // namespace

Expression Grammar::chain(std::vector<Expression> operands, std::vector<std::string> operators) {
    if (operands.size() > longChain && canRegroup(operators)) {
        return BalancedChain(operands, operators).build(0, operands.size());
    }
    if (operands.size() > longestMixedChain) {
        cursor_.fault(phrase("a chain of {} operands that mixes scalar and element-wise operators", operands.size()),
                      cover(operands.front().span, operands.back().span), phrase("group it with parentheses"));
    }
    Expression result = std::move(operands.front());
    for (std::size_t i = 0; i < operators.size(); ++i) {
        result = binary(std::move(operators[i]), std::move(result), std::move(operands[i + 1]));
    }
    return result;
}

bool Grammar::atAny(std::initializer_list<std::string_view> words) const {
    if (cursor_.peek().kind != Token::Kind::Symbol && cursor_.peek().kind != Token::Kind::Keyword) return false;
    for (const std::string_view word : words) {
        if (cursor_.at(word)) return true;
    }
    return false;
}

/// `first op operand op operand …` for left-associative operators of one level.
template <class Operand>
Expression Grammar::chainOf(Expression first, std::initializer_list<std::string_view> words, Operand operand) {
    std::vector<Expression> operands;
    std::vector<std::string> operators;
    operands.push_back(std::move(first));
    while (atAny(words)) {
        operators.emplace_back(cursor_.textOf(cursor_.next()));
        operands.push_back(operand());
    }
    return chain(std::move(operands), std::move(operators));
}

Expression Grammar::expression() {
    const Cursor::Nesting nesting(cursor_);
    return cursor_.at("if") ? ifExpression() : simpleExpression();
}

Expression Grammar::ifExpression() {
    const std::size_t begin = cursor_.index();
    Expression result;
    result.kind = Expression::Kind::If;
    cursor_.expect("if", "at the start of an if expression");
    do {
        result.operands.push_back(expression());
        cursor_.expect("then", "behind the condition");
        result.operands.push_back(expression());
    } while (cursor_.take("elseif"));
    cursor_.expect("else", "in an if expression", "an if expression needs a value for every case");
    result.operands.push_back(expression());
    result.span = cursor_.spanFrom(begin);
    return result;
}

// Each level below hands on one named result, so that no expression is moved on its way up.

Expression Grammar::simpleExpression() {
    // Most expressions are one word long: `{0, 10}`, `R=3.1`.
    const bool isOneWord = cursor_.at(",", 1) || cursor_.at("}", 1) || cursor_.at(")", 1) || cursor_.at(";", 1);
    if (isOneWord) return primary();
    Expression result = logicalExpression();
    const bool isRange = cursor_.at(":") && !(inSubscript_ && (cursor_.at(",", 1) || cursor_.at("]", 1)));
    if (isRange) {
        Expression range;
        range.kind = Expression::Kind::Range;
        range.operands.push_back(std::move(result));
        while (range.operands.size() < 3 && cursor_.take(":")) range.operands.push_back(logicalExpression());
        range.span = cover(range.operands.front().span, range.operands.back().span);
        result = std::move(range);
    }
    return result;
}

Expression Grammar::logicalExpression() {
    Expression result = logicalTerm();
    if (cursor_.at("or")) {
        result = chainOf(std::move(result), {"or"}, [this] { return logicalTerm(); });
    }
    return result;
}

Expression Grammar::logicalTerm() {
    Expression result = logicalFactor();
    if (cursor_.at("and")) {
        result = chainOf(std::move(result), {"and"}, [this] { return logicalFactor(); });
    }
    return result;
}

Expression Grammar::logicalFactor() {
    if (!cursor_.at("not")) return relation();
    const std::size_t begin = cursor_.index();
    cursor_.next();
    Expression result;
    result.kind = Expression::Kind::Unary;
    result.text = "not";
    result.operands.push_back(relation());
    result.span = cursor_.spanFrom(begin);
    return result;
}

Expression Grammar::relation() {
    const auto isRelation = [this] { return atAny({"<", "<=", ">", ">=", "==", "<>"}); };
    Expression result = arithmetic();
    if (!isRelation()) return result;
    std::string op(cursor_.text());
    cursor_.next();
    result = binary(std::move(op), std::move(result), arithmetic());
    if (isRelation()) {
        cursor_.fault(phrase("a relation cannot be compared again"), cursor_.here(),
                      phrase("write \"a < b and b < c\""));
    }
    return result;
}

Expression Grammar::arithmetic() {
    Expression result;
    if (atAny({"+", "-", ".+", ".-"})) {
        const std::size_t begin = cursor_.index();
        result.kind = Expression::Kind::Unary;
        result.text = cursor_.textOf(cursor_.next());
        result.operands.push_back(term());
        result.span = cursor_.spanFrom(begin);
    } else {
        result = term();
    }
    if (atAny({"+", "-", ".+", ".-"})) {
        result = chainOf(std::move(result), {"+", "-", ".+", ".-"}, [this] { return term(); });
    }
    return result;
}

Expression Grammar::term() {
    Expression result = factor();
    if (atAny({"*", "/", ".*", "./"})) {
        result = chainOf(std::move(result), {"*", "/", ".*", "./"}, [this] { return factor(); });
    }
    return result;
}

Expression Grammar::factor() {
    Expression result = primary();
    if (!atAny({"^", ".^"})) return result;
    std::string op(cursor_.textOf(cursor_.next()));
    result = binary(std::move(op), std::move(result), primary());
    if (atAny({"^", ".^"})) {
        cursor_.fault(phrase("a power of a power needs parentheses"), cursor_.here(),
                      phrase("write (a^b)^c or a^(b^c)"));
    }
    return result;
}

Expression Grammar::primary() {
    const Token& token = cursor_.peek();
    switch (token.kind) {
        case Token::Kind::Integer:
        case Token::Kind::Real:
            return number();
        case Token::Kind::String:
            return string();
        case Token::Kind::Identifier:
            return referenceOrCall();
        default:
            break;
    }
    if (cursor_.at("(")) return parenthesised();
    if (cursor_.at("{")) return braces();
    if (cursor_.at("[")) return matrix();
    if (cursor_.at("der") || cursor_.at("initial") || cursor_.at("pure") || cursor_.at(".")) return referenceOrCall();

    Expression result;
    result.span = cursor_.here();
    if (cursor_.at("true") || cursor_.at("false")) {
        result.kind = Expression::Kind::Boolean;
        result.number = cursor_.at("true") ? 1.0 : 0.0;
    } else if (cursor_.at("end") && inSubscript_) {
        result.kind = Expression::Kind::End;
    } else if (cursor_.at("-") || cursor_.at("+")) {
        cursor_.fault(phrase("two operators follow each other: \"{}\"", cursor_.text()), cursor_.here(),
                      phrase("put the signed operand in parentheses: a*(-b)"));
    } else if (cursor_.at("if")) {
        cursor_.fault(phrase("an if expression within an expression needs parentheses"), cursor_.here(),
                      phrase("write a + (if b then c else d)"));
    } else {
        cursor_.faultExpected(phrase("an expression"));
    }
    cursor_.next();
    return result;
}

Expression Grammar::number() {
    const Token token = cursor_.next();
    const std::string_view text = cursor_.textOf(token);
    Expression result;
    result.kind = Expression::Kind::Number;
    result.span = cursor_.spanOf(token);
    result.isInteger = token.kind == Token::Kind::Integer;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), result.number);
    if (problem == std::errc::result_out_of_range) {
        // from_chars tells overflow and underflow alike; a value below the smallest double is 0 to us.
        const auto exponent = text.find_first_of("eE");
        const bool isTiny = exponent != std::string_view::npos && text.substr(exponent + 1).starts_with('-');
        result.number = 0.0;
        if (!isTiny) {
            cursor_.report(
                error(phrase("the number is too large"), result.span, phrase("the largest is about 1.8e308")));
        }
    }
    return result;
}

std::string Grammar::unescape(const Token& token) {
    std::string_view raw = cursor_.textOf(token);
    raw = raw.substr(1, raw.size() - 2);
    std::string result;
    result.reserve(raw.size());
    for (std::size_t i = 0; i < raw.size(); ++i) {
        if (raw[i] != '\\') {
            result += raw[i];
            continue;
        }
        static constexpr std::string_view codes = "'\"?\\abfnrtv";
        static constexpr std::string_view meanings = "'\"?\\\a\b\f\n\r\t\v";
        const std::size_t code = i + 1 < raw.size() ? codes.find(raw[i + 1]) : std::string_view::npos;
        if (code == std::string_view::npos) {
            const auto at = static_cast<std::uint32_t>(token.begin + 1 + i);
            cursor_.report(error(phrase("unknown escape in a string"), Span{cursor_.source().get(), at, at + 2},
                                 phrase("a backslash itself is written \\\\")));
            continue;
        }
        result += meanings[code];
        ++i;
    }
    return result;
}

Expression Grammar::string() {
    const Token token = cursor_.next();
    Expression result;
    result.kind = Expression::Kind::String;
    result.span = cursor_.spanOf(token);
    result.text = unescape(token);
    return result;
}

Expression Grammar::parenthesised() {
    const std::size_t begin = cursor_.index();
    const bool outer = std::exchange(inSubscript_, false);
    cursor_.expect("(", "here");
    std::vector<Expression> parts;
    do {
        if (cursor_.at(",") || cursor_.at(")")) {
            Expression left;
            left.kind = Expression::Kind::Empty;
            left.span = cursor_.behind();
            parts.push_back(std::move(left));
        } else {
            parts.push_back(expression());
        }
    } while (cursor_.take(","));
    cursor_.expect(")", "to close the parenthesis");
    inSubscript_ = outer;
    if (parts.size() == 1 && parts.front().kind == Expression::Kind::Empty && !cursor_.at(":=") && !cursor_.at("="))
        cursor_.fault(phrase("expected {}, found {}", phrase("an expression"), phrase("\"{:.60}\"", ")")),
                      cursor_.spanFrom(begin));
    if (parts.size() == 1 && parts.front().kind != Expression::Kind::Empty) {
        // The span takes the parentheses in, so that the span of an operation covers all of its text.
        parts.front().span = cursor_.spanFrom(begin);
        return selection(std::move(parts.front()), begin);
    }
    Expression tuple;
    tuple.kind = Expression::Kind::Tuple;
    tuple.operands = std::move(parts);
    tuple.span = cursor_.spanFrom(begin);
    return selection(std::move(tuple), begin);
}

/// `(…)[2]`, `(…).re`
Expression Grammar::selection(Expression from, std::size_t begin) {
    const bool isMember = cursor_.at(".") && cursor_.atIdentifier(1);
    if (!isMember && !cursor_.at("[")) return from;
    NamePart part;
    const std::size_t partBegin = cursor_.index();
    if (isMember) {
        cursor_.next();
        part.identifier = cursor_.textOf(cursor_.next());
    } else {
        part.subscripts = subscripts();
    }
    part.span = cursor_.spanFrom(partBegin);
    Expression result;
    result.kind = Expression::Kind::Select;
    result.operands.push_back(std::move(from));
    result.name.span = part.span;
    result.name.parts.push_back(std::move(part));
    result.span = cursor_.spanFrom(begin);
    return result;
}

Expression Grammar::braces() {
    const std::size_t begin = cursor_.index();
    const bool outer = std::exchange(inSubscript_, false);
    Expression array;
    array.kind = Expression::Kind::Array;
    cursor_.expect("{", "here");
    if (!cursor_.at("}")) {
        do {
            array.operands.push_back(expression());
        } while (cursor_.take(","));
    } else if (annotationDepth_ == 0) {
        cursor_.fault(phrase("an empty array"), cursor_.here(), phrase("write fill(0.0, 0) or leave the array away"));
    }
    if (array.operands.size() == 1 && cursor_.at("for")) iterators(array);
    cursor_.expect("}", "to close the array");
    inSubscript_ = outer;
    array.span = cursor_.spanFrom(begin);
    return array;
}

/// `[a, b; c, d]` concatenates. Within annotations it is {{a, b}, {c, d}}, which it is for scalars.
Expression Grammar::matrix() {
    const std::size_t begin = cursor_.index();
    const bool outer = std::exchange(inSubscript_, false);
    cursor_.next();
    Expression rows;
    rows.kind = annotationDepth_ == 0 ? Expression::Kind::Matrix : Expression::Kind::Array;
    do {
        Expression row;
        row.kind = Expression::Kind::Array;
        do {
            row.operands.push_back(expression());
        } while (cursor_.take(","));
        row.span = cover(row.operands.front().span, row.operands.back().span);
        rows.operands.push_back(std::move(row));
    } while (cursor_.take(";"));
    cursor_.expect("]", "to close the matrix");
    inSubscript_ = outer;
    rows.span = cursor_.spanFrom(begin);
    return rows;
}

Expression Grammar::referenceOrCall() {
    const std::size_t begin = cursor_.index();
    if (cursor_.at("der") || cursor_.at("initial") || cursor_.at("pure")) {
        const Token token = cursor_.next();
        if (!cursor_.at("(")) cursor_.faultExpected(phrase("\"(\" behind \"{}\"", cursor_.textOf(token)));
        Name name;
        name.parts.push_back({std::string(cursor_.textOf(token)), {}, cursor_.spanOf(token)});
        name.span = cursor_.spanOf(token);
        return call(std::move(name), begin);
    }
    Name name = componentReference();
    if (cursor_.at("(")) return call(std::move(name), begin);
    Expression result;
    result.kind = Expression::Kind::Reference;
    result.span = name.span;
    result.name = std::move(name);
    return result;
}

Expression Grammar::call(Name name, std::size_t begin) {
    const bool outer = std::exchange(inSubscript_, false);
    Expression result;
    result.kind = Expression::Kind::Call;
    result.name = std::move(name);
    cursor_.expect("(", "here");
    callArguments(result);
    cursor_.expect(")", [&] { return phrase("to close the arguments of \"{}\"", result.name.text()); });
    inSubscript_ = outer;
    result.span = cursor_.spanFrom(begin);
    return result;
}

void Grammar::callArguments(Expression& call) {
    if (cursor_.at(")")) return;
    do {
        if (cursor_.atIdentifier() && cursor_.at("=", 1)) {
            namedArgument(call);
        } else if (!call.named.empty()) {
            cursor_.fault(phrase("a positional argument behind a named one"), cursor_.here(),
                          phrase("give it a name as well"));
        } else {
            call.operands.push_back(cursor_.at("function") ? partialApplication() : expression());
        }
    } while (cursor_.take(","));
    if (call.operands.size() == 1 && call.named.empty() && cursor_.at("for")) iterators(call);
}

void Grammar::namedArgument(Expression& call) {
    const std::size_t begin = cursor_.index();
    NamedArgument argument;
    argument.name = cursor_.textOf(cursor_.next());
    cursor_.next();
    argument.value = cursor_.at("function") ? partialApplication() : expression();
    argument.span = cursor_.spanFrom(begin);
    call.named.push_back(std::move(argument));
}

/// `function f(k = 1)` (section 12.4.2.1)
Expression Grammar::partialApplication() {
    const std::size_t begin = cursor_.index();
    cursor_.next();
    Expression result;
    result.kind = Expression::Kind::Function;
    result.name = typeName();
    cursor_.expect("(", "behind the name of the function");
    while (!cursor_.at(")")) {
        if (!cursor_.atIdentifier() || !cursor_.at("=", 1))
            cursor_.faultExpected(phrase("a named argument, such as \"k = 1\""));
        namedArgument(result);
        if (!cursor_.take(",")) break;
    }
    cursor_.expect(")", [&] { return phrase("to close the arguments of \"{}\"", result.name.text()); });
    result.span = cursor_.spanFrom(begin);
    return result;
}

void Grammar::iterators(Expression& expression) {
    cursor_.expect("for", "here");
    do {
        const Token name = cursor_.expectIdentifier("the name of an iterator");
        std::vector<Expression> range;
        if (cursor_.take("in")) range.push_back(this->expression());
        expression.iterators.emplace_back(cursor_.textOf(name), std::move(range));
    } while (cursor_.take(","));
}

Name Grammar::typeName() {
    Name name;
    const std::size_t begin = cursor_.index();
    name.absolute = cursor_.take(".");
    do {
        const Token part = cursor_.expectIdentifier("a name");
        name.parts.push_back({std::string(cursor_.textOf(part)), {}, cursor_.spanOf(part)});
    } while (cursor_.take("."));
    name.span = cursor_.spanFrom(begin);
    return name;
}

Name Grammar::componentReference() {
    Name name;
    const std::size_t begin = cursor_.index();
    name.absolute = cursor_.take(".");
    do {
        const std::size_t partBegin = cursor_.index();
        NamePart part;
        part.identifier = cursor_.textOf(cursor_.expectIdentifier("a name"));
        if (cursor_.at("[")) part.subscripts = subscripts();
        part.span = cursor_.spanFrom(partBegin);
        name.parts.push_back(std::move(part));
    } while (cursor_.take("."));
    name.span = cursor_.spanFrom(begin);
    return name;
}

std::vector<Expression> Grammar::subscripts() {
    const Cursor::Nesting nesting(cursor_);
    const bool outer = std::exchange(inSubscript_, true);
    std::vector<Expression> result;
    cursor_.expect("[", "here");
    do {
        if (cursor_.at(":")) {
            Expression all;
            all.kind = Expression::Kind::Colon;
            all.span = cursor_.here();
            cursor_.next();
            result.push_back(std::move(all));
        } else {
            result.push_back(expression());
        }
    } while (cursor_.take(","));
    cursor_.expect("]", "to close the subscripts");
    inSubscript_ = outer;
    return result;
}

}  // namespace analogon::syntax
