#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/fit/problem.hpp"
#include "tests/bench/speed/hand_written.hpp"

namespace analogon::speed {

/// A benchmark problem: a model as Modelica text, recorded inputs, noisy measurements, start values.
struct SpeedProblem {
    std::string name;
    std::string text, className;
    SampledInputs inputs;
    Eigen::MatrixXd measured;  // rows: outputs
    Eigen::VectorXd sigma;     // noise of each output
    std::vector<FitParameter> parameters;
    std::vector<FitParameter> known;  // held at their starts
    std::vector<double> truth;        // of all parameters of the model, those fitted first

    Record record() const {
        return {static_cast<int>(inputs.time.size()), inputs.time.data(), inputs.values.data(), measured.data(),
                sigma.data()};
    }
};

/// A heated wire in a stream: one state, four parameters, supply voltage and ambient temperature at 100 Hz.
SpeedProblem lambdaHeater(int samples, bool hasNoisyInput);
/// A motor on an elastic shaft: five states, eight parameters, voltage at 1 kHz.
SpeedProblem motor(int samples, bool hasNoisyInput, std::uint64_t seed = 20260102);
/// The motor on a chain of so many masses, of which the first `fitted` parameters are fitted (0: all 3 masses + 2).
SpeedProblem chain(int samples, int masses, int fitted = 0);

/// The problem as a fit sees it, from its text.
FitProblem fitProblem(const SpeedProblem& problem);
/// One fit of several recordings of the same model.
FitProblem fitProblem(const std::vector<SpeedProblem>& recordings);

}  // namespace analogon::speed
