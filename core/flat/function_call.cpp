#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string_view>

#include "core/flat/class_rules.hpp"
#include "core/flat/connections.hpp"
#include "core/flat/events.hpp"
#include "core/flat/executor.hpp"
#include "core/flat/instantiator.hpp"
#include "core/flat/refused_construct.hpp"
#include "core/flat/translator.hpp"

/// Built-in functions: elementary ones (Modelica 3.6, section 3.7.3), der, delay, noEvent, smooth, homotopy
/// (3.7.4), and those of arrays (10.3). Tables are looked up by two functions of the library.
namespace analogon {
namespace {

struct Elementary {
    std::string_view name;
    Operation operation;
    int arguments;
};

constexpr std::array elementaries{
    Elementary{"abs", Operation::Abs, 1},       Elementary{"sign", Operation::Sign, 1},
    Elementary{"sqrt", Operation::Sqrt, 1},     Elementary{"exp", Operation::Exp, 1},
    Elementary{"log", Operation::Log, 1},       Elementary{"log10", Operation::Log10, 1},
    Elementary{"sin", Operation::Sin, 1},       Elementary{"cos", Operation::Cos, 1},
    Elementary{"tan", Operation::Tan, 1},       Elementary{"asin", Operation::Asin, 1},
    Elementary{"acos", Operation::Acos, 1},     Elementary{"atan", Operation::Atan, 1},
    Elementary{"atan2", Operation::Atan2, 2},   Elementary{"sinh", Operation::Sinh, 1},
    Elementary{"cosh", Operation::Cosh, 1},     Elementary{"tanh", Operation::Tanh, 1},
    Elementary{"floor", Operation::Floor, 1},   Elementary{"ceil", Operation::Ceil, 1},
    Elementary{"integer", Operation::Floor, 1}, Elementary{"mod", Operation::Mod, 2},
    Elementary{"rem", Operation::Rem, 2},       Elementary{"div", Operation::Div, 2},
};

constexpr std::array otherFunctions{
    "der",        "delay",        "noEvent",   "smooth",     "homotopy", "min",
    "max",        "sum",          "product",   "size",       "zeros",    "ones",
    "fill",       "linspace",     "scalar",    "vector",     "pre",      "edge",
    "change",     "sample",       "initial",   "terminal",   "String",   "cat",
    "transpose",  "identity",     "diagonal",  "matrix",     "ndims",    "cross",
    "skew",       "outerProduct", "symmetric", "semiLinear", "array",    "getInstanceName",
    "cardinality"};

constexpr std::array refusedFunctions{"reinit", "terminate"};

template <class Table>
bool contains(const Table& table, std::string_view name) {
    for (std::string_view entry : table)
        if (entry == name) return true;
    return false;
}

std::vector<std::string> functionNames() {
    std::vector<std::string> names(otherFunctions.begin(), otherFunctions.end());
    for (const Elementary& f : elementaries) names.emplace_back(f.name);
    return names;
}

}  // namespace

/// One call being translated.
class FunctionCall {
public:
    FunctionCall(Flattening& work, const syntax::Expression& call, const Scope& scope)
        : work_(work), pool_(work.pool), call_(call), scope_(scope), name_(call.name.text()) {
        // `.sin`: the function of the language, where a class of that name is near
        if (call.name.absolute && call.name.parts.size() == 1) name_ = name_.substr(1);
    }

    std::optional<Value> translate() {
        for (const Elementary& f : elementaries)
            if (f.name == name_) return isHidden() ? libraryFunction() : elementary(f);
        if (name_ == "der") return der();
        if (name_ == "delay") return delay();
        if (name_ == "noEvent" || name_ == "smooth") return eventFree();
        if (name_ == "homotopy") return homotopy();
        if (name_ == "min" || name_ == "max") return extremum();
        if (name_ == "sum" || name_ == "product") return reduction();
        if (name_ == "size") return size();
        if (name_ == "zeros" || name_ == "ones" || name_ == "fill") return filled();
        if (name_ == "linspace") return linspace();
        if (name_ == "scalar" || name_ == "vector") return reshaped();
        if (name_ == "Integer") return ordinal();
        if (name_ == "String") return textOf();
        if (name_ == "array") return listed();
        if (name_ == "cat") return joined();
        if (name_ == "ndims") return rank();
        if (name_ == "identity" || name_ == "diagonal") return diagonal();
        if (name_ == "transpose" || name_ == "matrix" || name_ == "symmetric") return turned();
        if (name_ == "cross" || name_ == "skew" || name_ == "outerProduct") return ofVectors();
        if (name_ == "semiLinear") return semiLinear();
        if (name_ == "getInstanceName") return instanceName();
        if (name_ == "cardinality") return cardinality();
        bool isKnown = false;
        auto event = work_.events->call(call_, scope_, isKnown);
        if (isKnown) return event;
        return libraryFunction();
    }

private:
    std::nullopt_t fail(const Text& message, const Span& span, const Text& hint = {}) {
        work_.messages.error(message, span, hint);
        return std::nullopt;
    }
    std::nullopt_t fail(const Text& message) { return fail(message, call_.span); }

