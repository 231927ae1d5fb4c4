#include "core/syntax/printer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>

#include "core/syntax/parser.hpp"
#include "tests/core/syntax/tree_text.hpp"

namespace analogon::syntax {
namespace {

namespace fs = std::filesystem;

SourcePtr sourceOf(std::string text) { return std::make_shared<const Source>("p.mo", std::move(text)); }

std::string printed(const std::string& text) {
    const SourcePtr source = sourceOf(text);
    const auto expression = parseExpression(source);
    return expression ? print(*expression) : format(expression.diagnostics());
}

void expectRoundTrip(const std::string& text, const std::string& name) {
    const ParseResult first = parse(sourceOf(text));
    if (hasError(first.diagnostics)) return;
    const std::string again = print(first.definition);
    const ParseResult second = parse(sourceOf(again));
    ASSERT_FALSE(hasError(second.diagnostics)) << name << "\n" << format(second.diagnostics);
    EXPECT_EQ(TreeText::of(second.definition), TreeText::of(first.definition)) << name;
    EXPECT_EQ(print(second.definition), again) << name;
}

TEST(Printer, WritesOnlyTheParenthesesThatAreNeeded) {
    EXPECT_EQ(printed("(a) + ((b*c)) - d"), "a + b*c - d");
    EXPECT_EQ(printed("a - (b - c)"), "a - (b - c)");
    EXPECT_EQ(printed("(a + b)*c/(d*e)"), "(a + b)*c/(d*e)");
    EXPECT_EQ(printed("-(a + b)^(-2)"), "-(a + b)^(-2)");
    EXPECT_EQ(printed("(-a)*b"), "(-a)*b");
    EXPECT_EQ(printed("not (a and b) or c"), "not (a and b) or c");
    EXPECT_EQ(printed("1 + (if a then b else c)"), "1 + (if a then b else c)");
    EXPECT_EQ(printed("2 .* x .^ 2"), "2 .* x .^ 2");
    EXPECT_EQ(printed("f(a,k=1)[2]"),
              "p.mo:1:9: error: expected the end of the expression, found \"[\"\n    f(a,k=1)[2]\n            ^\n");
    EXPECT_EQ(printed("{x for i in 1:2:9}"), "{x for i in 1:2:9}");
    EXPECT_EQ(printed(".a.b[:, end]"), ".a.b[:, end]");
}

TEST(Printer, NumbersReadBackAsTheSameDouble) {
    EXPECT_EQ(printNumber(0.1), "0.1");
    EXPECT_EQ(printNumber(100000), "100000");
    EXPECT_EQ(printNumber(1e7), "1e7");
    EXPECT_EQ(printNumber(2.5e-8), "2.5e-8");
    EXPECT_EQ(printNumber(0.00025), "0.00025");
    EXPECT_EQ(printNumber(0), "0");
    EXPECT_EQ(printNumber(-3.5), "-3.5");
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> mantissa(1, 10);
    std::uniform_int_distribution<int> exponent(-300, 300);
    for (int i = 0; i < 2000; ++i) {
        const double value = mantissa(random) * std::pow(10.0, exponent(random));
        const auto read = parseExpression(sourceOf(printNumber(value)));
        ASSERT_TRUE(read);
        ASSERT_EQ(read->number, value);
    }
    for (const double value : {std::numeric_limits<double>::max(), std::numeric_limits<double>::min(), 1.0 / 3}) {
        EXPECT_EQ(parseExpression(sourceOf(printNumber(value)))->number, value);
    }
}

TEST(Printer, KeepsIntegersApartFromReals) {
    EXPECT_EQ(printed("3"), "3");
    EXPECT_EQ(printed("3.0"), "3.0");
    EXPECT_EQ(printed("20000000"), "20000000");
    EXPECT_EQ(printed("2e7"), "2e7");
}

TEST(Printer, EscapesStrings) {
    EXPECT_EQ(printString("a \"b\" \\c"), "\"a \\\"b\\\" \\\\c\"");
    EXPECT_EQ(printed(R"("tab\tquote\"")"), "\"tab\tquote\\\"\"");
}

TEST(Printer, WritesOneEquationOrComponent) {
    const ParseResult result =
        parse(sourceOf("model A parameter Real x[2](each min=0)={1,2}\"d\" annotation(a(b)=1); equation for i in 1:2 "
                       "loop x[i]=1; end for; connect(a,b[1].c); end A;"));
    ASSERT_FALSE(hasError(result.diagnostics)) << format(result.diagnostics);
    const ClassDefinition& a = *result.definition.classes[0];
    EXPECT_EQ(print(a.components[0]), "parameter Real x[2](each min=0) = {1, 2} \"d\" annotation(a(b)=1);");
    EXPECT_EQ(print(a.equationSections[0].equations[0]), "for i in 1:2 loop\n  x[i] = 1;\nend for;");
    EXPECT_EQ(print(a.equationSections[0].equations[1]), "connect(a, b[1].c);");
    EXPECT_EQ(print(a.components[0].modifications[0]), "each min=0");
}

TEST(Printer, LaysOutAClass) {
    const ParseResult result =
        parse(sourceOf("within P; partial model A \"d\" import B.C; extends D(k=1); Real x; protected Real y=x; "
                       "initial equation x=1; equation y=if x>0 then 1 else 2; annotation(Icon()); end A;"));
    ASSERT_FALSE(hasError(result.diagnostics)) << format(result.diagnostics);
    EXPECT_EQ(print(result.definition),
              "within P;\n"
              "partial model A \"d\"\n"
              "  import B.C;\n"
              "  extends D(k=1);\n"
              "  Real x;\n"
              "protected\n"
              "  Real y = x;\n"
              "initial equation\n"
              "  x = 1;\n"
              "equation\n"
              "  y = if x > 0 then 1 else 2;\n"
              "  annotation(Icon());\n"
              "end A;\n");
}

TEST(Printer, WhatItWritesReadsBackAsTheSameTree) {
    const char* texts[] = {
        "within ; encapsulated package P import A = B.C; import D.*; final type T = Real[3](unit=\"m\", each min=0); "
        "type E = enumeration(a \"first\", b); connector I = input Real; replaceable model M = N constrainedby O(k=1); "
        "protected model Q extends .R(redeclare replaceable S s(x=1), each final y(z)=2 \"d\"); public Real v; end Q; "
        "end P;",
        "model A replaceable B b(redeclare final model M = N(k=2)) if c \"d\" annotation(x) constrainedby D(e=1); "
        "flow Real f; discrete output Real o; input Integer i[3]; constant Boolean t = true; protected Real q(); "
        "equation if a then b = 1; elseif c then else d = 2; end if; assert(x > 0 and not y <> z, \"m\") \"c\" "
        "annotation(q); "
        "(a, b) = f(x, n=2); -a + (-b)*(-c)^2 = (if x then 1 elseif y then 2 else 3) - 4; "
        "x[2:end - 1] = {{1, 2.5}, {i*j for i in 1:3, j in {1, 4}}}; y = sum(v for k); (1:3)*2 = 4; 'odd name'.'a\\'b' "
        "= 1; "
        "annotation(Documentation(info=\"<html>\\\"x\\\" \\\\ line\nnext</html>\"), k=[1, 2; 3, 4]); end A;",
    };
    for (const char* text : texts) {
        const ParseResult result = parse(sourceOf(text));
        ASSERT_FALSE(hasError(result.diagnostics)) << format(result.diagnostics);
        expectRoundTrip(text, text);
    }
}

/// Random expression texts from the grammar.
class RandomExpression {
public:
    explicit RandomExpression(unsigned seed) : random_(seed) {}

