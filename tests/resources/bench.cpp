#include "tests/resources/bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/simulate/simulate.hpp"

namespace analogon::bench {

Signal constant(double value) {
    return [value](double) { return value; };
}

const std::vector<double>& Recording::operator[](const std::string& output) const {
    static const std::vector<double> nothing(1, std::numeric_limits<double>::quiet_NaN());
    const auto at = std::find(names.begin(), names.end(), output);
    return at == names.end() ? nothing : values[static_cast<std::size_t>(at - names.begin())];
}

Outcome<Library> libraryWith(const std::string& text) {
    Outcome<Library> library = builtInLibrary();
    if (!library) return library;
    return library->withSource(std::make_shared<Source>("bench.mo", text));
}

Recording run(const std::string& body, double duration, int samples, const std::vector<Signal>& inputs) {
    Recording recording;
    const Outcome<Library> library = libraryWith("model M\n" + body + "\nend M;\n");
    if (!library) {
        recording.fault = format(library.diagnostics());
        return recording;
    }
    const Outcome<SystemPtr> system = compile(*library, "M");
    if (!system) {
        recording.fault = format(system.diagnostics());
        return recording;
    }
    SampledInputs sampled;
    sampled.values.resize(static_cast<Eigen::Index>(inputs.size()), samples);
    for (int k = 0; k < samples; ++k) {
        sampled.time.push_back(duration * k / (samples - 1));
        for (std::size_t i = 0; i < inputs.size(); ++i)
            sampled.values(static_cast<Eigen::Index>(i), k) = inputs[i](sampled.time.back());
    }
    SimulationTask task;
    task.system = system->get();
    task.inputs = &sampled;
    for (const SignalInfo& p : (*system)->parameters()) task.parameters.push_back(p.value);
    SimulationOptions options;
    options.engine = Engine::Adaptive;
    options.relativeTolerance = 1e-9;
    options.absoluteTolerance = 1e-12;
    const Trajectory trajectory = simulate(task, options);
    if (trajectory.failure.failed)
        recording.fault = fmt::format("{} at {} s ({})", trajectory.failure.reason, trajectory.failure.time,
                                      trajectory.failure.variable);
    recording.time = sampled.time;
    for (int i = 0; i < (*system)->outputCount(); ++i) {
        recording.names.push_back((*system)->outputs()[static_cast<std::size_t>(i)].name);
        recording.values.emplace_back();
        for (int k = 0; k < samples; ++k) recording.values.back().push_back(trajectory.outputs(i, k));
    }
    return recording;
}

double worst(const Recording& recording, const std::string& output, const Signal& expected) {
    if (!recording.fault.empty()) return std::numeric_limits<double>::infinity();
    double difference = 0;
    const std::vector<double>& values = recording[output];
    for (std::size_t k = 0; k < values.size(); ++k) {
        const double d = std::abs(values[k] - expected(recording.time[k]));
        difference = std::isfinite(d) ? std::max(difference, d) : std::numeric_limits<double>::infinity();
    }
    return difference;
}

}  // namespace analogon::bench