    /// Arguments by position and by these names; false when they do not fit (reported).
    bool take(std::initializer_list<const char*> names, std::size_t required) {
        expressions_.assign(names.size(), nullptr);
        if (call_.operands.size() > names.size() || !call_.iterators.empty()) return wrongCount(required, names.size());
        for (std::size_t i = 0; i < call_.operands.size(); ++i) expressions_[i] = &call_.operands[i];
        for (const auto& argument : call_.named) {
            std::size_t i = 0;
            for (const char* name : names) {
                if (argument.name == name) break;
                ++i;
            }
            if (i == names.size() || expressions_[i]) {
                fail(phrase("'{}' has no free argument '{}'", name_, argument.name), argument.span);
                return false;
            }
            expressions_[i] = &argument.value;
        }
        for (std::size_t i = 0; i < required; ++i)
            if (!expressions_[i]) return wrongCount(required, names.size());
        return true;
    }

    bool wrongCount(std::size_t required, std::size_t most) {
        const std::size_t given = call_.operands.size() + call_.named.size();
        fail(required < most ? phrase("'{}' takes {} to {} arguments, not {}", name_, required, most, given)
             : most == 1     ? phrase("'{}' takes 1 argument, not {}", name_, given)
                             : phrase("'{}' takes {} arguments, not {}", name_, most, given));
        return false;
    }

    std::optional<Value> any(std::size_t i) { return work_.translator->translate(*expressions_[i], scope_); }

    std::optional<Value> numeric(std::size_t i) {
        auto value = any(i);
        if (value && !value->isNumeric())
            return fail(phrase("'{}' needs numbers, not {}", name_, typeText(*value)), expressions_[i]->span);
        return value;
    }

    std::optional<Value> numericScalar(std::size_t i) {
        auto value = numeric(i);
        if (value && !value->isScalar())
            return fail(phrase("'{}' needs a single number here, not {}", name_, typeText(*value)),
                        expressions_[i]->span);
        return value;
    }

    std::optional<std::vector<double>> constantVector(std::size_t i) {
        const auto value = numeric(i);
        if (!value) return std::nullopt;
        std::vector<double> numbers;
        if (value->dimensions.size() == 1)
            for (ExpressionId element : value->elements)
                if (const auto number = work_.translator->constantNumber(element, true)) numbers.push_back(*number);
        if (value->dimensions.size() == 1 && numbers.size() == value->elements.size()) return numbers;
        return fail(phrase("the table of '{}' must be a list of numbers known before the simulation", name_),
                    expressions_[i]->span);
    }

    std::optional<Ordinates> ordinateVector(std::size_t i) {
        const auto value = numeric(i);
        if (!value) return std::nullopt;
        Ordinates y(value->elements.size());
        bool isKnown = value->dimensions.size() == 1;
        for (std::size_t k = 0; k < value->elements.size() && isKnown; ++k) {
            const auto ordinate = work_.translator->ordinate(value->elements[k]);
            isKnown = ordinate.has_value();
            if (ordinate) y.set(pool_, k, *ordinate);
        }
        if (isKnown) return y;
        return fail(phrase("the table of '{}' must be a list of numbers known before the simulation", name_),
                    expressions_[i]->span);
    }

    std::optional<int> constantSize(std::size_t i) {
        const auto extent =
            work_.translator->constantInteger(*expressions_[i], scope_, phrase("an argument of '{}'", name_));
        if (!extent) return std::nullopt;
        if (*extent < 0 || static_cast<std::size_t>(*extent) > Instantiator::mostScalars)
            return fail(phrase("{} is not a possible size", *extent), expressions_[i]->span);
        return extent;
    }

    // Elementary functions of one argument work element by element (section 12.4.6).
    std::optional<Value> elementary(const Elementary& f) {
        if (!take(f.arguments == 1 ? std::initializer_list<const char*>{"x"}
                                   : std::initializer_list<const char*>{"x", "y"},
                  static_cast<std::size_t>(f.arguments)))
            return std::nullopt;
        auto x = f.arguments == 1 ? numeric(0) : numericScalar(0);
        if (!x) return x;
        if (f.arguments == 2) {
            const auto y = numericScalar(1);
            if (!y) return std::nullopt;
            const bool integer =
                x->type == FlatType::Integer && y->type == FlatType::Integer && f.operation != Operation::Atan2;
            return Value::scalar(integer ? FlatType::Integer : FlatType::Real,
                                 pool_.binary(f.operation, x->elements[0], y->elements[0]));
        }
        for (ExpressionId& element : x->elements) element = pool_.unary(f.operation, element);
        const bool keepsInteger = f.operation == Operation::Abs;
        const bool givesInteger = name_ == "integer" || f.operation == Operation::Sign;
        if (givesInteger)
            x->type = FlatType::Integer;
        else if (!keepsInteger)
            x->type = FlatType::Real;
        return x;
    }

    std::optional<Value> der() {
        if (!take({"expr"}, 1)) return std::nullopt;
        auto value = numeric(0);
        if (!value) return value;
        if (value->type != FlatType::Real)
            return fail(phrase("der needs a Real variable: an Integer does not vary continuously"),
                        expressions_[0]->span, phrase("declare the variable as Real"));
        for (ExpressionId& element : value->elements) {
            const ExpressionNode node = pool_[element];
            const bool isElement = node.operation == Operation::Variable && work_.records[node.variable.value].owner;
            if (isElement && work_.elementOf(node.variable).declaration->variability == syntax::Variability::Discrete)
                return fail(
                    phrase("'{}' changes at events alone and has no derivative", work_.variable(node.variable).name),
                    expressions_[0]->span, phrase("remove the prefix 'discrete'"));
            element = work_.translator->derivative(element, call_.span);
        }
        return value;
    }