    std::string text(int depth) {
        if (depth == 0) return leaf();
        switch (below(9)) {
            case 0:
                return leaf();
            case 1:
                return "(" + text(depth - 1) + ")";
            case 2:
                return "f(" + text(depth - 1) + ", k=" + text(depth - 1) + ")";
            case 3:
                return "(if " + text(depth - 1) + " then " + text(depth - 1) + " else " + text(depth - 1) + ")";
            case 4:
                return "(-" + operand(depth) + ")";
            case 5:
                return "(not " + operand(depth) + ")";
            case 6:
                return chain(depth, {" + ", " - "}, 80);
            case 7:
                return chain(depth, {"*", "/"}, 80);
            default:
                return chain(depth, {"^", " < ", " and ", " or ", " .* ", " .+ "}, 2);
        }
    }

private:
    std::size_t below(std::size_t n) { return random_() % n; }
    std::string leaf() {
        static const char* leaves[] = {"a", "b.c", "x[1]", "2", "3.5", "true", "\"s\"", "{1, a}"};
        return leaves[below(8)];
    }
    std::string operand(int depth) { return below(2) == 0 ? leaf() : "(" + text(depth - 1) + ")"; }
    std::string chain(int depth, std::vector<std::string> operators, std::size_t longest) {
        std::string result = operand(depth);
        const std::size_t count = longest == 2 ? 1 : 1 + (below(4) == 0 ? below(longest) : below(4));
        for (std::size_t i = 0; i < count; ++i) {
            result += operators[below(operators.size())];
            result += i > 3 ? leaf() : operand(depth);
        }
        return result;
    }

    std::mt19937 random_;
};

TEST(Printer, RandomExpressionsReadBackAsTheSameTree) {
    RandomExpression random(11);
    for (int i = 0; i < 3000; ++i) {
        const SourcePtr source = sourceOf(random.text(3));
        const auto expression = parseExpression(source);
        ASSERT_TRUE(expression) << source->text() << format(expression.diagnostics());
        const SourcePtr again = sourceOf(print(*expression));
        const auto reread = parseExpression(again);
        ASSERT_TRUE(reread) << again->text() << format(reread.diagnostics());
        ASSERT_EQ(TreeText::of(*reread), TreeText::of(*expression)) << source->text() << "\n" << again->text();
    }
}

TEST(Printer, LongChainsInParenthesesReadBackAsTheSameTree) {
    std::string text = "a";
    for (int i = 0; i < 63; ++i) text += " + b";
    for (int level = 0; level < 5; ++level) {
        text = "(" + text + ")";
        for (int i = 0; i < 40; ++i) text += " - c";
    }
    const SourcePtr source = sourceOf(text);
    const auto expression = parseExpression(source);
    ASSERT_TRUE(expression) << format(expression.diagnostics());
    const SourcePtr again = sourceOf(print(*expression));
    EXPECT_EQ(TreeText::of(*parseExpression(again)), TreeText::of(*expression));
}

TEST(Printer, TheShippedLibraryReadsBackAsTheSameTree) {
    for (const auto& entry : fs::recursive_directory_iterator(ANALOGON_ROOT "/resources")) {
        if (entry.path().extension() != ".mo") continue;
        std::ifstream file(entry.path());
        std::stringstream text;
        text << file.rdbuf();
        expectRoundTrip(text.str(), entry.path().string());
    }
}

}  // namespace
}  // namespace analogon::syntax
