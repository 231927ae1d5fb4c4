#pragma once

#include <vector>

#include "core/simulate/input_slots.hpp"

namespace analogon {

/// A held input that is delayed by T jumps at t_k + T. Where T depends on the parameters the jump moves with them, and
/// the tangents of the state jump there: dx+ = dx- + (f- - f+) dT, with the rates f before and after it (Hiskens & Pai,
/// IEEE Trans. Circuits Syst. I 47 (2000) 204-220).
class MovingJumps {
public:
    MovingJumps(Dynamics& dynamics, InputSlots& slots);

    /// Whether there are any.
    bool any() const { return !delays_.empty(); }
    /// The piece that the integration begins with holds this time.
    void begin(double within);
    /// From one piece into the next, which begins at t and holds `within`; u (the slots) as they are there. False: the
    /// rates cannot be evaluated.
    bool pass(double t, double within, const double* u, const double* x, double* dx);

private:
    Dynamics& dynamics_;
    InputSlots& slots_;
    std::vector<int> delays_;     // that move
    std::vector<double> values_;  // of each, in the piece under way
    std::vector<double> u_, before_, after_;
};

}  // namespace analogon