    std::optional<Value> delay() {
        if (!take({"expr", "delayTime", "delayMax"}, 2)) return std::nullopt;
        auto signal = numeric(0);
        const auto time = numericScalar(1);
        if (!signal || !time) return std::nullopt;
        if (!work_.translator->isParametric(time->elements[0]))
            return fail(phrase("the delay time must be a parameter"), expressions_[1]->span,
                        phrase("a delay that changes while the model runs is not supported"));
        if (expressions_[2]) {
            const auto most = numericScalar(2);
            if (!most) return std::nullopt;
            const auto longest = work_.translator->constantNumber(most->elements[0], false),
                       asked = work_.translator->constantNumber(time->elements[0], false);
            if (longest && asked && *asked > *longest)
                return fail(phrase("the delay time {} is longer than the longest one, {}", *asked, *longest),
                            expressions_[1]->span, phrase("delay(signal, time, longest time)"));
        }
        signal->type = FlatType::Real;
        for (ExpressionId& element : signal->elements) element = pool_.delay(element, time->elements[0]);
        return signal;
    }

    std::optional<Value> eventFree() {
        const bool isSmooth = name_ == "smooth";
        if (!(isSmooth ? take({"p", "expr"}, 2) : take({"expr"}, 1))) return std::nullopt;
        std::optional<int> order = 0;
        if (isSmooth) order = constantSize(0);
        auto value = any(isSmooth ? 1 : 0);
        if (!order || !value) return std::nullopt;
        for (ExpressionId& element : value->elements)
            element = isSmooth ? pool_.smooth(*order, element) : pool_.unary(Operation::NoEvent, element);
        return value;
    }

    std::optional<Value> homotopy() {
        if (!take({"actual", "simplified"}, 2)) return std::nullopt;
        auto actual = any(0);
        const auto simplified = any(1);
        if (!simplified) return std::nullopt;
        return actual;
    }

    /// min(x, y), min(array), min(e for i in …)
    std::optional<Value> extremum() {
        const Operation operation = name_ == "min" ? Operation::Min : Operation::Max;
        if (call_.operands.size() == 1) return reduce(operation);
        if (!take({"x", "y"}, 2)) return std::nullopt;
        const auto x = numericScalar(0), y = numericScalar(1);
        if (!x || !y) return std::nullopt;
        const bool integer = x->type == FlatType::Integer && y->type == FlatType::Integer;
        return Value::scalar(integer ? FlatType::Integer : FlatType::Real,
                             pool_.binary(operation, x->elements[0], y->elements[0]));
    }

    std::optional<Value> reduction() { return reduce(name_ == "sum" ? Operation::Add : Operation::Multiply); }

    std::optional<Value> reduce(Operation operation) {
        if (call_.operands.size() != 1) return fail(phrase("'{}' takes one array", name_));
        std::optional<Value> array;
        if (call_.iterators.empty()) {
            array = work_.translator->translate(call_.operands[0], scope_);
        } else {
            array = work_.translator->comprehension(call_, scope_, call_.iterators.size());
        }
        if (!array) return array;
        if (array->isRecord() && array->dimensions.size() == 1 && array->dimensions[0] > 0 &&
            operation == Operation::Add) {
            std::optional<Value> total = array->part(1);
            for (int k = 2; k <= array->dimensions[0] && total; ++k)
                total = combine(work_, "+", *total, array->part(k), call_.span);
            return total;
        }
        const bool isExtremum = operation == Operation::Min || operation == Operation::Max;
        const bool isOrdered = array->isNumeric() || (isExtremum && array->type == FlatType::Boolean);  // false < true
        if (!isOrdered || array->isScalar())
            return fail(phrase("'{}' needs an array of numbers, not {}", name_, typeText(*array)),
                        call_.operands[0].span);
        if (array->type == FlatType::Boolean) operation = operation == Operation::Min ? Operation::And : Operation::Or;
        if (array->elements.empty() && isExtremum) {
            if (array->type != FlatType::Boolean) return fail(phrase("'{}' of an empty array", name_));
            return Value::scalar(array->type, pool_.constant(operation == Operation::And ? 1 : 0));
        }
        ExpressionId result = isExtremum ? array->elements[0] : pool_.constant(operation == Operation::Add ? 0 : 1);
        for (ExpressionId element : array->elements) result = pool_.binary(operation, result, element);
        return Value::scalar(array->type, result);
    }

