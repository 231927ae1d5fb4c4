#pragma once

#include <vector>

#include "core/simulate/gaps.hpp"
#include "core/simulate/grid.hpp"

namespace analogon {

inline constexpr int kMostInGap = 512;  // implicit steps

/// How many implicit steps each gap of a recording takes: as many as halving them asks for, with no part in the choice
/// of the others.
class GapSteps {
public:
    /// Of these inputs; both must outlive it.
    GapSteps(const SampledInputs& inputs, const Gaps& gaps);

    const std::vector<int>& intervals() const { return gaps_.intervals(); }
    bool isEmpty() const { return gaps_.intervals().empty(); }
    bool has(int interval) const { return gaps_.has(interval); }
    /// Whether a time lies in a gap.
    bool holds(double time) const { return has(intervalAt(time)); }

    /// A plan with these steps in the gaps; one that has steps for each interval as it is.
    GridPlan across(const GridPlan& plan) const;
    void reset();
    /// Twice as many in the gap that holds a time. False: none does, or it has as many as may be.
    bool refineAt(double time);
    /// As many as are needed in each, from where a run over the record is before it.
    void resolve(Dynamics& dynamics, const SimulationOptions& options, const Eigen::MatrixXd& states, double tolerance,
                 const Progress& progress);

private:
    int intervalAt(double time) const;

    const SampledInputs& inputs_;
    const Gaps& gaps_;
    std::vector<int> steps_;
};

}  // namespace analogon
