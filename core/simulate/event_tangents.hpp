#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "core/eval/system.hpp"
#include "core/structure/hybrid.hpp"

namespace analogon {

/// Where a run stands: time, state, inputs and how they move, all parameters of the system between the events, slots,
/// readings and what the program made of them.
struct EventPoint {
    double time{};
    std::span<const double> x, u, inputRates;
    const std::vector<double>&parameters, &slots, &readings, &values;
};

/// When an event is: where a reading reaches the border of its relation or whole number, or where a step of the program
/// says (factor*time + offset = 0), or at a time that no parameter moves.
struct EventMoment {
    int reading{-1};
    int offset{-1};  // step
    double factor{1};
    std::vector<double> given{};  // tangents of the time, where a clock knows them
};

/// How the state and the slots of a model with events move with its parameters. Between events the sensitivities are
/// integrated; at one its time moves too, and the state jumps (Rozenwasser 1967): with f- and f+ the rates before and
/// behind, S+ = D(x+) - f+ dt, where D follows what the event does from D(x-) = S- + f- dt. All blocks are row-major,
/// quantity i and direction k at [i*K + k].
class EventTangents {
public:
    /// `directions`: parameters of `system` x K. `slotAt`, `readingAt`: which parameter each slot, which output each
    /// reading is.
    EventTangents(const HybridModel& model, const System& system, const Eigen::MatrixXd& directions,
                  std::vector<int> slotAt, std::vector<int> readingAt);

    int count() const { return K_; }
    const std::vector<double>& state() const { return S_; }
    std::vector<double>& state() { return S_; }
    const std::vector<double>& slots() const { return slots_; }
    double direction(int parameter, int k) const { return directions_[static_cast<std::size_t>(parameter * K_ + k)]; }

    /// The parameters as they are now. Each returns false where something has no value.
    bool takeParameters(const std::vector<double>& parameters);
    /// The state at the start, and the slots that follow from it.
    bool start(const EventPoint& point, bool isFoundAtStart);
    bool rates(double t, std::span<const double> x, const double* dx, std::span<const double> u, std::span<double> xdot,
               double* dxdot);
    bool outputs(const EventPoint& point, std::span<double> y, double* dy);

    // An event, in order.
    bool begin(const EventPoint& point, const EventMoment& moment);
    void takeLeftLimits();                  // pre(x) of an x that runs
    bool settled(const EventPoint& point);  // slots and readings are at rest
    void reset(int state, int step);        // reinit
    void shift();                           // pre(z) := z
    bool end(const EventPoint& point);

    /// Of a step of the program, by what it was last run with.
    std::vector<double> ofStep(int step) const;

private:
    bool readings(const EventPoint& point, const std::vector<double>& dx, const std::vector<double>& dt,
                  std::vector<double>& result);
    std::vector<double> block(int rows) const { return std::vector<double>(static_cast<std::size_t>(rows * K_)); }

    const HybridModel& model_;
    const System& system_;
    int K_, n_;
    std::vector<double> directions_;  // parameters x K; those of slots change
    std::vector<int> slotAt_, readingAt_;
    Workspace workspace_;
    std::vector<double> S_, slots_, readings_, steps_, dt_, y_, dy_, f_, df_;
};

}  // namespace analogon