    /// In how many connections a connector stands (section 3.7.4.3).
    std::optional<Value> cardinality() {
        if (!take({"c"}, 1)) return std::nullopt;
        const syntax::Expression& operand = *expressions_[0];
        if (operand.kind != syntax::Expression::Kind::Reference)
            return fail(phrase("'cardinality' takes one connector"), operand.span);
        const auto slice = work_.translator->resolve(operand.name, scope_);
        if (!slice) return std::nullopt;
        if (!slice->element->type.isConnector || slice->variables.size() + slice->instances.size() != 1)
            return fail(phrase("'cardinality' takes one connector"), operand.span);
        const std::string& name =
            slice->instances.empty() ? work_.variable(slice->variables.front()).name : slice->instances.front()->name;
        const std::optional<int> count = work_.connections->cardinality(name);
        if (!count)
            return fail(phrase("'cardinality' can stand in equations and their conditions alone"), call_.span,
                        phrase("where no connection depends on it"));
        return Value::scalar(FlatType::Integer, pool_.constant(*count));
    }

    /// The array need not have a value: components have a size too.
    std::optional<Value> sized() {
        const syntax::Expression& operand = *expressions_[0];
        const bool isComponent = operand.kind == syntax::Expression::Kind::Reference && scope_.instance &&
                                 !operand.name.absolute && scope_.instance->find(operand.name.parts.front().identifier);
        if (!isComponent) return any(0);
        const auto slice = work_.translator->resolve(operand.name, scope_);
        if (!slice) return std::nullopt;
        Value value;
        value.dimensions = slice->dimensions;
        return value;
    }

    /// A leading size of what is being declared: A[:, size(A, 1)].
    std::optional<Value> sizeUnderWay() {
        const syntax::Expression& operand = *expressions_[0];
        const bool isName = operand.kind == syntax::Expression::Kind::Reference && scope_.instance &&
                            !operand.name.absolute && operand.name.parts.size() == 1 &&
                            operand.name.parts[0].subscripts.empty() && expressions_[1] &&
                            expressions_[1]->kind == syntax::Expression::Kind::Number;
        const Element* const element = isName ? scope_.instance->find(operand.name.parts[0].identifier) : nullptr;
        if (!element || element->state != Element::State::Busy) return std::nullopt;
        const double at = expressions_[1]->number;
        if (!(at >= 1) || at > static_cast<double>(element->dimensions.size())) return std::nullopt;
        return Value::scalar(FlatType::Integer, pool_.constant(element->dimensions[static_cast<std::size_t>(at) - 1]));
    }

    std::optional<Value> size() {
        if (!take({"A", "i"}, 1)) return std::nullopt;
        if (const auto known = sizeUnderWay()) return known;
        const auto array = sized();
        if (!array) return array;
        if (!expressions_[1]) {
            Value sizes;
            sizes.type = FlatType::Integer;
            sizes.dimensions = {static_cast<int>(array->dimensions.size())};
            for (int extent : array->dimensions) sizes.elements.push_back(pool_.constant(extent));
            return sizes;
        }
        const auto i = constantSize(1);
        if (!i) return std::nullopt;
        if (*i < 1 || static_cast<std::size_t>(*i) > array->dimensions.size())
            return fail(phrase("{} has no dimension {}", typeText(*array), *i), expressions_[1]->span);
        return Value::scalar(FlatType::Integer, pool_.constant(array->dimensions[static_cast<std::size_t>(*i) - 1]));
    }

    std::optional<Value> filled() {
        const std::size_t first = name_ == "fill" ? 1 : 0;
        if (call_.operands.size() <= first || !call_.named.empty())
            return fail(phrase("'{}' needs the sizes of the array", name_));
        for (const auto& operand : call_.operands) expressions_.push_back(&operand);
        std::optional<Value> value = Value::scalar(FlatType::Integer, pool_.constant(name_ == "ones" ? 1 : 0));
        if (name_ == "fill") value = any(0);
        if (!value) return value;
        if (value->isRecord() || value->isObject())
            return fail(phrase("'fill' needs a single value"), expressions_[0]->span);
        Value result = *value;
        result.dimensions.clear();
        const std::size_t each = value->size();  // of an array that is repeated
        std::size_t count = 1;
        for (std::size_t i = first; i < expressions_.size(); ++i) {
            const auto extent = constantSize(i);
            if (!extent) return std::nullopt;
            result.dimensions.push_back(*extent);
            count *= static_cast<std::size_t>(*extent);
            if (count * std::max<std::size_t>(each, 1) > Instantiator::mostScalars)
                return fail(phrase("an array of more than {} elements", Instantiator::mostScalars));
        }
        if (!work_.translator->spend(count * each, call_.span)) return std::nullopt;
        result.dimensions.insert(result.dimensions.end(), value->dimensions.begin(), value->dimensions.end());
        result.texts.clear();
        result.elements.clear();
        for (std::size_t k = 0; k < count; ++k) {
            result.texts.insert(result.texts.end(), value->texts.begin(), value->texts.end());
            result.elements.insert(result.elements.end(), value->elements.begin(), value->elements.end());
        }
        return result;
    }

    std::optional<Value> linspace() {
        if (!take({"x1", "x2", "n"}, 3)) return std::nullopt;
        const auto first = numericScalar(0), last = numericScalar(1);
        const auto count = constantSize(2);
        if (!first || !last || !count) return std::nullopt;
        if (*count < 2) return fail(phrase("'linspace' needs 2 points or more"), expressions_[2]->span);
        Value result;
        result.dimensions = {*count};
        const ExpressionId span = pool_.subtract(last->elements[0], first->elements[0]);
        for (int i = 0; i < *count; ++i)
            result.elements.push_back(pool_.add(
                first->elements[0], pool_.multiply(pool_.constant(static_cast<double>(i) / (*count - 1)), span)));
        return result;
    }

