#include <algorithm>

#include "core/flat/translator.hpp"

/// Ranges that a type or a subscript gives (Modelica 3.6, sections 11.2.2.1 and 11.2.2.2).
namespace analogon {
namespace {

using Kind = syntax::Expression::Kind;

/// A name with the iterator as one of its last subscripts, and which of them.
struct Use {
    const syntax::Name* name{};
    std::size_t subscript{};
};

void collectUses(const std::string& iterator, const syntax::Expression& expression, std::vector<Use>& uses) {
    const auto& parts = expression.name.parts;
    for (std::size_t p = 0; p < parts.size(); ++p)
        for (std::size_t s = 0; s < parts[p].subscripts.size(); ++s) {
            const syntax::Expression& subscript = parts[p].subscripts[s];
            const bool isIterator = subscript.kind == Kind::Reference && subscript.name.parts.size() == 1 &&
                                    subscript.name.parts[0].identifier == iterator;
            if (isIterator && p + 1 == parts.size() && expression.kind == Kind::Reference)
                uses.push_back({&expression.name, s});
            else
                collectUses(iterator, subscript, uses);
        }
    for (const syntax::Expression& operand : expression.operands) collectUses(iterator, operand, uses);
    for (const syntax::NamedArgument& argument : expression.named) collectUses(iterator, argument.value, uses);
}

void collectExpressions(const syntax::Equation& equation, std::vector<const syntax::Expression*>& found) {
    found.push_back(&equation.left);
    found.push_back(&equation.right);
    for (const auto& branch : equation.branches) {
        if (branch.condition) found.push_back(&*branch.condition);
        for (const syntax::Equation& inner : branch.body) collectExpressions(inner, found);
    }
    for (const syntax::Equation& inner : equation.body) collectExpressions(inner, found);
}

bool sameValues(const Value& a, const Value& b) {
    return a.dimensions == b.dimensions && a.type == b.type && a.enumeration == b.enumeration;
}

}  // namespace

std::optional<Value> Translator::valuesOfType(const syntax::Expression& expression, const Scope& scope) {
    if (expression.kind != Kind::Reference ||
        (scope.instance && !expression.name.absolute && scope.instance->find(expression.name.parts.front().identifier)))
        return std::nullopt;
    for (const auto& [name, value] : iterators_)
        if (name == expression.name.parts.front().identifier) return std::nullopt;
    Value all;
    int first = 1, count = 0;
    if (expression.name.text() == "Boolean") {
        all.type = FlatType::Boolean;
        first = 0;
        count = 2;
    } else {
        const LibraryClass* const type = work_.lookup(expression.name, scope.lexical);
        if (!type || !type->definition->isEnumeration) return std::nullopt;
        all.type = FlatType::Integer;
        all.enumeration = type->qualifiedName;
        count = static_cast<int>(type->definition->enumeration.size());
    }
    all.dimensions = {count};
    for (int k = 0; k < count; ++k) all.elements.push_back(work_.pool.constant(first + k));
    return all;
}

/// The values of one dimension of a variable; nothing: it is not known.
std::optional<Value> Translator::dimensionRange(const syntax::Name& name, std::size_t subscript, const Scope& scope) {
    const auto upTo = [&](const std::vector<int>& dimensions) -> std::optional<Value> {
        if (subscript >= dimensions.size()) return std::nullopt;
        Value range;
        range.type = FlatType::Integer;
        range.dimensions = {dimensions[subscript]};
        for (int k = 1; k <= dimensions[subscript]; ++k) range.elements.push_back(work_.pool.constant(k));
        return range;
    };
    if (name.parts.size() == 1)
        for (auto own = iterators_.rbegin(); own != iterators_.rend(); ++own)
            if (own->first == name.parts[0].identifier) return upTo(own->second.dimensions);
    syntax::Name whole = name;
    whole.parts.back().subscripts.clear();
    const Messages::Quiet quiet(work_.messages);
    const auto slice = resolve(whole, scope);
    if (!slice) return std::nullopt;
    const Element& element = *slice->element;
    if (subscript < element.declaration->dimensions.size())
        if (auto all = valuesOfType(element.declaration->dimensions[subscript], element.scope)) return all;
    return upTo(element.dimensions);
}

std::optional<Value> Translator::impliedRange(const std::string& iterator,
                                              const std::vector<const syntax::Expression*>& within, const Scope& scope,
                                              const Span& span) {
    std::vector<Use> uses;
    for (const syntax::Expression* expression : within) collectUses(iterator, *expression, uses);
    std::optional<Value> range;
    for (const Use& use : uses) {
        auto here = dimensionRange(*use.name, use.subscript, scope);
        if (here && range && !sameValues(*here, *range)) {
            work_.messages.error(phrase("the iterator '{}' stands for dimensions of different sizes", iterator),
                                 use.name->span, phrase("write: for i in 1:n"));
            return std::nullopt;
        }
        if (here) range = std::move(here);
    }
    if (!range)
        work_.messages.error(phrase("the iterator '{}' needs a range", iterator), span, phrase("write: for i in 1:n"));
    return range;
}

std::optional<Value> Translator::rangeOf(const syntax::Equation& loop, std::size_t iterator, const Scope& scope) {
    const auto& [name, range, span] = loop.iterators[iterator];
    if (range.kind != Kind::Empty) return this->range(range, scope);
    std::vector<const syntax::Expression*> within;
    for (const syntax::Equation& equation : loop.body) collectExpressions(equation, within);
    return impliedRange(name, within, scope, span);
}

}  // namespace analogon
