#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>

#include "core/flat/instantiator.hpp"
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

constexpr std::array otherFunctions{"der",  "delay",    "noEvent", "smooth", "homotopy", "min",
                                    "max",  "sum",      "product", "size",   "zeros",    "ones",
                                    "fill", "linspace", "scalar",  "vector"};

constexpr std::array refusedFunctions{
    "pre",       "edge",     "change",       "sample",      "reinit",          "initial",    "terminal",
    "terminate", "inStream", "actualStream", "cardinality", "getInstanceName", "semiLinear", "spatialDistribution",
    "String",    "cross",    "transpose",    "identity",    "diagonal",        "cat",        "outerProduct",
    "symmetric", "skew",     "matrix",       "ndims"};

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
        : work_(work), pool_(work.pool), call_(call), scope_(scope), name_(call.name.text()) {}

    std::optional<Value> translate() {
        for (const Elementary& f : elementaries)
            if (f.name == name_) return elementary(f);
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
        for (ExpressionId& element : value->elements) element = work_.translator->derivative(element, call_.span);
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
        if (expressions_[2] && !numericScalar(2)) return std::nullopt;
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
        if (!array->isNumeric() || array->isScalar())
            return fail(phrase("'{}' needs an array of numbers, not {}", name_, typeText(*array)),
                        call_.operands[0].span);
        const bool isExtremum = operation == Operation::Min || operation == Operation::Max;
        if (array->elements.empty() && isExtremum) return fail(phrase("'{}' of an empty array", name_));
        ExpressionId result = isExtremum ? array->elements[0] : pool_.constant(operation == Operation::Add ? 0 : 1);
        for (ExpressionId element : array->elements) result = pool_.binary(operation, result, element);
        return Value::scalar(array->type, result);
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

    std::optional<Value> size() {
        if (!take({"A", "i"}, 1)) return std::nullopt;
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
        if (!value->isScalar()) return fail(phrase("'fill' needs a single value"), expressions_[0]->span);
        Value result = *value;
        std::size_t count = 1;
        for (std::size_t i = first; i < expressions_.size(); ++i) {
            const auto extent = constantSize(i);
            if (!extent) return std::nullopt;
            result.dimensions.push_back(*extent);
            count *= static_cast<std::size_t>(*extent);
            if (count > Instantiator::mostScalars)
                return fail(phrase("an array of more than {} elements", Instantiator::mostScalars));
        }
        if (!work_.translator->spend(count, call_.span)) return std::nullopt;
        if (result.type == FlatType::String)
            result.texts.assign(count, value->texts[0]);
        else
            result.elements.assign(count, value->elements[0]);
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
        const auto xs = constantVector(abscissas), ys = constantVector(ordinates);
        if (!x || !xs || !ys) return std::nullopt;
        if (xs->empty() || xs->size() != ys->size())
            return fail(phrase("the table has {} abscissas and {} ordinates", xs->size(), ys->size()));
        for (std::size_t i = 1; i < xs->size(); ++i)
            if (!((*xs)[i] > (*xs)[i - 1]))
                return fail(phrase("the abscissas of the table must rise: {} follows {}", (*xs)[i], (*xs)[i - 1]),
                            expressions_[abscissas]->span);
        LookupTable lookup;
        lookup.x = *xs;
        lookup.y = *ys;
        lookup.interpolation = interpolation;
        x->type = FlatType::Real;
        for (ExpressionId& element : x->elements) element = pool_.table(lookup, element);
        return x;
    }

    /// Functions known by the name they have in the library.
    std::optional<Value> libraryFunction() {
        const LibraryClass* definition = work_.lookup(call_.name, scope_.lexical);
        const std::string qualified = definition ? definition->qualifiedName : name_;
        if (qualified == "Modelica.Math.Vectors.interpolate") return interpolation();
        if (qualified == "Analogon.Tables.linear") return table(LookupTable::Interpolation::Linear);
        if (qualified == "Analogon.Tables.monotoneCubic") return table(LookupTable::Interpolation::MonotoneCubic);
        const Span& span = call_.name.span.valid() ? call_.name.span : call_.span;
        if (contains(refusedFunctions, name_)) return fail(phrase("the function '{}' is not supported", name_), span);
        if (definition)
            return fail(phrase("'{}' is a {}; calling it is not supported", qualified,
                               keyword(definition->definition->restriction)),
                        span, phrase("write its equations where they are needed"));
        return fail(phrase("the function '{}' is not known", name_), span, didYouMean(name_, functionNames()));
    }

    Flattening& work_;
    ExpressionPool& pool_;
    const syntax::Expression& call_;
    const Scope& scope_;
    std::string name_;
    std::vector<const syntax::Expression*> expressions_;
};

std::optional<Value> callFunction(Flattening& work, const syntax::Expression& call, const Scope& scope) {
    return FunctionCall(work, call, scope).translate();
}

}  // namespace analogon
