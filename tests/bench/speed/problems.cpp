#include "tests/bench/speed/problems.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "tests/bench/speed/random.hpp"

namespace analogon::speed {
namespace {

const char* const heaterText = R"(
model LambdaHeater
  input Real v(unit = "V");
  input Real T_amb(unit = "K");
  output Real i(unit = "A");
  parameter Real R0 = 3.2;
  parameter Real a = 2e-3;
  parameter Real C = 1.5;
  parameter Real c_o = 1;
  parameter Real A = 1e-3;
  Real T(unit = "K");
  Real R;
  Real P;
initial equation
  T = T_amb;
equation
  R = R0*(1 + a*(T - 293.15));
  i = v/R;
  P = R*i^2;
  C*der(T) = P - c_o*A*(T_amb/3.6)^0.78*(T - T_amb);
end LambdaHeater;
)";

const char* const motorText = R"(
model Motor
  input Real v(unit = "V");
  output Real i(unit = "A");
  output Real w2(unit = "rad/s");
  parameter Real R = 1.2;
  parameter Real L = 2e-3;
  parameter Real k = 0.05;
  parameter Real b = 0.01;
  parameter Real J1 = 2e-3;
  parameter Real J2 = 5e-3;
  parameter Real c = 20;
  parameter Real d = 0.02;
  parameter Real r = 5;
  Real w1(start = 0, fixed = true);
  Real phi1(start = 0, fixed = true);
  Real phi2(start = 0, fixed = true);
  Real tau;
initial equation
  i = 0;
  w2 = 0;
equation
  v = R*i + L*der(i) + k*r*w1;
  tau = c*(phi1 - phi2) + d*(w1 - w2);
  J1*der(w1) = r*k*i - tau;
  der(phi1) = w1;
  J2*der(w2) = tau - b*w2;
  der(phi2) = w2;
end Motor;
)";

/// States of the chain as in the text of the motor; mass j + 1 hangs on mass j.
std::string chainText(int masses) {
    std::string text =
        "model Chain\n  input Real v;\n  output Real i;\n  output Real w_end;\n"
        "  parameter Real R = 1;\n  parameter Real L = 1;\n  parameter Real k = 1;\n  parameter Real b = 1;\n"
        "  parameter Real r = 5;\n";
    std::string equations = "  v = R*i + L*der(i) + k*r*w1;\n";
    std::string starts = "initial equation\n  i = 0;\n";
    for (int j = 1; j <= masses; ++j) {
        text += fmt::format("  parameter Real J{0} = 1;\n  Real w{0};\n", j);
        starts += fmt::format("  w{} = 0;\n", j);
        const std::string left = j == 1 ? "r*k*i" : fmt::format("tau{}", j - 1);
        const std::string right = j == masses ? fmt::format("b*w{}", j) : fmt::format("tau{}", j);
        equations += fmt::format("  J{0}*der(w{0}) = {1} - {2};\n", j, left, right);
        text += fmt::format("  Real phi{}(start = 0, fixed = true);\n", j);
        equations += fmt::format("  der(phi{0}) = w{0};\n", j);
        if (j == masses) break;
        text += fmt::format("  parameter Real c{0} = 1;\n  parameter Real d{0} = 1;\n  Real tau{0};\n", j);
        equations += fmt::format("  tau{0} = c{0}*(phi{0} - phi{1}) + d{0}*(w{0} - w{1});\n", j, j + 1);
    }
    equations += fmt::format("  w_end = w{};\n", masses);
    return text + starts + "equation\n" + equations + "end Chain;\n";
}

FitParameter parameter(const std::string& name, double start, double min, double max) {
    FitParameter p;
    p.name = name;
    p.start = start;
    p.min = min;
    p.max = max;
    return p;
}

void addNoise(SpeedProblem& problem, Random& random) {
    for (Eigen::Index o = 0; o < problem.measured.rows(); ++o)
        for (Eigen::Index k = 0; k < problem.measured.cols(); ++k)
            problem.measured(o, k) += problem.sigma[o] * random.normal();
}

}  // namespace

SpeedProblem lambdaHeater(int samples, bool hasNoisyInput) {
    SpeedProblem problem;
    problem.name = hasNoisyInput ? "P1n heater" : "P1 heater";
    problem.text = heaterText;
    problem.className = "LambdaHeater";
    problem.parameters = {parameter("R0", 5, 0.5, 20), parameter("a", 4e-3, 1e-4, 2e-2), parameter("C", 4, 0.1, 50),
                          parameter("c_o", 3, 0.05, 50)};
    problem.truth = {3.2, 2e-3, 1.5, 1.0};
    Random random(20260101);
    problem.inputs.values.resize(2, samples);
    for (int k = 0; k < samples; ++k) problem.inputs.time.push_back(k * 0.01);
    for (int k = 0; k < samples;) {
        const double level = random.uniform() < 0.15 ? 0 : 2 + 10 * random.uniform();
        for (int left = random.between(500, 1501); left > 0 && k < samples; --left, ++k)
            problem.inputs.values(0, k) = level;
    }
    int begin = 0;
    double from = 293.15;
    problem.inputs.values(1, 0) = from;
    while (begin < samples - 1) {
        const int length = random.between(1000, 3001);
        const double to = 293 + 607 * random.uniform();
        for (int j = 1; j <= length && begin + j < samples; ++j)
            problem.inputs.values(1, begin + j) = from + (to - from) * j / length;
        begin += length;
        from = to;
    }
    for (int input = 0; hasNoisyInput && input < 2; ++input)
        for (int k = 0; k < samples; ++k)
            problem.inputs.values(input, k) += (input == 0 ? 0.02 : 1.0) * random.normal();
    problem.measured =
        Eigen::Map<const Eigen::MatrixXd>(heaterOutputs(problem.record(), problem.truth.data(), 8).data(), 1, samples);
    problem.sigma = Eigen::VectorXd::Constant(1, 0.01 * std::sqrt(problem.measured.row(0).squaredNorm() / samples));
    addNoise(problem, random);
    return problem;
}

