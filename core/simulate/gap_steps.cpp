#include "core/simulate/gap_steps.hpp"

#include <algorithm>
#include <cstdint>

#include "core/simulate/interval_stepper.hpp"

namespace analogon {

namespace {

constexpr int kFirst = 16;

}  // namespace

GapSteps::GapSteps(const SampledInputs& inputs, const Gaps& gaps) : inputs_(inputs), gaps_(gaps) { reset(); }

void GapSteps::reset() { steps_.assign(gaps_.intervals().size(), kFirst); }

GridPlan GapSteps::across(const GridPlan& plan) const {
    if (isEmpty() || plan.steps) return plan;
    const int usual = plan.method == GridMethod::Esdirk ? -plan.substeps : plan.substeps;
    std::vector<std::int16_t> steps(inputs_.time.size() - 1, static_cast<std::int16_t>(usual));
    for (std::size_t g = 0; g < steps_.size(); ++g)
        steps[static_cast<std::size_t>(intervals()[g])] = static_cast<std::int16_t>(-steps_[g]);
    GridPlan across = planOf(std::move(steps));
    across.errorEstimate = plan.errorEstimate;
    return across;
}

int GapSteps::intervalAt(double time) const {
    const auto next = std::upper_bound(inputs_.time.begin(), inputs_.time.end(), time);
    return std::max(0, static_cast<int>(next - inputs_.time.begin()) - 1);
}

bool GapSteps::refineAt(double time) {
    const auto gap = std::find(intervals().begin(), intervals().end(), intervalAt(time));
    if (gap == intervals().end()) return false;
    int& steps = steps_[static_cast<std::size_t>(gap - intervals().begin())];
    if (2 * steps > kMostInGap) return false;
    steps *= 2;
    return true;
}

void GapSteps::resolve(Dynamics& dynamics, const SimulationOptions& options, const Eigen::MatrixXd& states,
                       double tolerance, const Progress& progress) {
    if (isEmpty()) return;
    constexpr double share = 0.1;  // of the tolerance
    const Eigen::ArrayXd ranges = (states.rowwise().maxCoeff() - states.rowwise().minCoeff())
                                      .cwiseMax(1e-6 * states.cwiseAbs().rowwise().maxCoeff())
                                      .cwiseMax(1e-300)
                                      .array();
    InputSlots slots(dynamics, inputs_, &gaps_);
    IntervalStepper stepper(dynamics, slots, inputs_, options);
    Eigen::VectorXd coarse(states.rows()), fine = coarse;
    for (std::size_t g = 0; g < steps_.size(); ++g) {
        const int gap = intervals()[g];
        const Eigen::VectorXd from = states.col(gap);
        int& steps = steps_[g];
        if (!stepper.cross(gap, true, steps, from.data(), coarse.data())) continue;
        while (2 * steps <= kMostInGap && !progress.stopRequested()) {
            if (!stepper.cross(gap, true, 2 * steps, from.data(), fine.data())) break;
            const double moved = ((fine - coarse).array().abs() / ranges).maxCoeff();
            if (moved <= share * tolerance) break;
            steps *= 2;
            coarse.swap(fine);
        }
    }
}

}  // namespace analogon
