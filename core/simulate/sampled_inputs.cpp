#include "core/simulate/sampled_inputs.hpp"

#include <algorithm>
#include <cmath>

namespace analogon {

bool SampledInputs::hasHeld() const {
    return std::any_of(held.begin(), held.end(), [](char each) { return each != 0; });
}

std::vector<int> SampledInputs::heldInputs() const {
    std::vector<int> rows;
    for (Eigen::Index i = 0; i < values.rows(); ++i)
        if (isHeld(i)) rows.push_back(static_cast<int>(i));
    return rows;
}

std::vector<int> jumpsOf(const SampledInputs& inputs) {
    std::vector<int> jumps;
    const std::vector<int> held = inputs.heldInputs();
    for (Eigen::Index k = 1; k < inputs.values.cols(); ++k)
        if (std::any_of(held.begin(), held.end(),
                        [&](int i) { return inputs.values(i, k) != inputs.values(i, k - 1); }))
            jumps.push_back(static_cast<int>(k));
    return jumps;
}

std::vector<int> trueKinks(const SampledInputs& inputs, double tolerance) {
    const int count = static_cast<int>(inputs.time.size());
    std::vector<int> kinks;
    if (count == 0) return kinks;
    kinks.push_back(0);
    Eigen::VectorXd range = Eigen::VectorXd::Zero(inputs.values.rows());
    if (inputs.values.size() > 0) {
        range = inputs.values.rowwise().maxCoeff() - inputs.values.rowwise().minCoeff();
    }
    // A long, slightly bent stretch is no line: compare with the line through the last kink's first piece, so that
    // small deviations cannot add up unseen.
    int origin = 0;
    for (int k = 1; k + 1 < count; ++k) {
        const auto at = [&](int i) { return inputs.time[static_cast<std::size_t>(i)]; };
        const double fraction = (at(k + 1) - at(origin)) / (at(origin + 1) - at(origin));
        bool isKink = false;
        for (Eigen::Index i = 0; i < inputs.values.rows() && !isKink; ++i) {
            if (range[i] == 0.0) continue;
            if (inputs.isHeld(i)) {
                isKink = inputs.values(i, k) != inputs.values(i, k - 1);
                continue;
            }
            const double base = inputs.values(i, origin);
            const double onLine = base + fraction * (inputs.values(i, origin + 1) - base);
            // The first piece's rounding is magnified by the extrapolation.
            const double slack = tolerance * range[i] * std::max(1.0, fraction);
            isKink = std::abs(inputs.values(i, k + 1) - onLine) > slack;
        }
        if (isKink) {
            kinks.push_back(k);
            origin = k;
        }
    }
    if (count > 1) kinks.push_back(count - 1);
    return kinks;
}

}  // namespace analogon