    std::optional<Value> reshaped() {
        if (!take({"A"}, 1)) return std::nullopt;
        auto array = any(0);
        if (!array) return array;
        if (name_ == "scalar" && array->size() != 1)
            return fail(phrase("'scalar' needs one element, not {}", typeText(*array)));
        array->dimensions.clear();
        if (name_ == "vector") array->dimensions.push_back(static_cast<int>(array->size()));
        return array;
    }

    std::optional<Value> ordinal() {
        if (!take({"e"}, 1)) return std::nullopt;
        auto value = any(0);
        if (!value) return value;
        if (value->type == FlatType::Integer && value->enumeration.empty()) return value;
        if (value->enumeration.empty())
            return fail(phrase("'Integer' needs an enumeration, not {}", typeText(*value)), expressions_[0]->span);
        value->enumeration.clear();
        return value;
    }

    std::optional<Value> table(LookupTable::Interpolation interpolation) {
        if (!take({"x", "xs", "ys"}, 3)) return std::nullopt;
        return tableOf(0, 1, 2, interpolation);
    }

    /// As the Modelica Standard Library has it: abscissas and ordinates first.
    std::optional<Value> interpolation() {
        if (!take({"x", "y", "xi"}, 3)) return std::nullopt;
        return tableOf(2, 0, 1, LookupTable::Interpolation::Linear);
    }

    std::optional<Value> tableOf(std::size_t at, std::size_t abscissas, std::size_t ordinates,
                                 LookupTable::Interpolation interpolation) {
        auto x = numeric(at);
        const auto xs = constantVector(abscissas);
        const auto ys = ordinateVector(ordinates);
        if (!x || !xs || !ys) return std::nullopt;
        if (xs->empty() || xs->size() != ys->numbers.size())
            return fail(phrase("the table has {} abscissas and {} ordinates", xs->size(), ys->numbers.size()));
        for (std::size_t i = 1; i < xs->size(); ++i)
            if (!((*xs)[i] > (*xs)[i - 1]))
                return fail(phrase("the abscissas of the table must rise: {} follows {}", (*xs)[i], (*xs)[i - 1]),
                            expressions_[abscissas]->span);
        const TableSum lookup = curveThrough(pool_, *xs, *ys, interpolation);
        x->type = FlatType::Real;
        for (ExpressionId& element : x->elements) element = lookup.at(pool_, element);
        return x;
    }

    const syntax::Expression* named(std::string_view name) const {
        for (const syntax::NamedArgument& argument : call_.named)
            if (argument.name == name) return &argument.value;
        return nullptr;
    }

    /// At least as long as asked for, blanks behind it unless the argument leftJustified is false.
    std::string padded(std::string text) {
        const syntax::Expression* const length = named("minimumLength");
        const auto least =
            length ? work_.translator->constantInteger(*length, scope_, phrase("an argument of '{}'", name_))
                   : std::optional(0);
        const syntax::Expression* const side = named("leftJustified");
        const auto left = side ? work_.translator->constantBoolean(*side, scope_, phrase("an argument of '{}'", name_))
                               : std::optional(true);
        const auto missing = static_cast<std::size_t>(std::max(0, least.value_or(0) - static_cast<int>(text.size())));
        return left.value_or(true) ? text + std::string(missing, ' ') : std::string(missing, ' ') + text;
    }

    /// With as many significant digits, or in the format that is asked for (section 3.7.1).
    std::optional<Value> numberText(double number) {
        if (const syntax::Expression* const format = named("format")) {
            const auto text = work_.translator->translate(*format, scope_);
            if (!text || text->type != FlatType::String || !text->isScalar()) return std::nullopt;
            std::string pattern = text->texts[0];
            const std::string_view allowed = "0123456789.+-# fFeEgGdi";
            const bool isSound = !pattern.empty() && pattern.find_first_not_of(allowed) == std::string::npos &&
                                 std::string_view("fFeEgGdi").find(pattern.back()) != std::string_view::npos;
            if (!isSound)
                return fail(phrase("'{}' is no format of a number", pattern), format->span,
                            phrase("write for example \"8.3f\""));
            if (pattern.front() == '-') pattern.front() = '<';
            const bool isWhole = pattern.back() == 'd' || pattern.back() == 'i';
            if (isWhole) pattern.pop_back();
            try {
                return Value::text(isWhole ? fmt::format(fmt::runtime("{:" + pattern + "d}"), std::lround(number))
                                           : fmt::format(fmt::runtime("{:" + pattern + "}"), number));
            } catch (const fmt::format_error&) {
                return fail(phrase("'{}' is no format of a number", text->texts[0]), format->span,
                            phrase("write for example \"8.3f\""));
            }
        }
        const syntax::Expression* const digits = named("significantDigits");
        const auto most = digits
                              ? work_.translator->constantInteger(*digits, scope_, phrase("an argument of '{}'", name_))
                              : std::optional(6);
        if (!most || *most < 1 || *most > 17) return std::nullopt;
        return Value::text(padded(fmt::format("{:.{}g}", number, *most)));
    }

