#include <algorithm>

#include "core/flat/executor.hpp"
#include "core/flat/instantiator.hpp"
#include "core/flat/translator.hpp"

/// Functions as arguments (Modelica 3.6, section 12.4.2), and scalar functions of arrays (12.4.6).
namespace analogon {
namespace {

using ExpressionKind = syntax::Expression::Kind;
using Restriction = syntax::ClassDefinition::Restriction;

}  // namespace

std::optional<Value> Executor::functionValue(const syntax::Expression& expression, const Scope& scope) {
    Translator& translator = *work_.translator;
    const bool isPartly = expression.kind == ExpressionKind::Function;
    if (!isPartly && expression.kind != ExpressionKind::Reference) return std::nullopt;
    Value value;
    const std::string& first = expression.name.parts.front().identifier;
    for (auto own = translator.iterators_.rbegin(); own != translator.iterators_.rend(); ++own)
        if (own->first == first && expression.name.parts.size() == 1) {
            if (!own->second.isFunction()) return std::nullopt;
            value = own->second;
            break;
        }
    if (!value.isFunction()) {
        if (!isPartly && scope.instance && scope.instance->find(first)) return std::nullopt;
        value.function = work_.lookup(expression.name, scope.lexical);
        if (!value.function || value.function->definition->restriction != Restriction::Function) return std::nullopt;
    }
    for (const syntax::NamedArgument& argument : expression.named) {
        auto given = translator.translate(argument.value, scope);
        if (!given) return std::nullopt;
        value.members.emplace_back(argument.name, std::move(*given));
    }
    return value;
}

bool Executor::takesFunction(const Input& element) {
    if (builtinType(element.declaration->type)) return false;
    const LibraryClass* const type = work_.lookup(element.declaration->type, element.lexical);
    return type && type->definition->restriction == Restriction::Function;
}

/// Dimensions that an argument is declared with.
std::size_t Executor::rankOf(const Input& element) {
    std::size_t rank = element.declaration->dimensions.size();
    const LibraryClass* lexical = element.lexical;
    const syntax::Name* type = &element.declaration->type;
    for (int depth = 0; depth < 20 && !builtinType(*type); ++depth) {
        const LibraryClass* const found = work_.lookup(*type, lexical);
        if (!found || !found->definition->isShort) break;
        rank += found->definition->shortDimensions.size();
        type = &found->definition->shortBase;
        lexical = found;
    }
    return rank;
}

/// Where arguments have more dimensions than they are declared with, the function is called for each element along
/// them; arguments of the declared rank serve all calls.
std::optional<std::vector<Value>> Executor::each(const Signature& signature,
                                                 std::vector<std::pair<std::string, Value>> given,
                                                 const std::map<std::string, Input>& preset,
                                                 const syntax::Expression& call) {
    std::vector<std::size_t> longer;
    for (std::size_t i = 0; i < given.size(); ++i) {
        const auto element = std::find_if(signature.elements.begin(), signature.elements.end(),
                                          [&](const Input& e) { return e.declaration->name == given[i].first; });
        if (element == signature.elements.end()) continue;
        if (given[i].second.isFunction() && !takesFunction(*element)) {
            work_.messages.error(
                phrase("'{}' takes no function as its argument '{}'", call.name.text(), given[i].first), call.span);
            return std::nullopt;
        }
        const std::size_t rank = given[i].second.dimensions.size();
        if (rank > element->declaration->dimensions.size() && rank > rankOf(*element) && !given[i].second.isObject())
            longer.push_back(i);
    }
    if (longer.empty()) return run(signature, std::move(given), preset, call);
    const auto isOutput = [](const Input& e) { return e.declaration->causality == syntax::Causality::Output; };
    if (std::count_if(signature.elements.begin(), signature.elements.end(), isOutput) != 1) {
        work_.messages.error(
            phrase("'{}' has several outputs and cannot be called for each element of an array", call.name.text()),
            call.span, phrase("call it in a loop"));
        return std::nullopt;
    }
    const int count = given[longer.front()].second.dimensions[0];
    for (const std::size_t i : longer)
        if (given[i].second.dimensions[0] != count) {
            work_.messages.error(phrase("the arguments of '{}' differ in size", call.name.text()), call.span,
                                 phrase("the sizes must agree"));
            return std::nullopt;
        }
    std::vector<Value> results;
    for (int k = 1; k <= count; ++k) {
        auto one = given;
        for (const std::size_t i : longer) one[i].second = given[i].second.part(k);
        const auto outputs = each(signature, std::move(one), preset, call);
        if (!outputs) return std::nullopt;
        results.resize(outputs->size());
        for (std::size_t o = 0; o < outputs->size(); ++o) {
            if (k == 1) results[o].dimensions = {0};
            if (!work_.translator->append(results[o], (*outputs)[o], call.span)) return std::nullopt;
        }
    }
    return results;
}

}  // namespace analogon
