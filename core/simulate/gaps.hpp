#pragma once

#include <vector>

#include "core/simulate/sampled_inputs.hpp"

namespace analogon {

/// The steps of a stretch of time: all alike, or each by the same factor longer than the one before it. Twice as many
/// of them are the halves of each.
struct Substeps {
    double begin{}, end{};
    int count{1};
    double growth{1};  // of the length of a step, from begin to end, with infinitely many of them

    double time(int step) const;  // at which it begins; `count`: the end
    double length(int step) const { return growth > 1 ? time(step + 1) - time(step) : (end - begin) / count; }
};

/// Where a recording was interrupted: sample intervals, few beside the others, that are far longer than most. What a
/// model does in one of them says nothing of the steps that it needs elsewhere. It begins where the model is in motion
/// and ends where it rests: implicit steps grow there from the usual length to that of the gap.
class Gaps {
public:
    explicit Gaps(const SampledInputs& inputs);

    const std::vector<int>& intervals() const { return intervals_; }
    bool has(int interval) const;
    Substeps implicitSteps(int interval, int count) const;

private:
    const std::vector<double>& time_;
    std::vector<int> intervals_;
    double usual_{};  // length of most intervals [s]
};

}  // namespace analogon