    /// A number, a truth value or a text as text; of what changes, its name.
    std::optional<Value> textOf() {
        if (call_.operands.empty()) return fail(phrase("'{}' takes 1 argument, not {}", name_, 0));
        const auto value = work_.translator->translate(call_.operands[0], scope_);
        if (!value || !value->isScalar()) return std::nullopt;
        if (value->type == FlatType::String) return value;
        const auto number = value->elements.size() == 1 && work_.translator->isParametric(value->elements[0])
                                ? work_.translator->constantNumber(value->elements[0], false)
                                : std::nullopt;
        if (!number) return openText(*value);
        std::string text;
        if (value->type == FlatType::Boolean)
            text = *number != 0 ? "true" : "false";
        else if (const LibraryClass* type = work_.library.find(value->enumeration);
                 type && type->definition->isEnumeration)
            text = type->definition->enumeration.at(static_cast<std::size_t>(*number) - 1);
        else
            return numberText(*number);
        return Value::text(padded(std::move(text)));
    }

    /// Of what runs: in a message the expression itself.
    Value openText(const Value& of) {
        Value open = Value::text(fmt::format("{{{}}}", call_.operands[0].span.text()));
        open.isOpen = true;
        if (!of.isScalar() || of.elements.size() != 1) return open;
        const ExpressionId value = of.elements[0];
        if (of.type == FlatType::Boolean)
            open.choices = {{padded("true"), value}, {padded("false"), work_.pool.unary(Operation::Not, value)}};
        const LibraryClass* type = of.enumeration.empty() ? nullptr : work_.library.find(of.enumeration);
        if (!type || !type->definition->isEnumeration) return open;
        for (double number = 1; const std::string& literal : type->definition->enumeration)
            open.choices.emplace_back(padded(literal),
                                      work_.pool.binary(Operation::Equal, value, work_.pool.constant(number++)));
        return open;
    }

    /// array(a, b, …)
    std::optional<Value> listed() {
        syntax::Expression list = call_;
        list.kind = syntax::Expression::Kind::Array;
        return work_.translator->translate(list, scope_);
    }

    std::optional<Value> joined() {
        if (call_.operands.size() < 2 || !call_.named.empty())
            return fail(phrase("'cat' takes a dimension and arrays"));
        const auto along =
            work_.translator->constantInteger(call_.operands[0], scope_, phrase("an argument of '{}'", name_));
        if (!along) return std::nullopt;
        std::vector<Value> parts;
        for (std::size_t i = 1; i < call_.operands.size(); ++i) {
            auto part = work_.translator->translate(call_.operands[i], scope_);
            if (!part) return part;
            if (*along < 1 || static_cast<std::size_t>(*along) > part->dimensions.size())
                return fail(phrase("{} has no dimension {}", typeText(*part), *along), call_.operands[i].span);
            parts.push_back(std::move(*part));
        }
        return work_.translator->concatenated(parts, static_cast<std::size_t>(*along) - 1, call_.span);
    }

    std::optional<Value> rank() {
        if (!take({"A"}, 1)) return std::nullopt;
        const auto array = sized();
        if (!array) return array;
        return Value::scalar(FlatType::Integer, pool_.constant(static_cast<double>(array->dimensions.size())));
    }

    std::optional<Value> diagonal() {
        if (!take({"v"}, 1)) return std::nullopt;
        Value result;
        std::vector<ExpressionId> along;
        if (name_ == "identity") {
            const auto n = constantSize(0);
            if (!n) return std::nullopt;
            along.assign(static_cast<std::size_t>(*n), pool_.constant(1));
            result.type = FlatType::Integer;
        } else {
            const auto v = numeric(0);
            if (!v) return v;
            if (v->dimensions.size() != 1) return fail(phrase("'{}' needs a vector, not {}", name_, typeText(*v)));
            along = v->elements;
            result.type = v->type;
        }
        const auto n = static_cast<int>(along.size());
        if (!work_.translator->spend(along.size() * along.size(), call_.span)) return std::nullopt;
        result.dimensions = {n, n};
        result.elements.assign(along.size() * along.size(), pool_.constant(0));
        for (std::size_t i = 0; i < along.size(); ++i) result.elements[i * along.size() + i] = along[i];
        return result;
    }

    std::optional<Value> turned() {
        if (!take({"A"}, 1)) return std::nullopt;
        auto a = any(0);
        if (!a) return a;
        if (name_ == "matrix") {
            for (std::size_t d = 2; d < a->dimensions.size(); ++d)
                if (a->dimensions[d] != 1) return fail(phrase("'{}' needs a matrix, not {}", name_, typeText(*a)));
            a->dimensions.resize(2, 1);
            return a;
        }
        const bool isMatrix = a->dimensions.size() == 2 && a->type != FlatType::String && !a->isRecord() &&
                              (name_ == "transpose" || a->dimensions[0] == a->dimensions[1]);
        if (!isMatrix) return fail(phrase("'{}' needs a matrix, not {}", name_, typeText(*a)));
        const auto rows = static_cast<std::size_t>(a->dimensions[0]),
                   columns = static_cast<std::size_t>(a->dimensions[1]);
        std::vector<ExpressionId> elements(a->elements.size());
        for (std::size_t i = 0; i < rows; ++i)
            for (std::size_t j = 0; j < columns; ++j) {
                if (name_ == "transpose")
                    elements[j * rows + i] = a->elements[i * columns + j];
                else  // the upper triangle counts
                    elements[i * columns + j] = a->elements[i <= j ? i * columns + j : j * columns + i];
            }
        a->elements = std::move(elements);
        if (name_ == "transpose") std::swap(a->dimensions[0], a->dimensions[1]);
        return a;
    }

