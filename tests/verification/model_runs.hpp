#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <map>

#include "core/eval/system.hpp"
#include "core/simulate/simulate.hpp"

namespace analogon::test {

/// A file of tests/models on top of the block library.
inline Library modelLibrary(const std::string& file) {
    Outcome<Library> library = builtInLibrary();
    EXPECT_TRUE(library) << format(library.diagnostics());
    std::ifstream stream(std::string(ANALOGON_ROOT) + "/tests/models/" + file, std::ios::binary);
    EXPECT_TRUE(stream) << file;
    std::string text((std::istreambuf_iterator<char>(stream)), {});
    library = library->withSource(std::make_shared<const Source>(file, std::move(text)));
    EXPECT_TRUE(library) << format(library.diagnostics());
    return library ? *library : Library();
}

inline SystemPtr compiled(const Library& library, const std::string& className) {
    const Outcome<SystemPtr> system = compile(library, className);
    EXPECT_TRUE(system) << format(system.diagnostics());
    return system ? *system : nullptr;
}

/// A run of a model without inputs in the adaptive engine, recorded at the given times.
inline Trajectory run(const System& system, const std::vector<double>& times, SimulationOptions options = {},
                      const std::vector<std::string>& observe = {}) {
    SampledInputs inputs;
    inputs.time = times;
    inputs.values.resize(0, static_cast<Eigen::Index>(times.size()));
    SimulationTask task;
    task.system = &system;
    task.inputs = &inputs;
    task.observe = observe;
    options.engine = Engine::Adaptive;
    return simulate(task, options);
}

inline std::vector<double> evenly(double from, double to, int count) {
    std::vector<double> times;
    for (int i = 0; i < count; ++i) times.push_back(from + (to - from) * i / (count - 1));
    return times;
}

}  // namespace analogon::test
