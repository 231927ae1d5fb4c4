#include "core/structure/cancellation.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/stop.hpp"
#include "core/flat/dependent_nodes.hpp"
#include "core/structure/index_reduction.hpp"
#include "core/structure/rewrite.hpp"
#include "core/structure/row_groups.hpp"

namespace analogon {
namespace {

/// A factor of a derivative, and what it is at parameters a little off their own values.
struct Coefficient {
    ExpressionId expression;
    double value{};
};

/// sum of coefficient * derivative + rest = 0; the largest coefficient before any elimination measures what is zero.
struct Row {
    std::size_t equation{};
    std::map<int, Coefficient> coefficients;  // by unknown
    ExpressionId rest;
    double scale{};
};

class Cancellation {
public:
    explicit Cancellation(EquationSystem& system) : system_(system), pool_(*system.pool), collect_(pool_) {}
    void run();

private:
    bool isHighestDerivative(int unknown) const {
        return isDerivative_[static_cast<std::size_t>(unknown)] &&
               !system_.unknowns[static_cast<std::size_t>(unknown)].derivative.valid();
    }
    std::optional<Row> rowOf(std::size_t equation, const std::vector<int>& unknowns);
    bool isOverParameters(ExpressionId expression);
    double valueOf(ExpressionId expression) const;
    enum class Elimination { Numbers, Expressions };
    bool eliminate(std::vector<Row> rows, Elimination of);
    void subtract(Row& row, const Row& pivot, int unknown, Elimination of);

    EquationSystem& system_;
    ExpressionPool& pool_;
    LeafCollector collect_;
    std::vector<char> isDerivative_;  // by unknown
};

bool Cancellation::isOverParameters(ExpressionId expression) {
    for (const ExpressionId leaf : collect_.leaves(expression))
        if ((*system_.model)[pool_[leaf].variable].variability == FlatVariability::Continuous) return false;
    return collect_.delays().empty();
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
    DependentNodes dependent(pool_, residual);
    for (const int u : unknowns) {
        if (!isHighestDerivative(u)) continue;
        const ExpressionId node = system_.unknowns[static_cast<std::size_t>(u)].node;
        const ExpressionId slope = pool_.differentiate(residual, node, dependent.of(node));
        if (!isOverParameters(slope)) return {};
        const double value = valueOf(slope);
        if (!std::isfinite(value) || value == 0) return {};
        row.coefficients.emplace(u, Coefficient{slope, value});
        row.scale = std::max(row.scale, std::fabs(value));
    }
    if (row.coefficients.size() < 2) return {};
    row.rest = Rewriter(pool_, [&](ExpressionId leaf) {
        const int u = system_.unknownOf(leaf);
        return u >= 0 && row.coefficients.contains(u) ? pool_.constant(0) : ExpressionId{};
    })(residual);
    return row;
}

/// Takes as much of a pivot row from a row as leaves nothing of one unknown.
void Cancellation::subtract(Row& row, const Row& pivot, int unknown, Elimination of) {
    constexpr double negligible = 1e-11;
    const bool isSymbolic = of == Elimination::Expressions;
    const Coefficient& mine = row.coefficients.at(unknown);
    const Coefficient& its = pivot.coefficients.at(unknown);
    const Coefficient factor{isSymbolic ? pool_.divide(mine.expression, its.expression) : ExpressionId{},
                             mine.value / its.value};
    for (const auto& [u, c] : pivot.coefficients) {
        const auto known = row.coefficients.find(u);
        const bool isKnown = known != row.coefficients.end();
        Coefficient left;
        left.value = (isKnown ? known->second.value : 0) - factor.value * c.value;
        if (u == unknown || std::fabs(left.value) <= negligible * row.scale) {
            row.coefficients.erase(u);
            continue;
        }
        if (isSymbolic) {
            const ExpressionId taken = pool_.multiply(factor.expression, c.expression);
            left.expression = isKnown ? pool_.subtract(known->second.expression, taken) : pool_.negate(taken);
        }
        row.coefficients[u] = left;
    }
    if (isSymbolic) row.rest = pool_.subtract(row.rest, pool_.multiply(factor.expression, pivot.rest));
}

/// Gaussian elimination; a row whose coefficients vanish becomes an equation without derivatives. Whether there is
/// one. By numbers alone nothing is changed: expressions grow with each step, and nearly always there is none.
bool Cancellation::eliminate(std::vector<Row> rows, Elimination of) {
    bool anyVanishes = false;
    std::map<int, std::size_t> pivotOf;  // unknown -> row that is kept for it
    for (std::size_t r = 0; r < rows.size(); ++r) {
        stopPoint();
        Row& row = rows[r];
        while (!row.coefficients.empty()) {
            const auto known = std::find_if(row.coefficients.begin(), row.coefficients.end(),
                                            [&](const auto& entry) { return pivotOf.contains(entry.first); });
            if (known == row.coefficients.end()) break;
            const int unknown = known->first;
            subtract(row, rows[pivotOf[unknown]], unknown, of);
        }
        if (row.coefficients.empty()) {
            anyVanishes = true;
            if (of == Elimination::Numbers) return true;
            Equation& equation = system_.equations[row.equation];
            equation.left = pool_.constant(0);
            equation.right = row.rest;
            continue;
        }
        const auto largest = std::max_element(
            row.coefficients.begin(), row.coefficients.end(),
            [](const auto& a, const auto& b) { return std::fabs(a.second.value) < std::fabs(b.second.value); });
        pivotOf.emplace(largest->first, r);
    }
    return anyVanishes;
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
    const auto derivativesOf = [](const Row& row) {
        std::vector<int> unknowns;
        for (const auto& [u, c] : row.coefficients) unknowns.push_back(u);
        return unknowns;
    };
    constexpr std::size_t mostRows = 300;  // elimination is quadratic and more
    for (std::vector<Row>& group : groupsThatShare(std::move(rows), derivativesOf))
        if (group.size() > 1 && group.size() <= mostRows && eliminate(group, Elimination::Numbers))
            eliminate(std::move(group), Elimination::Expressions);
}

}  // namespace

void combineCancellingDerivatives(EquationSystem& system) { Cancellation(system).run(); }

}  // namespace analogon
