#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>

#include "core/eval/event_parts.hpp"
#include "core/flat/flat_model.hpp"
#include "core/simulate/event_run.hpp"

namespace analogon {
namespace {

struct Example {
    const char* name;
    double stop;  // [s]
};

std::string nameOf(const ::testing::TestParamInfo<Example>& info) {
    const std::string name = info.param.name;
    return name.substr(name.rfind('.') + 1);
}

/// Classes of the Modelica Standard Library, each for a kind of model; without the library they are skipped.
class StandardLibraryExample : public ::testing::TestWithParam<Example> {};

TEST_P(StandardLibraryExample, Runs) {
    const char* const path = std::getenv("MODELICAPATH");
    if (!path || !*path) GTEST_SKIP() << "MODELICAPATH names no directory with the Modelica Standard Library";
    const Outcome<Library> library = Library().withPath(path);
    ASSERT_TRUE(library) << format(library.diagnostics());
    const Outcome<FlatModel> flat = flatten(*library, GetParam().name);
    ASSERT_TRUE(flat) << format(flat.diagnostics());
    const Outcome<HybridModel> hybrid = partition(*flat);
    ASSERT_TRUE(hybrid) << format(hybrid.diagnostics());
    const Outcome<SystemPtr> system = systemBetween(*hybrid);
    ASSERT_TRUE(system) << format(system.diagnostics());
    EventRunOptions options;
    options.stop = GetParam().stop;
    const Outcome<EventTrajectory> run = simulateWithEvents(*hybrid, **system, {}, options);
    EXPECT_TRUE(run) << format(run.diagnostics());
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, StandardLibraryExample,
    ::testing::Values(Example{"Modelica.Electrical.Analog.Examples.HeatingPNP_NORGate", 1},
                      Example{"Modelica.Electrical.PowerConverters.Examples.DCDC.HBridge.HBridge_R", 0.01},
                      Example{"Modelica.StateGraph.Examples.ShowCompositeStep", 10},
                      Example{"Modelica.StateGraph.Examples.ShowExceptions", 10},
                      Example{"Modelica.Electrical.Digital.Examples.Counter", 10},
                      Example{"Modelica.Electrical.PowerConverters.Examples.DCAC.PolyphaseTwoLevel."
                              "ThreePhaseTwoLevel_PWM",
                              0.005}),
    nameOf);

}  // namespace
}  // namespace analogon
