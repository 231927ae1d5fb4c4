#pragma once

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
    std::vector<double> truth;

    Record record() const {
        return {static_cast<int>(inputs.time.size()), inputs.time.data(), inputs.values.data(), measured.data(),
                sigma.data()};
    }
};

/// A heated wire in a stream: one state, four parameters, supply voltage and ambient temperature at 100 Hz.
SpeedProblem lambdaHeater(int samples, bool hasNoisyInput);
/// A motor on an elastic shaft: five states, eight parameters, voltage at 1 kHz.
SpeedProblem motor(int samples, bool hasNoisyInput);

/// The problem as a fit sees it, from its text.
FitProblem fitProblem(const SpeedProblem& problem);

}  // namespace analogon::speed
