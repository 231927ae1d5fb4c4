#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/simulate/grid.hpp"

namespace analogon {

/// The plans of steps that are alike in every sample interval, by what they cost, and how the cheapest that is exact
/// enough is found among them.
class PlanLadder {
public:
    PlanLadder(const SimulationOptions& options, double tolerance) : options_(options), tolerance_(tolerance) {}

    std::vector<GridPlan> plans() const;  // cheapest first
    /// Plans no dearer than this one have failed.
    void passOver(const GridPlan& plan);
    /// Climbs by cost. `difference`: what finer steps than those of a plan change, in parts of the ranges; nothing:
    /// they fail. Halving the steps shows the error of the coarser plan and, where the differences fall as the order
    /// promises, that of the finer one too.
    GridPlan cheapest(const std::function<std::optional<double>(const GridPlan&, const GridPlan&)>& difference) const;
    /// Where nothing gets through: the most robust method, whose run will say where and why it fails.
    GridPlan fallback() const;

private:
    const GridPlan* cheapestWithin(const std::vector<GridPlan>& judged, double factor) const;
    bool isEnough(const std::vector<GridPlan>& judged, const GridPlan& current) const;
    GridPlan bestOf(const std::vector<GridPlan>& judged) const;

    const SimulationOptions& options_;
    double tolerance_{};
    double least_{};  // cost of what is looked at
};

}  // namespace analogon