namespace {

/// Steps and ramps of the voltage at 1 kHz.
SampledInputs voltage(int samples, Random& random) {
    SampledInputs inputs;
    inputs.values.resize(1, samples);
    for (int k = 0; k < samples; ++k) inputs.time.push_back(k * 1e-3);
    double from = 0;
    for (int begin = 0; begin < samples;) {
        const int length = random.between(100, 501);
        const bool isStep = random.uniform() < 0.6;
        const double to = -24 + 48 * random.uniform();
        for (int j = 0; j < length && begin + j < samples; ++j)
            inputs.values(0, begin + j) = isStep ? to : from + (to - from) * j / length;
        begin += length;
        from = to;
    }
    inputs.values(0, 0) = 0;
    return inputs;
}

}  // namespace

SpeedProblem motor(int samples, bool hasNoisyInput, std::uint64_t seed) {
    SpeedProblem problem;
    problem.name = hasNoisyInput ? "P2n motor" : "P2 motor";
    problem.text = motorText;
    problem.className = "Motor";
    const char* const names[] = {"R", "L", "k", "b", "J1", "J2", "c", "d"};
    problem.truth = {1.2, 2e-3, 0.05, 0.01, 2e-3, 5e-3, 20, 0.02};
    const double factors[] = {1.4, 0.6, 1.35, 0.6, 0.65, 1.5, 0.7, 1.5};
    for (std::size_t i = 0; i < 8; ++i) {
        const double start = problem.truth[i] * factors[i];
        problem.parameters.push_back(parameter(names[i], start, start / 10, start * 10));
    }
    Random random(seed);
    problem.inputs = voltage(samples, random);
    for (int k = 0; hasNoisyInput && k < samples; ++k) problem.inputs.values(0, k) += 0.05 * random.normal();
    problem.measured =
        Eigen::Map<const Eigen::MatrixXd>(motorOutputs(problem.record(), problem.truth.data(), 8).data(), 2, samples);
    problem.sigma = 0.01 * problem.measured.cwiseAbs().rowwise().maxCoeff();
    addNoise(problem, random);
    return problem;
}

SpeedProblem chain(int samples, int masses, int fitted) {
    SpeedProblem problem;
    problem.text = chainText(masses);
    problem.className = "Chain";
    std::vector<std::string> names{"R", "L", "k", "b"};
    problem.truth = {1.2, 2e-3, 0.05, 0.01};
    for (int j = 1; j <= masses; ++j) {
        names.push_back(fmt::format("J{}", j));
        problem.truth.push_back(j == 1 ? 2e-3 : 5e-3);
    }
    for (int j = 1; j < masses; ++j) {
        names.push_back(fmt::format("c{}", j));
        problem.truth.push_back(20 * (1 + 0.1 * (j - 1)));
    }
    for (int j = 1; j < masses; ++j) {
        names.push_back(fmt::format("d{}", j));
        problem.truth.push_back(0.02);
    }
    const std::size_t count = fitted > 0 ? static_cast<std::size_t>(fitted) : names.size();
    for (std::size_t i = 0; i < names.size(); ++i) {
        const double truth = problem.truth[i];
        (i < count ? problem.parameters : problem.known).push_back(parameter(names[i], truth, truth / 10, truth * 10));
    }
    Random random(20260102);
    problem.inputs = voltage(samples, random);
    problem.measured = Eigen::Map<const Eigen::MatrixXd>(
        chainOutputs(problem.record(), problem.truth.data(), masses, 4).data(), 2, samples);
    problem.sigma = 0.01 * problem.measured.cwiseAbs().rowwise().maxCoeff();
    addNoise(problem, random);
    return problem;
}

namespace {

FitExperiment experimentOf(const SpeedProblem& problem, const SystemPtr& system) {
    FitExperiment experiment;
    experiment.name = problem.name;
    experiment.system = system;
    experiment.inputs = problem.inputs;
    experiment.measured = problem.measured;
    experiment.weights = problem.sigma.cwiseInverse();
    for (const SignalInfo& p : system->parameters()) experiment.parameters.push_back(p.value);
    for (const FitParameter& p : problem.known)
        experiment.parameters[static_cast<std::size_t>(system->parameterIndex(p.name))] = p.start;
    return experiment;
}

}  // namespace

FitProblem fitProblem(const SpeedProblem& problem) { return fitProblem(std::vector<SpeedProblem>{problem}); }

FitProblem fitProblem(const std::vector<SpeedProblem>& recordings) {
    const SpeedProblem& first = recordings.front();
    const auto source = std::make_shared<const Source>("model.mo", first.text);
    Outcome<Library> library = Library().withSource(source);
    std::vector<std::string> kept;
    for (const FitParameter& p : first.parameters) kept.push_back(p.name);
    for (const FitParameter& p : first.known) kept.push_back(p.name);
    Outcome<SystemPtr> system = library ? compile(*library, first.className, {kept}) : library.diagnostics();
    if (!system) {
        std::fputs(format(system.diagnostics()).c_str(), stderr);
        std::exit(1);
    }
    FitProblem result;
    for (const SpeedProblem& recording : recordings) result.experiments.push_back(experimentOf(recording, *system));
    result.parameters = first.parameters;
    return result;
}

}  // namespace analogon::speed