    std::optional<Value> ofVectors() {
        const bool isOne = name_ == "skew";
        if (!(isOne ? take({"x"}, 1) : take({"x", "y"}, 2))) return std::nullopt;
        const auto x = numeric(0), y = isOne ? x : numeric(1);
        if (!x || !y) return std::nullopt;
        const bool needsThree = name_ != "outerProduct";
        if (x->dimensions.size() != 1 || y->dimensions.size() != 1 ||
            (needsThree && (x->dimensions[0] != 3 || y->dimensions[0] != 3)))
            return fail(phrase("'{}' needs a vector, not {}", name_, typeText(*x)));
        const auto& a = x->elements;
        const auto& b = y->elements;
        const auto minor = [&](std::size_t i, std::size_t j) {
            return pool_.subtract(pool_.multiply(a[i], b[j]), pool_.multiply(a[j], b[i]));
        };
        Value result;
        const ExpressionId zero = pool_.constant(0);
        if (name_ == "cross") {
            result.dimensions = {3};
            result.elements = {minor(1, 2), minor(2, 0), minor(0, 1)};
        } else if (isOne) {
            result.dimensions = {3, 3};
            result.elements = {zero, pool_.negate(a[2]), a[1], a[2], zero, pool_.negate(a[0]), pool_.negate(a[1]), a[0],
                               zero};
        } else {
            result.dimensions = {x->dimensions[0], y->dimensions[0]};
            for (const ExpressionId i : a)
                for (const ExpressionId j : b) result.elements.push_back(pool_.multiply(i, j));
        }
        return result;
    }

    std::optional<Value> semiLinear() {
        if (!take({"x", "k_p", "k_n"}, 3)) return std::nullopt;
        const auto x = numericScalar(0), p = numericScalar(1), n = numericScalar(2);
        if (!x || !p || !n) return std::nullopt;
        const ExpressionId u = x->elements[0], positive = p->elements[0], negative = n->elements[0];
        const ExpressionId zero = pool_.constant(0);
        const ExpressionId linear =
            pool_.smooth(0, pool_.ifThenElse(pool_.binary(Operation::GreaterEqual, u, zero),
                                             pool_.multiply(positive, u), pool_.multiply(negative, u)));
        // Where nothing flows a mixture that is found from k_p*x and k_n*x is left open: 0/0. A trace that flows both
        // ways makes it the mean of what is around it.
        constexpr double trace = 1e-100;
        const ExpressionId isZero = pool_.unary(Operation::NoEvent, pool_.binary(Operation::Equal, u, zero));
        const ExpressionId mixing = pool_.multiply(pool_.constant(trace), pool_.subtract(positive, negative));
        return Value::scalar(FlatType::Real, pool_.add(linear, pool_.ifThenElse(isZero, mixing, zero)));
    }

    /// "Model.component.part": the class that is simulated without its packages, then the component.
    std::optional<Value> instanceName() {
        if (!take({}, 0)) return std::nullopt;
        if (!scope_.instance) return fail(phrase("'{}' stands in a function, which is no component", name_));
        const std::string& model = work_.model.name;
        const std::string& component = scope_.instance->component().name;
        std::string found = model.substr(model.rfind('.') + 1) + (component.empty() ? "" : "." + component);
        work_.instanceNames.insert(found);
        return Value::text(std::move(found));
    }

    /// A function, the constructor of a record or of an external object.
    std::optional<std::vector<Value>> run(const LibraryClass& definition) {
        using Restriction = syntax::ClassDefinition::Restriction;
        const Restriction restriction = definition.definition->restriction;
        if (restriction == Restriction::Function) return Executor(work_).call(definition, call_, scope_);
        if (hasOperators(definition) && call_.named.empty() && call_.iterators.empty()) {
            std::vector<Value> arguments;
            for (const syntax::Expression& operand : call_.operands) {
                auto argument = work_.translator->translate(operand, scope_);
                if (!argument) return std::nullopt;
                arguments.push_back(std::move(*argument));
            }
            auto made = Executor(work_).operatorRecord(definition.qualifiedName, arguments, call_.span);
            if (!made) return std::nullopt;
            return std::vector<Value>{std::move(*made)};
        }
        if (restriction == Restriction::Record) {
            auto value = Executor(work_).construct(definition, call_, scope_);
            if (!value) return std::nullopt;
            return std::vector<Value>{std::move(*value)};
        }
        const LibraryClass* const constructor = work_.library.find(definition.qualifiedName + ".constructor");
        if (constructor && constructor->definition->restriction == Restriction::Function)
            return Executor(work_).call(*constructor, call_, scope_);
        fail(phrase("'{}' is a {}; calling it is not supported", definition.qualifiedName, keyword(restriction)),
             call_.name.span.valid() ? call_.name.span : call_.span,
             phrase("write its equations where they are needed"));
        return std::nullopt;
    }

