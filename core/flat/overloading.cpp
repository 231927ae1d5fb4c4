#include <fmt/format.h>

#include <algorithm>

#include "core/flat/executor.hpp"
#include "core/flat/instantiator.hpp"
#include "core/flat/translator.hpp"

/// The operators of `Complex` (Modelica 3.6, chapter 14): its own functions, called for what the language would add or
/// multiply.
namespace analogon {
namespace {

using Restriction = syntax::ClassDefinition::Restriction;

/// The functions of an operator: itself, or those within it.
std::vector<const LibraryClass*> functionsOf(const Library& library, const std::string& record,
                                             std::string_view operation) {
    const LibraryClass* const named = library.find(fmt::format("{}.'{}'", record, operation));
    if (!named) return {};
    if (named->definition->restriction == Restriction::Function) return {named};
    std::vector<const LibraryClass*> found;
    for (const auto& inner : named->definition->classes)
        if (const LibraryClass* function = library.find(named->qualifiedName + "." + inner->name))
            if (function->definition->restriction == Restriction::Function) found.push_back(function);
    return found;
}

std::vector<const syntax::Component*> inputsOf(const LibraryClass& function) {
    std::vector<const syntax::Component*> inputs;
    for (const syntax::Component& component : function.definition->components)
        if (component.causality == syntax::Causality::Input) inputs.push_back(&component);
    return inputs;
}

/// Whether a value may be this argument as it is: a record for a record, a number for a number.
bool isSuch(const Value& value, const syntax::Component& input) {
    const auto builtin = builtinType(input.type);
    if (!builtin) return value.isRecord();
    return value.isNumeric() && (*builtin == value.type || *builtin == FlatType::Real);
}

}  // namespace

bool hasOperators(const LibraryClass& definition) {
    return definition.qualifiedName == "Complex" && definition.definition->restriction == Restriction::Record;
}

std::optional<Value> Executor::callWith(const LibraryClass& function, const std::vector<Value>& arguments,
                                        const Span& span) {
    Signature signature;
    std::map<std::string, Input> preset;
    if (!signatureOf(function, signature, preset, 0) || !signature.body) return std::nullopt;
    std::vector<std::pair<std::string, Value>> given;
    for (const Input& element : signature.elements)
        if (element.declaration->causality == syntax::Causality::Input && given.size() < arguments.size())
            given.emplace_back(element.declaration->name, arguments[given.size()]);
    syntax::Expression call;
    call.kind = syntax::Expression::Kind::Call;
    call.span = call.name.span = span;
    call.name.parts.push_back({function.definition->name, {}, span});
    auto outputs = each(signature, std::move(given), preset, call);
    if (!outputs || outputs->empty()) return std::nullopt;
    return std::move(outputs->front());
}

std::optional<Value> Executor::operate(const std::string& operation, std::vector<Value> arguments, const Span& span) {
    const auto record = std::find_if(arguments.begin(), arguments.end(), [](const Value& v) { return v.isRecord(); });
    const std::string name = record->record;
    const bool isDotted = operation.size() > 1 && operation.front() == '.';
    const std::string bare = isDotted ? operation.substr(1) : operation;
    const bool isArrays = arguments.size() == 2 && !arguments[0].isScalar() && !arguments[1].isScalar();
    const bool isProduct = bare == "*" && !isDotted && isArrays;
    for (const bool mayConvert : {false, true})
        for (const LibraryClass* function : functionsOf(work_.library, name, bare)) {
            const auto inputs = inputsOf(*function);
            if (inputs.size() != arguments.size()) continue;
            bool fits = true;
            for (std::size_t i = 0; i < inputs.size(); ++i) {
                const std::size_t rank = inputs[i]->dimensions.size();
                const bool sameRank = isProduct ? rank == arguments[i].dimensions.size() : rank == 0;
                const bool converts = mayConvert && arguments[i].isNumeric() && !builtinType(inputs[i]->type);
                fits = fits && sameRank && (isSuch(arguments[i], *inputs[i]) || converts);
            }
            if (!fits) continue;
            for (std::size_t i = 0; i < inputs.size(); ++i)
                if (!isSuch(arguments[i], *inputs[i])) {
                    auto made = operatorRecord(name, {arguments[i]}, span);
                    if (!made) return std::nullopt;
                    arguments[i] = std::move(*made);
                }
            return callWith(*function, arguments, span);
        }
    work_.messages.error(phrase("'{}' cannot be applied to {} and {}", operation, typeText(arguments.front()),
                                typeText(arguments.back())),
                         span);
    return std::nullopt;
}

std::optional<Value> Executor::operatorRecord(const std::string& record, const std::vector<Value>& arguments,
                                              const Span& span) {
    for (const LibraryClass* function : functionsOf(work_.library, record, "constructor")) {
        const auto inputs = inputsOf(*function);
        bool fits = arguments.size() <= inputs.size();
        for (std::size_t i = 0; fits && i < inputs.size(); ++i)
            fits = i < arguments.size() ? isSuch(arguments[i], *inputs[i]) : inputs[i]->binding.has_value();
        if (fits) return callWith(*function, arguments, span);
    }
    work_.messages.error(phrase("'{}' cannot be made of these arguments", record), span);
    return std::nullopt;
}

}  // namespace analogon
