#pragma once

#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "core/flat/flattening.hpp"
#include "core/flat/translator.hpp"
#include "core/flat/value.hpp"

namespace analogon {

using ScalarValue = std::pair<VariableId, ExpressionId>;

/// The scalar variables of a slice, those within records included, in order.
std::vector<VariableId> variablesOf(const Slice& slice);
/// Variable by variable what a value gives them; empty when they do not fit (reported).
std::vector<ScalarValue> scalarsOf(Flattening& work, const Slice& slice, const Value& value, const Span& span);
/// Offsets of the chosen elements (0-based lists, one a dimension) in a row-major array.
std::vector<std::size_t> elementOffsets(const std::vector<std::vector<int>>& lists, const std::vector<int>& dimensions);

/// What the equations of a class say about events (Modelica 3.6, section 8.3.5 and 3.7.5).
class Events {
public:
    explicit Events(Flattening& work) : work_(work) {}

    /// The value of a variable right before the event.
    ExpressionId pre(VariableId id);
    /// pre, edge, change, initial, terminal, sample; nothing: it is another function, or at fault (reported).
    std::optional<Value> call(const syntax::Expression& call, const Scope& scope, bool& isKnown);

    /// When the body of `when condition then` is in force.
    std::optional<ExpressionId> activation(const syntax::Expression& condition, const Scope& scope);
    /// A when equation as one equation for each variable that it sets.
    void when(const syntax::Equation& equation, const Scope& scope);
    /// assert, terminate, reinit and messages: what is done where the guard holds.
    bool action(const syntax::Equation& statement, ExpressionId guard, const Scope& scope);
    /// Within initial algorithms and equations.
    void setInitial(bool isInitial) { isInitial_ = isInitial; }
    /// Whoever simulates without events says this.
    void refuse(const Text& message, const Span& span, const Text& hint = {});

private:
    VariableId newVariable(const std::string& name, FlatType type, bool isKnown, const Span& span);
    std::optional<Value> memory(const syntax::Expression& call, const Scope& scope, const std::string& name);
    bool staysTheSame(ExpressionId id) const;
    std::optional<Value> sample(const syntax::Expression& call, const Scope& scope);
    ExpressionId flag(VariableId& variable, const char* name);
    bool body(const std::vector<syntax::Equation>& equations, ExpressionId guard, const Scope& scope,
              std::vector<ScalarValue>& set);
    bool bodyEquality(const syntax::Equation& equation, const Scope& scope, std::vector<ScalarValue>& set);
    bool bodyConditional(const syntax::Equation& equation, std::size_t branch, ExpressionId guard, const Scope& scope,
                         std::vector<ScalarValue>& set);
    bool bodyLoop(const syntax::Equation& equation, std::size_t iterator, ExpressionId guard, const Scope& scope,
                  std::vector<ScalarValue>& set);
    bool reinit(const syntax::Expression& call, ExpressionId guard, const Scope& scope);
    bool check(const syntax::Expression& call, ExpressionId guard, const Scope& scope, bool isTerminate);

    Flattening& work_;
    std::map<VariableId, VariableId> pres_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, VariableId> samples_;
    std::map<std::uint32_t, VariableId> conditions_;
    int count_{};
    int whens_{};  // that are being read, one in the other
    bool isInitial_{};
};

}  // namespace analogon
