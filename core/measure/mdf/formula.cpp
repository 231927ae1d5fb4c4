#include "core/measure/mdf/formula.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>
#include <string>

namespace analogon::mdf {

namespace {

struct NamedFunction {
    std::string_view name;
    double (*function)(double);
};

constexpr NamedFunction functions[] = {
    {"sin", [](double x) { return std::sin(x); }},     {"cos", [](double x) { return std::cos(x); }},
    {"tan", [](double x) { return std::tan(x); }},     {"asin", [](double x) { return std::asin(x); }},
    {"acos", [](double x) { return std::acos(x); }},   {"atan", [](double x) { return std::atan(x); }},
    {"arcsin", [](double x) { return std::asin(x); }}, {"arccos", [](double x) { return std::acos(x); }},
    {"arctan", [](double x) { return std::atan(x); }}, {"sinh", [](double x) { return std::sinh(x); }},
    {"cosh", [](double x) { return std::cosh(x); }},   {"tanh", [](double x) { return std::tanh(x); }},
    {"exp", [](double x) { return std::exp(x); }},     {"log", [](double x) { return std::log(x); }},
    {"ln", [](double x) { return std::log(x); }},      {"log10", [](double x) { return std::log10(x); }},
    {"sqrt", [](double x) { return std::sqrt(x); }},   {"abs", [](double x) { return std::abs(x); }}};

}  // namespace

/// Recursive descent; what it cannot read leaves isGood_ false.
class FormulaParser {
public:
    explicit FormulaParser(std::string_view text) : text_(text) {}

    std::optional<Formula> parse() {
        sum();
        blanks();
        if (!isGood_ || at_ != text_.size()) return std::nullopt;
        return std::move(formula_);
    }

private:
    using Operation = Formula::Operation;

    void blanks() {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
    }
    bool accept(std::string_view sign) {
        blanks();
        if (text_.substr(at_, sign.size()) != sign) return false;
        at_ += sign.size();
        return true;
    }
    void fail() { isGood_ = false; }
    void put(Formula::Step step, int growth) {
        formula_.steps_.push_back(step);
        waiting_ += growth;
        formula_.depth_ = std::max(formula_.depth_, static_cast<std::size_t>(std::max(waiting_, 0)));
    }
    void combine(Operation operation) { put({operation}, -1); }

    void sum() {
        if (++nesting_ > 100) fail();
        if (isGood_) product();
        while (isGood_) {
            if (accept("+")) {
                product();
                combine(Operation::Add);
            } else if (accept("-")) {
                product();
                combine(Operation::Subtract);
            } else {
                break;
            }
        }
        --nesting_;
    }
    void product() {
        sign();
        while (isGood_) {
            if (text_.substr(at_, 2) != "**" && accept("*")) {
                sign();
                combine(Operation::Multiply);
            } else if (accept("/")) {
                sign();
                combine(Operation::Divide);
            } else {
                break;
            }
            blanks();
        }
    }
    /// The power binds more closely than the sign before it: -X^2 is -(X^2).
    void sign() {
        if (++nesting_ > 100) fail();
        if (isGood_ && accept("-")) {
            sign();
            put({Operation::Negate}, 0);
        } else if (isGood_ && accept("+")) {
            sign();
        } else if (isGood_) {
            power();
        }
        --nesting_;
    }
    void power() {
        operand();
        if (isGood_ && (accept("**") || accept("^"))) {
            sign();
            combine(Operation::Power);
        }
        blanks();
    }
    void operand() {
        blanks();
        if (accept("(")) {
            sum();
            if (!accept(")")) fail();
        } else if (at_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_]))) {
            name();
        } else {
            number();
        }
    }
    void number() {
        double value = 0;
        const auto [end, code] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
        if (code != std::errc()) return fail();
        at_ = static_cast<std::size_t>(end - text_.data());
        put({Operation::Constant, value}, 1);
    }
    void name() {
        std::string word;
        while (at_ < text_.size() && std::isalnum(static_cast<unsigned char>(text_[at_])))
            word.push_back(static_cast<char>(std::tolower(static_cast<unsigned char>(text_[at_++]))));
        if (word == "x" || word == "x1") return put({Operation::Variable}, 1);
        if (word == "pi") return put({Operation::Constant, std::numbers::pi}, 1);
        if (!accept("(")) return fail();
        sum();
        if (word == "pow" && isGood_) {
            if (!accept(",")) return fail();
            sum();
            combine(Operation::Power);
        } else {
            const auto known = std::find_if(std::begin(functions), std::end(functions),
                                            [&](const NamedFunction& f) { return f.name == word; });
            if (known == std::end(functions)) return fail();
            put({Operation::Function, 0, known->function}, 0);
        }
        if (!accept(")")) fail();
    }

    std::string_view text_;
    std::size_t at_{};
    int nesting_{}, waiting_{};
    bool isGood_{true};
    Formula formula_;
};

std::optional<Formula> Formula::parse(std::string_view text) { return FormulaParser(text).parse(); }

void Formula::evaluate(std::span<double> values) const {
    constexpr std::size_t width = 256;  // operations run over so many values at once
    std::vector<double> waiting(depth_ * width);
    const auto binary = [](double* a, const double* b, std::size_t n, auto operation) {
        for (std::size_t i = 0; i < n; ++i) a[i] = operation(a[i], b[i]);
    };
    for (std::size_t begin = 0; begin < values.size(); begin += width) {
        const std::size_t n = std::min(width, values.size() - begin);
        double* top = waiting.data();  // one behind the last
        for (const Step& step : steps_) {
            switch (step.operation) {
                case Operation::Constant:
                    std::fill_n(top, n, step.constant);
                    top += width;
                    continue;
                case Operation::Variable:
                    std::copy_n(values.data() + begin, n, top);
                    top += width;
                    continue;
                case Operation::Negate:
                    for (std::size_t i = 0; i < n; ++i) (top - width)[i] = -(top - width)[i];
                    continue;
                case Operation::Function:
                    for (std::size_t i = 0; i < n; ++i) (top - width)[i] = step.function((top - width)[i]);
                    continue;
                default:
                    break;
            }
            top -= width;
            double* const left = top - width;
            if (step.operation == Operation::Add) binary(left, top, n, [](double a, double b) { return a + b; });
            if (step.operation == Operation::Subtract) binary(left, top, n, [](double a, double b) { return a - b; });
            if (step.operation == Operation::Multiply) binary(left, top, n, [](double a, double b) { return a * b; });
            if (step.operation == Operation::Divide) binary(left, top, n, [](double a, double b) { return a / b; });
            if (step.operation == Operation::Power)
                binary(left, top, n, [](double a, double b) { return std::pow(a, b); });
        }
        std::copy_n(waiting.data(), n, values.data() + begin);
    }
}

}  // namespace analogon::mdf
