#include "core/flat/executor.hpp"
#include "core/flat/translator.hpp"

/// Assignments to elements that are known only while the model runs: `x[i] := v` with an i that changes.
namespace analogon {

/// By element, row-major: whether the subscripts mean it. They must mean one, where the statement is in force: that is
/// checked while the model runs. Nothing: the subscripts are no single Integers.
std::optional<std::vector<ExpressionId>> Executor::elementsMeant(const std::vector<int>& dimensions,
                                                                 const std::vector<syntax::Expression>& subscripts,
                                                                 const Scope& scope, const Span& span) {
    if (subscripts.size() != dimensions.size()) return std::nullopt;
    ExpressionPool& pool = work_.pool;
    Translator& translator = *work_.translator;
    const auto number = [&](int value) { return pool.constant(value); };
    ExpressionId inside = number(1);
    std::vector<ExpressionId> meant{number(1)};
    for (std::size_t d = 0; d < dimensions.size(); ++d) {
        translator.ends_.push_back(dimensions[d]);
        const auto index = translator.translate(subscripts[d], scope);
        translator.ends_.pop_back();
        if (!index || !index->isScalar() || index->type != FlatType::Integer) return std::nullopt;
        const ExpressionId at = index->elements[0];
        if (!translator.spend(meant.size() * static_cast<std::size_t>(dimensions[d]), span)) return std::nullopt;
        std::vector<ExpressionId> next;
        for (const ExpressionId before : meant)
            for (int k = 1; k <= dimensions[d]; ++k)
                next.push_back(pool.binary(Operation::And, before, pool.binary(Operation::Equal, at, number(k))));
        meant = std::move(next);
        inside = pool.binary(Operation::And, inside, pool.binary(Operation::LessEqual, number(1), at));
        inside = pool.binary(Operation::And, inside, pool.binary(Operation::LessEqual, at, number(dimensions[d])));
    }
    ExpressionId holds = pool.unary(Operation::NoEvent, inside);
    for (const ExpressionId guard : guards_)
        holds = pool.binary(Operation::Or, pool.unary(Operation::Not, guard), holds);
    work_.model.events.checks.push_back(
        {holds, phrase("the subscript of '{}' is outside the array", std::string(span.text())).english(), false, false,
         span});
    return meant;
}

/// An element of an array of the model.
bool Executor::storeWhereItRuns(const syntax::Expression& target, const Value& value, const Scope& scope) {
    const std::vector<syntax::Expression>& subscripts = target.name.parts.back().subscripts;
    if (subscripts.empty() || !value.isScalar() || value.isRecord() || value.elements.size() != 1) return false;
    Translator& translator = *work_.translator;
    const Messages::Quiet quiet(work_.messages);
    syntax::Name whole = target.name;
    whole.parts.back().subscripts.clear();
    const auto slice = translator.resolve(whole, scope);
    const auto now = slice && !slice->variables.empty() ? translator.valueOf(*slice) : std::nullopt;
    if (!now || now->elements.size() != slice->variables.size()) return false;
    const auto meant = elementsMeant(slice->dimensions, subscripts, scope, target.span);
    if (!meant) return false;
    for (std::size_t k = 0; k < meant->size(); ++k)
        translator.overlay_[slice->variables[k].value] =
            work_.pool.ifThenElse((*meant)[k], value.elements[0], now->elements[k]);
    return true;
}

}  // namespace analogon
