#include "tests/bench/speed/growing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "core/library/library.hpp"
#include "tests/bench/speed/random.hpp"

namespace analogon::speed {
namespace {

[[noreturn]] void refuse(const Diagnostics& faults) {
    std::fputs(format(faults).c_str(), stderr);
    std::exit(2);
}

SystemPtr systemOf(const std::string& text, const char* className, const std::vector<std::string>& kept) {
    const Outcome<Library> standard = Library().withPath(ANALOGON_ROOT "/resources/Analogon");
    if (!standard) refuse(standard.diagnostics());
    const Outcome<Library> library = standard->withSource(std::make_shared<const Source>("model.mo", text));
    if (!library) refuse(library.diagnostics());
    Outcome<SystemPtr> system = compile(*library, className, {kept});
    if (!system) refuse(system.diagnostics());
    return *system;
}

struct Range {
    double lowest{}, highest{};
};

/// An input for each range, with steps between held levels.
SampledInputs levels(const std::vector<Range>& ranges, int samples, double step, int shortest, std::uint64_t seed) {
    Random random(seed);
    SampledInputs inputs;
    inputs.values.resize(static_cast<Eigen::Index>(ranges.size()), samples);
    for (int k = 0; k < samples; ++k) inputs.time.push_back(k * step);
    for (std::size_t i = 0; i < ranges.size(); ++i) {
        const Range& range = ranges[i];
        for (int begin = 0; begin < samples;) {
            const int length = std::min(samples - begin, shortest + static_cast<int>(4 * shortest * random.uniform()));
            const double level = range.lowest + (range.highest - range.lowest) * random.uniform();
            inputs.values.row(static_cast<Eigen::Index>(i)).segment(begin, length).setConstant(level);
            begin += length;
        }
    }
    return inputs;
}

/// What the model makes of its own values, with noise.
void addExperiment(FitProblem& problem, const SystemPtr& system, SampledInputs inputs, double noise,
                   std::uint64_t seed) {
    FitExperiment experiment;
    experiment.name = fmt::format("recording {}", problem.experiments.size() + 1);
    experiment.system = system;
    experiment.inputs = std::move(inputs);
    for (const SignalInfo& p : system->parameters()) experiment.parameters.push_back(p.value);
    const Trajectory truth = simulate(taskOf(experiment));
    if (truth.failure.failed) {
        std::fputs("the model cannot be simulated\n", stderr);
        std::exit(3);
    }
    Random random(seed);
    experiment.measured = truth.outputs;
    experiment.weights.resize(truth.outputs.rows());
    const Eigen::VectorXd ranges = truth.outputs.rowwise().maxCoeff() - truth.outputs.rowwise().minCoeff();
    for (Eigen::Index o = 0; o < truth.outputs.rows(); ++o) {
        const double sigma = noise * ranges[o];
        experiment.weights[o] = 1 / sigma;
        for (Eigen::Index k = 0; k < truth.outputs.cols(); ++k) experiment.measured(o, k) += sigma * random.normal();
    }
    problem.experiments.push_back(std::move(experiment));
}

/// A fit begins at these factors of the values, in turn.
void fitFrom(FitProblem& problem, const System& system, double factor) {
    for (const SignalInfo& info : system.parameters()) {
        FitParameter parameter;
        parameter.name = info.name;
        parameter.start = info.value * factor;
        parameter.min = info.value / 20;
        parameter.max = info.value * 20;
        problem.parameters.push_back(std::move(parameter));
        factor = 1 / factor;
    }
}

/// Where the heat still comes through, however long the chain is.
int secondOf(int masses) { return std::clamp(masses / 2, 2, 5); }

std::string chainText(int masses, bool isRod) {
    std::string text =
        "model Chain\n  Analogon.Interfaces.RealInput q;\n  Analogon.Interfaces.RealInput T_amb;\n"
        "  Analogon.Sources.PrescribedHeatFlow source;\n  Analogon.Sources.PrescribedTemperature ambient;\n";
    std::string wires =
        "equation\n  connect(q, source.Q_flow);\n  connect(T_amb, ambient.T);\n  connect(source.port, m1.port);\n";
    const double C = isRod ? 200.0 / masses : 10.0, G = isRod ? 0.2 * masses : 2.0;
    for (int i = 1; i <= masses; ++i) {
        text += fmt::format("  Analogon.Thermal.HeatCapacitor m{}(C={:.6g});\n", i, C * (1 + 0.1 * (i * 7 % 5)));
        text += fmt::format("  Analogon.Thermal.ThermalConductor g{}(G={:.6g});\n", i, G * (1 + 0.1 * (i * 3 % 4)));
        const std::string next = i < masses ? fmt::format("m{}.port", i + 1) : "ambient.port";
        wires += fmt::format("  connect(m{0}.port, g{0}.port_a);\n  connect(g{0}.port_b, {1});\n", i, next);
    }
    const int places[] = {1, secondOf(masses), masses};
    for (int o = 1; o <= 3; ++o) {
        text += fmt::format("  Analogon.Interfaces.RealOutput T{0};\n  Analogon.Sensors.TemperatureSensor s{0};\n", o);
        wires += fmt::format("  connect(m{0}.port, s{1}.port);\n  connect(s{1}.T, T{1});\n", places[o - 1], o);
    }
    return text + wires + "end Chain;\n";
}

std::string netText(int side) {
    std::string text =
        "model Net\n  Analogon.Interfaces.RealInput q;\n  Analogon.Interfaces.RealOutput T;\n"
        "  Analogon.Sources.PrescribedHeatFlow source;\n  Analogon.Sources.FixedTemperature ambient(T=293);\n"
        "  Analogon.Thermal.HeatCapacitor m1(C=50);\n  Analogon.Thermal.HeatCapacitor m2(C=20);\n"
        "  Analogon.Sensors.TemperatureSensor sensor;\n";
    std::string wires = "equation\n  connect(q, source.Q_flow);\n  connect(sensor.T, T);\n";
    std::vector<std::string> portOf(static_cast<std::size_t>(side * side));  // of each node the first
    const auto join = [&](int i, int j, const std::string& port) {
        std::string& first = portOf[static_cast<std::size_t>(i * side + j)];
        if (first.empty())
            first = port;
        else
            wires += fmt::format("  connect({}, {});\n", first, port);
    };
    int count = 0;
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j)
            for (const auto& [a, b] : {std::pair(i, j + 1), std::pair(i + 1, j)}) {
                if (a == side || b == side) continue;
                ++count;
                const double G = 2 * (1 + 0.1 * (count * 3 % 7));
                text += fmt::format("  Analogon.Thermal.ThermalConductor g{}(G={:.6g});\n", count, G);
                join(i, j, fmt::format("g{}.port_a", count));
                join(a, b, fmt::format("g{}.port_b", count));
            }
    join(0, 0, "source.port");
    join(side - 1, side - 1, "ambient.port");
    join(side / 2, side / 2, "m1.port");
    join(side / 2, side / 2, "sensor.port");
    join(side - 1, 0, "m2.port");
    return text + wires + "end Net;\n";
}

const char* const pumpText = R"(
model Load
  extends Analogon.Interfaces.PartialOneFlange;
  parameter Real k_q(min=0) = 2e-6;
  parameter Real friction = 0;
equation
  flange.tau = k_q*w*noEvent(abs(w)) + friction*tanh(w/0.5);
end Load;
model Pump
  Analogon.Interfaces.RealInput v;
  Analogon.Interfaces.RealOutput i;
  Analogon.Interfaces.RealOutput w;
  Analogon.ElectricMechanical.BasicElectricMechanical motor(R=0.5, L=3.5e-4, k=0.025);
  Analogon.Mechanics.Inertia rotor(J=5e-5);
  Analogon.Mechanics.SpringDamper shaft(c=2, d=2e-3);
  Load load(FRICTION);
  Analogon.Sensors.SpeedSensor speed;
equation
  connect(v, motor.v);
  connect(motor.flange, rotor.flange_a);
  connect(rotor.flange_b, shaft.flange_a);
  connect(shaft.flange_b, load.flange);
  connect(load.flange, speed.flange);
  connect(motor.i, i);
  connect(speed.w, w);
end Pump;
)";

