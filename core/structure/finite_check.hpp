#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/diagnostic.hpp"
#include "core/flat/flat_model.hpp"
#include "core/structure/rewrite.hpp"

namespace analogon {

/// Finds equations that no finite numbers can fulfil once the parameters have their values: 1/k with k = 0, sqrt(-1).
/// A branch that need not be taken and a limit of infinity in min, max or a relation are no fault.
class FiniteCheck {
public:
    /// `rewrite` puts in the values of the parameters that are not kept. All must outlive this.
    FiniteCheck(const FlatModel& model, const ExpressionPool& pool, Rewriter& rewrite)
        : model_(model), pool_(pool), rewrite_(rewrite) {}

    std::optional<Diagnostic> operator()(const FlatEquation& equation);

private:
    bool isSenseless(ExpressionId rewritten);
    bool isInfinite(ExpressionId id) const;
    bool judge(const ExpressionNode& node) const;
    ExpressionId sourceIn(ExpressionId original);
    Text whatIsWrong(ExpressionId source);
    std::string text(ExpressionId of) const;

    const FlatModel& model_;
    const ExpressionPool& pool_;
    Rewriter& rewrite_;
    VariableId owner_;             // the parameter in whose value the last source was found
    std::vector<char> senseless_;  // by node, as far as it was asked
};

}  // namespace analogon
