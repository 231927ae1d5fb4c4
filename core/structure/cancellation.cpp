#include "core/structure/cancellation.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "core/structure/index_reduction.hpp"
#include "core/structure/rewrite.hpp"

namespace analogon {
namespace {

/// sum of coefficient * derivative + rest = 0; the largest coefficient before any elimination measures what is zero.
struct Row {
    std::size_t equation{};
    std::map<int, ExpressionId> coefficients;  // by unknown
    ExpressionId rest;
    double scale{};
};

class Cancellation {
public:
    explicit Cancellation(EquationSystem& system) : system_(system), pool_(*system.pool) {}
    void run();

private:
    bool isHighestDerivative(int unknown) const {
        return isDerivative_[static_cast<std::size_t>(unknown)] &&
               !system_.unknowns[static_cast<std::size_t>(unknown)].derivative.valid();
    }
    std::optional<Row> rowOf(std::size_t equation, const std::vector<int>& unknowns);
    bool isOverParameters(ExpressionId expression);
    double valueOf(ExpressionId expression) const;
    void eliminate(std::vector<Row> rows);

    EquationSystem& system_;
    ExpressionPool& pool_;
    std::vector<char> isDerivative_;  // by unknown
};

bool Cancellation::isOverParameters(ExpressionId expression) {
    LeafCollector collect(pool_);
    for (const ExpressionId leaf : collect.leaves(expression))
        if ((*system_.model)[pool_[leaf].variable].variability == FlatVariability::Continuous) return false;
    return collect.delays().empty();
}

/// At parameters a little off their own values, each in its own way: what is zero there is zero for all of them.
double Cancellation::valueOf(ExpressionId expression) const {
    return pool_.evaluate(expression, [this](const ExpressionNode& node) -> double {
        if (node.operation != Operation::Variable) return std::nan("");
        const double value = system_.model->parameterValue(node.variable).value_or(1);
        const double shift = 1 + 0.1 * std::sin(1.0 + node.variable.value);
        return value == 0 ? shift : value * shift;
    });
}

std::optional<Row> Cancellation::rowOf(std::size_t equation, const std::vector<int>& unknowns) {
    const ExpressionId residual = system_.residual(system_.equations[equation]);
    Row row;
    row.equation = equation;
    row.rest = residual;
    for (const int u : unknowns) {
        if (!isHighestDerivative(u)) continue;
        const ExpressionId node = system_.unknowns[static_cast<std::size_t>(u)].node;
        const ExpressionId slope = pool_.differentiate(residual, node);
        if (!isOverParameters(slope)) return {};
        const double value = valueOf(slope);
        if (!std::isfinite(value) || value == 0) return {};
        row.coefficients.emplace(u, slope);
        row.scale = std::max(row.scale, std::fabs(value));
    }
    if (row.coefficients.size() < 2) return {};
    row.rest = Rewriter(pool_, [&](ExpressionId leaf) {
        const int u = system_.unknownOf(leaf);
        return u >= 0 && row.coefficients.contains(u) ? pool_.constant(0) : ExpressionId{};
    })(residual);
    return row;
}

/// Gaussian elimination; a row whose coefficients vanish becomes an equation without derivatives.
void Cancellation::eliminate(std::vector<Row> rows) {
    constexpr double negligible = 1e-11;
    std::map<int, std::size_t> pivotOf;  // unknown -> row that is kept for it
    for (std::size_t r = 0; r < rows.size(); ++r) {
        Row& row = rows[r];
        while (!row.coefficients.empty()) {
            const auto known = std::find_if(row.coefficients.begin(), row.coefficients.end(),
                                            [&](const auto& entry) { return pivotOf.contains(entry.first); });
            if (known == row.coefficients.end()) break;
            const Row& pivot = rows[pivotOf[known->first]];
            const int unknown = known->first;
            const ExpressionId factor = pool_.divide(known->second, pivot.coefficients.at(unknown));
            for (const auto& [u, c] : pivot.coefficients) {
                const ExpressionId taken = pool_.multiply(factor, c);
                const auto mine = row.coefficients.find(u);
                const ExpressionId left =
                    mine == row.coefficients.end() ? pool_.negate(taken) : pool_.subtract(mine->second, taken);
                if (u == unknown || std::fabs(valueOf(left)) <= negligible * row.scale)
                    row.coefficients.erase(u);
                else
                    row.coefficients[u] = left;
            }
            row.rest = pool_.subtract(row.rest, pool_.multiply(factor, pivot.rest));
        }
        if (row.coefficients.empty()) {
            Equation& equation = system_.equations[row.equation];
            equation.left = pool_.constant(0);
            equation.right = row.rest;
            continue;
        }
        const auto largest =
            std::max_element(row.coefficients.begin(), row.coefficients.end(), [this](const auto& a, const auto& b) {
                return std::fabs(valueOf(a.second)) < std::fabs(valueOf(b.second));
            });
        pivotOf.emplace(largest->first, r);
    }
}

void Cancellation::run() {
    isDerivative_.assign(system_.unknowns.size(), 0);
    for (const Unknown& u : system_.unknowns)
        if (u.derivativeUnknown >= 0) isDerivative_[static_cast<std::size_t>(u.derivativeUnknown)] = 1;
    const Adjacency incidence = incidenceOf(system_);
    std::vector<Row> rows;
    for (std::size_t e = 0; e < incidence.size(); ++e) {
        const auto count =
            std::count_if(incidence[e].begin(), incidence[e].end(), [this](int u) { return isHighestDerivative(u); });
        if (count < 2) continue;
        if (std::optional<Row> row = rowOf(e, incidence[e])) rows.push_back(std::move(*row));
    }
    // Groups that share derivatives; in one of as many rows as derivatives and more can rows depend on each other.
    std::vector<std::size_t> group(rows.size());
    std::iota(group.begin(), group.end(), std::size_t{0});
    const auto find = [&group](std::size_t i) {
        while (group[i] != i) i = group[i] = group[group[i]];
        return i;
    };
    std::map<int, std::size_t> firstWith;
    for (std::size_t r = 0; r < rows.size(); ++r)
        for (const auto& [u, c] : rows[r].coefficients) {
            const auto [at, isNew] = firstWith.emplace(u, r);
            if (!isNew) group[find(r)] = find(at->second);
        }
    std::map<std::size_t, std::vector<Row>> members;
    for (std::size_t r = 0; r < rows.size(); ++r) members[find(r)].push_back(std::move(rows[r]));
    constexpr std::size_t mostRows = 300;  // elimination is quadratic and more
    for (auto& [first, group_] : members)
        if (group_.size() > 1 && group_.size() <= mostRows) eliminate(std::move(group_));
}

}  // namespace

void combineCancellingDerivatives(EquationSystem& system) { Cancellation(system).run(); }

}  // namespace analogon
