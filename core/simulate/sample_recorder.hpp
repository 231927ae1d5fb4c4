#pragma once

#include <vector>

#include "core/simulate/dynamics.hpp"
#include "core/simulate/input_slots.hpp"

namespace analogon {

/// The state between two points that an integrator has just reached.
class StateInterpolant {
public:
    virtual ~StateInterpolant() = default;
    /// x (n), dx (n x K; null when K = 0) and x' (n) at a time between the two points.
    virtual bool at(double t, double* x, double* dx, double* xdot) = 0;
};

/// Sizes what a run over so many samples keeps: states when asked, variables that are observed, and outputs with
/// their tangents unless they are poured into a sink one by one.
void makeRoom(Trajectory& trajectory, const Dynamics& dynamics, int samples, bool keepStates, bool isPoured);

/// Turns states at the samples into outputs with tangents, and looks up what the model delays: a signal z at
/// t_k - T is evaluated as soon as the integration has passed that time, from the integrator's own interpolant,
/// so that no history is kept. Before the first sample z has its first value.
class SampleRecorder {
public:
    /// Samples first … last of the inputs go into the columns 0 … last - first of the trajectory.
    SampleRecorder(Dynamics& dynamics, InputSlots& slots, const SampledInputs& inputs, int first, int last,
                   bool keepStates, Trajectory& trajectory);

    /// Records the first sample. False: failed (reason()).
    bool start(const double* x, const double* dx);
    /// Whether a delayed value lies at or before this time.
    bool needsInterpolant(double until) const;
    /// Looks up all delayed values at or before `until`; `interval` is a hint.
    bool advance(StateInterpolant& interpolant, double until, int interval);
    bool record(int sample, const double* x, const double* dx);
    /// NaN from a sample on.
    void abandon(int sample);

    const char* reason() const { return reason_; }

private:
    struct DelayedTap {
        int delay{};  // index in Shape::delays
        int tap{};
        int next{};                    // first sample whose value is not known yet
        std::vector<double> values;    // per recorded sample
        std::vector<double> tangents;  // samples x K
    };
    bool evaluateTaps(int interval, double t, const double* dt, const double* x, const double* dx);
    int sampleAt(int interval, double t) const;  // at an end of the interval; -1: between
    bool startTaps(const double* x, const double* dx);
    void keepTap(DelayedTap& delayed, int sample);
    double sampleTime(int sample) const { return inputs_.time[static_cast<std::size_t>(sample)]; }

    Dynamics& dynamics_;
    InputSlots& slots_;
    const SampledInputs& inputs_;
    int first_{}, last_{}, n_{}, K_{};
    bool keepStates_{};
    Trajectory& trajectory_;
    std::vector<DelayedTap> delayed_;
    std::vector<double> u_, du_, y_, dy_, taps_, dtaps_;
    std::vector<double> x_, dx_, xdot_, dt_;
    std::vector<double> observed_;
    const char* reason_{"not finite"};
};

}  // namespace analogon