    /// A function that was given to the function under way.
    const Value* givenFunction() const {
        const auto& frame = work_.translator->iterators_;
        if (call_.name.absolute || call_.name.parts.size() != 1) return nullptr;
        for (auto own = frame.rbegin(); own != frame.rend(); ++own)
            if (own->first == name_) return own->second.isFunction() ? &own->second : nullptr;
        return nullptr;
    }

    /// Whether a function with an algorithm stands nearer than that of the language, as Modelica.ComplexMath.exp does
    /// within its package.
    bool isHidden() {
        if (call_.name.absolute) return false;
        const LibraryClass* nearer = work_.lookup(call_.name.text(), scope_.lexical);
        return nearer && !nearer->definition->external && !nearer->definition->algorithmSections.empty();
    }

    /// Functions known by the name they have in the library.
    std::optional<Value> libraryFunction() {
        if (const Value* given = givenFunction()) {
            const Value function = *given;  // the frame changes while it runs
            auto outputs = Executor(work_).call(*function.function, call_, scope_, &function);
            if (!outputs || outputs->empty()) return std::nullopt;
            return std::move(outputs->front());
        }
        const LibraryClass* definition = work_.lookup(call_.name, scope_.lexical);
        const std::string qualified = definition ? definition->qualifiedName : name_;
        if (qualified == "Modelica.Math.Vectors.interpolate") return interpolation();
        if (qualified == "Analogon.Tables.linear") return table(LookupTable::Interpolation::Linear);
        if (qualified == "Analogon.Tables.monotoneCubic") return table(LookupTable::Interpolation::MonotoneCubic);
        const Span& span = call_.name.span.valid() ? call_.name.span : call_.span;
        if (contains(refusedFunctions, name_)) return fail(phrase("the function '{}' is not supported", name_), span);
        if (qualified == "Modelica.Utilities.Files.loadResource") return resource();
        if (definition) {
            if (!work_.rules->mayReach(call_.name, scope_.lexical)) return std::nullopt;
            auto outputs = run(*definition);
            if (!outputs) return std::nullopt;
            if (outputs->empty()) return fail(phrase("'{}' gives no value", qualified), span);
            return std::move(outputs->front());
        }
        if (work_.isOfMissingLibrary(call_.name, scope_.lexical)) return std::nullopt;
        if (tellRefused(work_.messages, name_, span)) return std::nullopt;
        return fail(phrase("the function '{}' is not known", name_), span, didYouMean(name_, functionNames()));
    }

    /// A file that is named without a directory lies where the program runs, or beside the text that names it.
    std::string besideTheModel(const std::string& name) const {
        std::error_code problem;
        if (std::filesystem::path(name).is_absolute() || std::filesystem::exists(name, problem) || !call_.span.source)
            return name;
        const auto beside = std::filesystem::path(call_.span.source->name()).parent_path() / name;
        return std::filesystem::exists(beside, problem) ? beside.string() : name;
    }

    /// "modelica://Package/Resources/…" as a path: beside the file of the package.
    std::optional<Value> resource() {
        if (!take({"fileReference"}, 1)) return std::nullopt;
        const auto text = any(0);
        if (!text || text->type != FlatType::String || !text->isScalar()) return std::nullopt;
        const std::string& uri = text->texts[0];
        constexpr std::string_view scheme = "modelica://", file = "file:///";
        if (uri.starts_with(file)) return Value::text(uri.substr(file.size() - 1));
        if (!uri.starts_with(scheme)) return Value::text(besideTheModel(uri));
        const std::string path = uri.substr(scheme.size());
        const auto slash = path.find('/');
        const LibraryClass* package = work_.library.find(path.substr(0, slash));
        if (!package || slash == std::string::npos || !package->definition->source)
            return fail(phrase("the package of \"{}\" is not known", uri));
        const std::string& of = package->definition->source->name();
        const auto directory = of.rfind('/');
        return Value::text((directory == std::string::npos ? std::string(".") : of.substr(0, directory)) +
                           path.substr(slash));
    }

public:
    std::optional<std::vector<Value>> translateAll() {
        const LibraryClass* definition = work_.lookup(call_.name, scope_.lexical);
        const bool isOwn = definition &&
                           definition->definition->restriction == syntax::ClassDefinition::Restriction::Function &&
                           !definition->qualifiedName.starts_with("Analogon.Tables.");
        if (isOwn) return run(*definition);
        auto value = translate();
        if (!value) return std::nullopt;
        return std::vector<Value>{std::move(*value)};
    }

private:
    Flattening& work_;
    ExpressionPool& pool_;
    const syntax::Expression& call_;
    const Scope& scope_;
    std::string name_;
    std::vector<const syntax::Expression*> expressions_;
};

std::optional<std::vector<Value>> Translator::outputsOf(const syntax::Expression& expression, const Scope& scope) {
    if (expression.kind == syntax::Expression::Kind::Call) return FunctionCall(work_, expression, scope).translateAll();
    auto value = translate(expression, scope);
    if (!value) return std::nullopt;
    return std::vector<Value>{std::move(*value)};
}

std::optional<Value> callFunction(Flattening& work, const syntax::Expression& call, const Scope& scope) {
    return FunctionCall(work, call, scope).translate();
}

}  // namespace analogon
