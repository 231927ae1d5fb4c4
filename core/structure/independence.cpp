#include "core/structure/independence.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/stop.hpp"

namespace analogon {

namespace {

/// Columns that none of the others combines to, each without the rows that lead those before it.
class Elimination {
public:
    /// Whether the column is independent of those that were taken; then it is taken too.
    bool take(SparseColumn column) {
        constexpr double negligible = 1e-9;
        double scale = 0;
        for (const auto& [row, entry] : column) scale = std::max(scale, std::fabs(entry));
        std::erase_if(column, [&](const auto& entry) { return std::fabs(entry.second) <= negligible * scale; });
        for (std::optional<std::size_t> oldest = oldestLeader(column); oldest; oldest = oldestLeader(column)) {
            const auto& [leading, taken] = taken_[*oldest];
            const double factor = column.at(leading) / taken.at(leading);
            for (const auto& [row, entry] : taken) {
                double& left = column[row];
                left -= factor * entry;
                if (row == leading || std::fabs(left) <= negligible * scale) column.erase(row);
            }
        }
        if (column.empty()) return false;
        const int leading = std::max_element(column.begin(), column.end(), [](const auto& a, const auto& b) {
                                return std::fabs(a.second) < std::fabs(b.second);
                            })->first;
        leaderOf_.emplace(leading, taken_.size());
        taken_.emplace_back(leading, std::move(column));
        return true;
    }

private:
    std::optional<std::size_t> oldestLeader(const SparseColumn& column) const {
        std::optional<std::size_t> oldest;
        for (const auto& [row, entry] : column)
            if (const auto at = leaderOf_.find(row); at != leaderOf_.end() && (!oldest || at->second < *oldest))
                oldest = at->second;
        return oldest;
    }

    std::vector<std::pair<int, SparseColumn>> taken_;  // the row that leads it
    std::map<int, std::size_t> leaderOf_;              // by row
};

}  // namespace

std::optional<std::vector<std::size_t>> independentColumns(const std::vector<SparseColumn>& columns, std::size_t rank) {
    Elimination elimination;
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < columns.size() && chosen.size() < rank; ++i) {
        stopPoint();
        for (const auto& [row, entry] : columns[i])
            if (!std::isfinite(entry)) return std::nullopt;
        if (elimination.take(columns[i])) chosen.push_back(i);
    }
    return chosen.size() == rank ? std::optional(std::move(chosen)) : std::nullopt;
}

double startValueOf(const EquationSystem& system, ExpressionId expression) {
    return system.pool->evaluate(expression, [&](const ExpressionNode& node) -> double {
        if (node.operation != Operation::Variable) return 0;
        const FlatVariable& variable = (*system.model)[node.variable];
        if (variable.variability != FlatVariability::Continuous)
            return system.model->parameterValue(node.variable).value_or(1);
        const int u = system.unknownOf(system.pool->variable(node.variable));
        if (u < 0) return 0;
        const ExpressionId start = system.unknowns[static_cast<std::size_t>(u)].start;
        return start.valid() && system.pool->isConstant(start) ? (*system.pool)[start].value : 0;
    });
}

double genericValueOf(const EquationSystem& system, ExpressionId expression) {
    return system.pool->evaluate(expression, [&](const ExpressionNode& node) -> double {
        if (node.operation == Operation::Variable &&
            (*system.model)[node.variable].variability != FlatVariability::Continuous)
            return system.model->parameterValue(node.variable).value_or(1);
        const double own = node.variable.valid() ? 1.0 + node.variable.value : 0.5;
        return 1 + 0.3 * std::sin(own + (node.operation == Operation::Derivative ? 0.7 : 0));
    });
}

}  // namespace analogon
