#pragma once

#include <optional>
#include <vector>

#include "core/simulate/dynamics.hpp"
#include "core/simulate/gaps.hpp"

namespace analogon {

/// The vector u of a system at any time of an interval between two samples: inputs by linear interpolation or held,
/// their slopes where the model needs them, inputs delayed by T (before the first sample: its value). The
/// slots of delayed signals of the model's own hold what setTapSlots() was last given. At the end of an interval a
/// held input still has the value that it has in it: atSample() is what is seen at the sample.
class InputSlots {
public:
    /// `known`: the gaps of the inputs; null: they are not looked for yet.
    InputSlots(Dynamics& dynamics, const SampledInputs& inputs, const Gaps* known = nullptr);

    int intervals() const { return sampleCount_ - 1; }
    /// Found when they are asked for first.
    const Gaps& gaps();
    /// The interval that holds t; an inner sample belongs to the interval it begins.
    int intervalOf(double t, int hint) const;

    /// Fills u (and du, slots x K, unless null) for a time of interval k (time[k] <= t <= time[k + 1]). `dt` (K, or
    /// null: zero) are the tangents of that time itself.
    void at(int interval, double t, double* u, double* du = nullptr, const double* dt = nullptr);
    /// The same at a sample, a held input having taken its value there.
    void atSample(int sample, double* u, double* du = nullptr, const double* dt = nullptr);

    /// Times inside an interval at which a kink of a delayed input arrives: steps must not straddle them. Ascending,
    /// the end of the interval last. Intervals must be asked for in ascending order.
    const std::vector<double>& piecesOf(int interval);
    /// Until released, delayed inputs are looked up on the line that is in force at this time: at the ends of a
    /// piece the line before and the one after meet, and rounding must not decide which slope counts.
    void holdLines(double t);
    void releaseLines() { holdsLines_ = false; }

    bool hasTangents() const { return hasTangents_; }  // some delay time depends on the parameters
    const std::vector<double>& delayTimes() const { return times_; }
    const std::vector<double>& delayTangents() const { return timeTangents_; }  // delays x K
    int firstDelaySlot() const { return firstDelay_; }
    bool hasHeld() const { return !held_.empty(); }
    /// Delays of held inputs.
    const std::vector<int>& heldDelays() const { return heldDelays_; }
    /// What arrives there of a held input's delay at a time, on no sample's arrival.
    double heldAt(int delay, double t) const;

    /// Values (and tangents, null: none) of the slots of one delay of a tap.
    void setTapSlot(int delay, double value, const double* tangents);
    /// A kink of a delayed input reaches the system at these times as well.
    std::vector<double> delayedTimes(const std::vector<int>& samples) const;

private:
    double slope(int input, int interval) const;
    int lineOf(double past, int hint) const;        // interval of a past time; -1: before the first sample
    int heldSampleOf(double past, int hint) const;  // the last sample at or before a past time, within rounding

    const SampledInputs& inputs_;
    const Gaps* known_;
    std::optional<Gaps> gaps_;
    std::vector<DelayInfo> delays_;
    int sampleCount_{}, inputCount_{}, firstDelay_{}, directions_{};
    bool needsSlopes_{}, hasTangents_{};
    std::vector<double> times_, timeTangents_;
    std::vector<int> cursors_;   // interval at which the last look-up of each delay ended; -1: before the start
    std::vector<int> arrivals_;  // next sample of each delayed input to arrive
    std::vector<double> pieces_;
    bool holdsLines_{};
    std::vector<double> tapValues_, tapTangents_;
    std::vector<int> held_, heldDelays_;  // inputs, and delays of such
};

}  // namespace analogon
