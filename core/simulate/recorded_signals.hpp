#pragma once

#include <vector>

#include "core/simulate/sampled_inputs.hpp"

namespace analogon {

/// What recordings drive a model with events with. Between two stops (kinks of what runs in lines, jumps of what is
/// held) the signals run straight on, up to the next stop itself: what holds behind it is seen once it is passed.
class RecordedSignals {
public:
    /// `inputAt`: which input of the system each row of `inputs` is (-1: none); `slopeAt`: where its slope goes (-1:
    /// nobody asks).
    RecordedSignals(const SampledInputs& inputs, std::vector<int> inputAt, std::vector<int> slopeAt);

    const std::vector<double>& time() const { return inputs_.time; }
    void at(double t, double* u) const;
    /// How the inputs move now (du/dt), into their places.
    void slopes(double t, double* du) const;

    double nextStop() const;  // [s]; infinite: none
    bool isJumpNext() const;  // whether a held signal jumps there
    void passStop() { ++stop_; }

private:
    int intervalOf(double t) const;
    double slope(Eigen::Index row, int interval) const;

    const SampledInputs& inputs_;
    std::vector<int> inputAt_, slopeAt_;
    std::vector<int> stops_;  // samples
    std::vector<char> jumps_;
    std::size_t stop_{1};  // the next one
    mutable int interval_{};
};

}  // namespace analogon