SystemPtr pumpSystem(bool sticks) {
    std::string text = pumpText;
    const std::string place = "FRICTION";
    text.replace(text.find(place), place.size(), sticks ? "friction=1e-4" : "");
    return systemOf(text, "Pump", {"motor.R", "motor.k", "rotor.J", "load.k_q"});
}

}  // namespace

FitProblem thermalChain(int masses, bool isRod, int samples, int fitted) {
    std::vector<std::string> kept{"m1.C", "g1.G", fmt::format("m{}.C", secondOf(masses)), fmt::format("g{}.G", masses)};
    kept.resize(static_cast<std::size_t>(std::min(fitted, 4)));
    const SystemPtr system = systemOf(chainText(masses, isRod), "Chain", kept);
    FitProblem problem;
    addExperiment(problem, system, levels({{0, 100}, {283, 303}}, samples, 0.5, 50, 5), 1e-3, 6);
    fitFrom(problem, *system, 1.3);
    return problem;
}

FitProblem thermalNet(int side, int samples, int fitted) {
    std::vector<std::string> kept{"m1.C", "g1.G", "m2.C", "g4.G"};
    kept.resize(static_cast<std::size_t>(std::min(fitted, 4)));
    const SystemPtr system = systemOf(netText(side), "Net", kept);
    FitProblem problem;
    addExperiment(problem, system, levels({{0, 100}}, samples, 0.5, 50, 8), 1e-3, 9);
    fitFrom(problem, *system, 1.3);
    return problem;
}

FitProblem pump(int samples, bool sticks) {
    const SystemPtr system = pumpSystem(sticks);
    FitProblem problem;
    addExperiment(problem, system, levels({{2, 12}}, samples, 1e-3, 100, 3), 3e-3, 4);
    fitFrom(problem, *system, 1.2);
    return problem;
}

FitProblem pumpRecordings(int recordings, int samples) {
    const SystemPtr system = pumpSystem(false);
    FitProblem problem;
    for (int e = 0; e < recordings; ++e) {
        const auto seed = static_cast<std::uint64_t>(e);
        addExperiment(problem, system, levels({{2, 12}}, samples, 1e-3, 100, 3 + 7 * seed), 3e-3, 4 + 7 * seed);
    }
    fitFrom(problem, *system, 1.2);
    return problem;
}

}  // namespace analogon::speed
