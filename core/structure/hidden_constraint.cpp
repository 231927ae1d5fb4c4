#include "core/structure/hidden_constraint.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/base/stop.hpp"
#include "core/structure/row_groups.hpp"

namespace analogon {
namespace {

/// sum of factor * unknown = 0; the largest factor before any elimination measures what is zero.
struct Sum {
    std::size_t equation{};
    std::map<int, double> factors;
    double scale{};
    std::set<std::size_t> from;  // the equations that it combines
};

class HiddenConstraints {
public:
    explicit HiddenConstraints(EquationSystem& system) : system_(system), pool_(*system.pool) {}

    void reveal() {
        std::vector<Sum> sums;
        for (std::size_t e = 0; e < system_.equations.size(); ++e)
            if (std::optional<Sum> sum = sumOf(e)) sums.push_back(std::move(*sum));
        constexpr std::size_t mostSums = 300;  // elimination is quadratic and more
        const auto othersOf = [this](const Sum& sum) { return othersThanStates(sum); };
        for (std::vector<Sum>& group : groupsThatShare(std::move(sums), othersOf))
            if (group.size() > 1 && group.size() <= mostSums && statesIn(group) > 1) eliminate(group);
    }

private:
    bool isState(int unknown) const {
        return system_.unknowns[static_cast<std::size_t>(unknown)].derivativeUnknown >= 0;
    }

    /// Adds factor * expression; false where it is no sum of unknowns with numbers as factors.
    bool add(ExpressionId of, double factor, Sum& sum) const {
        constexpr std::size_t longest = 64;
        const ExpressionNode node = pool_[of];
        switch (node.operation) {
            case Operation::Constant:
                return node.value == 0;
            case Operation::Variable:
            case Operation::Derivative: {
                const int unknown = system_.unknownOf(of);
                if (unknown < 0 || sum.factors.size() >= longest) return false;
                sum.factors[unknown] += factor;
                return true;
            }
            case Operation::Negate:
                return add(node.a, -factor, sum);
            case Operation::Add:
                return add(node.a, factor, sum) && add(node.b, factor, sum);
            case Operation::Subtract:
                return add(node.a, factor, sum) && add(node.b, -factor, sum);
            case Operation::Multiply:
                if (pool_.isConstant(node.a)) return add(node.b, factor * pool_[node.a].value, sum);
                if (pool_.isConstant(node.b)) return add(node.a, factor * pool_[node.b].value, sum);
                return false;
            default:
                return false;
        }
    }

    std::optional<Sum> sumOf(std::size_t equation) const {
        Sum sum;
        sum.equation = equation;
        sum.from = {equation};
        const Equation& e = system_.equations[equation];
        if (!add(e.left, 1, sum) || !add(e.right, -1, sum)) return {};
        for (const auto& [unknown, factor] : sum.factors) sum.scale = std::max(sum.scale, std::fabs(factor));
        std::erase_if(sum.factors, [&](const auto& entry) { return isNothing(entry.second, sum); });
        return sum;
    }

    static bool isNothing(double factor, const Sum& sum) {
        constexpr double negligible = 1e-12;
        return !(std::fabs(factor) > negligible * sum.scale);
    }

    std::vector<int> othersThanStates(const Sum& sum) const {
        std::vector<int> others;
        for (const auto& [unknown, factor] : sum.factors)
            if (!isState(unknown)) others.push_back(unknown);
        return others;
    }

    std::size_t statesIn(const std::vector<Sum>& group) const {
        std::size_t count = 0;
        for (const Sum& sum : group)
            for (const auto& [unknown, factor] : sum.factors) count += isState(unknown) ? 1 : 0;
        return count;
    }

    /// Gaussian elimination of what is no state.
    void eliminate(std::vector<Sum>& group) {
        std::map<int, const Sum*> pivotOf;  // unknown -> the sum that is kept for it
        for (Sum& sum : group) {
            stopPoint();
            const auto isKept = [&](const auto& entry) { return pivotOf.contains(entry.first); };
            for (;;) {
                const auto kept = std::find_if(sum.factors.begin(), sum.factors.end(), isKept);
                if (kept == sum.factors.end()) break;
                takeFrom(sum, *pivotOf.at(kept->first), kept->first);
            }
            const auto pivot = std::find_if(sum.factors.begin(), sum.factors.end(),
                                            [this](const auto& entry) { return !isState(entry.first); });
            if (pivot != sum.factors.end())
                pivotOf.emplace(pivot->first, &sum);
            else if (!sum.factors.empty() && isHidden(sum))
                say(sum);
        }
    }

    /// Where the equations that are combined have fewer unknowns that are no states than they are, the structure tells.
    bool isHidden(const Sum& sum) const {
        std::set<int> others;
        for (const std::size_t equation : sum.from) {
            const std::vector<int> its = othersThanStates(*sumOf(equation));
            others.insert(its.begin(), its.end());
        }
        return others.size() >= sum.from.size();
    }

    static void takeFrom(Sum& sum, const Sum& pivot, int unknown) {
        const double times = sum.factors.at(unknown) / pivot.factors.at(unknown);
        for (const auto& [u, factor] : pivot.factors) {
            double& left = sum.factors[u];
            left -= times * factor;
            if (u == unknown || isNothing(left, sum)) sum.factors.erase(u);
        }
        sum.from.insert(pivot.from.begin(), pivot.from.end());
    }

    void say(const Sum& sum) {
        ExpressionId total = pool_.constant(0);
        for (const auto& [unknown, factor] : sum.factors)
            total = pool_.add(total, pool_.multiply(pool_.constant(factor),
                                                    system_.unknowns[static_cast<std::size_t>(unknown)].node));
        Equation& equation = system_.equations[sum.equation];
        equation.left = total;
        equation.right = pool_.constant(0);
    }

    EquationSystem& system_;
    ExpressionPool& pool_;
};

}  // namespace

void revealConstraints(EquationSystem& system) { HiddenConstraints(system).reveal(); }

}  // namespace analogon
