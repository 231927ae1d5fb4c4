#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

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

/// A class of the library in that directory, or of a text beside it, to its trajectory.
Outcome<EventTrajectory> simulated(const char* directory, const char* name, const std::vector<std::string>& variables,
                                   const EventRunOptions& options, const char* text = nullptr) {
    Outcome<Library> library = Library().withPath(directory);
    if (library && text) library = library->withSource(std::make_shared<const Source>("m.mo", text));
    if (!library) return library.diagnostics();
    const Outcome<FlatModel> flat = flatten(*library, name);
    if (!flat) return flat.diagnostics();
    const Outcome<HybridModel> hybrid = partition(*flat);
    if (!hybrid) return hybrid.diagnostics();
    const Outcome<SystemPtr> system = systemBetween(*hybrid);
    if (!system) return system.diagnostics();
    return simulateWithEvents(*hybrid, **system, variables, options);
}

/// Classes of the Modelica Standard Library, each for a kind of model; without the library they are skipped.
class StandardLibraryExample : public ::testing::TestWithParam<Example> {};

TEST_P(StandardLibraryExample, Runs) {
    const char* const path = std::getenv("MODELICAPATH");
    if (!path || !*path) GTEST_SKIP() << "MODELICAPATH names no directory with the Modelica Standard Library";
    EventRunOptions options;
    options.stop = GetParam().stop;
    const Outcome<EventTrajectory> run = simulated(path, GetParam().name, {}, options);
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

/// The coefficients of a filter are parameters that its initial equations work out, by functions of each other.
/// A Butterworth band pass of order n lets 1/sqrt(1 + ((f^2 - f0^2)/(f B))^(2n)) through, f0^2 = f1 f2, B = f2 - f1.
TEST(StandardLibrary, ABandPassLetsThroughWhatItsFormulaSays) {
    const char* const path = std::getenv("MODELICAPATH");
    if (!path || !*path) GTEST_SKIP() << "MODELICAPATH names no directory with the Modelica Standard Library";
    EventRunOptions options;
    options.stop = 1;
    options.interval = 1e-5;
    const Outcome<EventTrajectory> run = simulated(path, "M", {"filter.y"}, options, R"(
        model M
          Modelica.Blocks.Continuous.Filter filter(
            analogFilter = Modelica.Blocks.Types.AnalogFilter.Butterworth, order = 3, f_min = 20, f_cut = 50,
            filterType = Modelica.Blocks.Types.FilterType.BandPass,
            init = Modelica.Blocks.Types.Init.InitialState);
        equation
          filter.u = sin(2*Modelica.Constants.pi*55*time);
        end M;)");
    ASSERT_TRUE(run) << format(run.diagnostics());
    double most = 0;
    for (std::size_t k = 0; k < run->time.size(); ++k)
        if (run->time[k] > 0.9) most = std::max(most, run->rows[k][0]);
    EXPECT_NEAR(most, 1 / std::sqrt(1 + std::pow((55.0 * 55 - 1000) / (55 * 30), 6)), 1e-4);
}

/// A permanent-magnet machine that brakes through a diode bridge, with what an integration of equations written by hand
/// gives: space phasors with Ls = 0.1/w0, Lm = 0.3/w0, the bridge as six resistors of two slopes, an implicit
/// Runge-Kutta method of order 2 with steps of 50 ns (with 200 ns the angle differs by 5e-6 rad, the current by 1e-3
/// A).
TEST(StandardLibrary, AMachineThatBrakesThroughABridgeMovesAsByHand) {
    const char* const path = std::getenv("MODELICAPATH");
    if (!path || !*path) GTEST_SKIP() << "MODELICAPATH names no directory with the Modelica Standard Library";
    EventRunOptions options;
    options.stop = 0.8;
    options.interval = 5e-5;
    const Outcome<EventTrajectory> run =
        simulated(path, "Modelica.Electrical.Machines.Examples.SynchronousMachines.SMPM_Braking",
                  {"inertiaLoad.phi", "inertiaLoad.w", "smpm.idq_sr[1]", "smpm.idq_sr[2]"}, options);
    ASSERT_TRUE(run) << format(run.diagnostics());
    struct Point {
        double time;                   // [s]
        double phi, w, direct, cross;  // [rad], [rad/s], [A], [A]
    };
    constexpr Point byHand[] = {{0.30105, 30.768667, 47.535842, -101.60862, -135.36551},
                                {0.45095, 34.151053, 3.0738215, -11.66879, -48.89653},
                                {0.60155, 34.201671, -0.01209632, 0.07848205, 0.22508537},
                                {0.8, 34.201518, -3.3677e-6, -1.5651e-5, -4.49292e-5}};
    for (const Point& point : byHand) {
        SCOPED_TRACE(point.time);
        std::size_t k = 0;
        while (k + 1 < run->time.size() && run->time[k] < point.time - 1e-9) ++k;
        ASSERT_NEAR(run->time[k], point.time, 1e-9);
        EXPECT_NEAR(run->rows[k][0], point.phi, 5e-5);
        EXPECT_NEAR(run->rows[k][1], point.w, 5e-4);
        EXPECT_NEAR(run->rows[k][2], point.direct, 0.02);
        EXPECT_NEAR(run->rows[k][3], point.cross, 0.02);
    }
}

}  // namespace
}  // namespace analogon
