#include "core/effect/preview.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/effect/model_state.hpp"
#include "core/library/library.hpp"

namespace analogon {
namespace {

/// A body that is heated and cools to 300 K; its sensor reads 4 K too much.
EstimationTask warmBody() {
    EstimationTask task;
    task.model = std::make_shared<Source>("model.mo", R"(model Body
  Analogon.Interfaces.RealInput P(unit="W");
  Analogon.Interfaces.RealOutput T(unit="K");
  Analogon.Sources.PrescribedHeatFlow heater;
  Analogon.Thermal.HeatCapacitor body(C=4, T_start=300);
  Analogon.Thermal.ThermalConductor joint(G=0.2);
  Analogon.Sources.FixedTemperature surroundings(T=300);
  Analogon.Sensors.TemperatureSensor sensor;
equation
  connect(P, heater.Q_flow);
  connect(heater.port, body.port);
  connect(body.port, joint.port_a);
  connect(joint.port_b, surroundings.port);
  connect(body.port, sensor.port);
  connect(sensor.T, T);
end Body;
)");
    task.className = "Body";
    Outcome<Library> library = builtInLibrary()->withSource(task.model);
    EXPECT_TRUE(library) << format(library.diagnostics());
    if (library) task.library = std::move(*library);
    FitParameter g;
    g.name = "joint.G";
    g.start = 0.3;
    g.min = 0.01;
    g.max = 10;
    task.parameters = {g};
    Recording r;
    r.name = "warm-up";
    r.inputNames = {"P"};
    r.outputNames = {"T"};
    constexpr int samples = 400;
    r.inputs = Eigen::MatrixXd::Constant(1, samples, 8);
    r.outputs.resize(1, samples);
    r.weights = Eigen::VectorXd::Ones(1);
    for (int k = 0; k < samples; ++k) {
        const double t = 0.25 * k, noise = 0.02 * std::sin(12.9898 * k) * std::cos(78.233 * k);
        r.time.push_back(t);
        r.outputs(0, k) = 304 + 40 * (1 - std::exp(-t / 20)) + noise;
    }
    task.recordings = {r};
    return task;
}

TEST(Preview, ShowsTheModelWithOneEffect) {
    const EstimationTask task = warmBody();
    const DiscoverOptions options;
    const Outcome<ModelState> without = fitModel(task, options.fit);
    ASSERT_TRUE(without) << format(without.diagnostics());
    const Outcome<ModelState> with = stateWith(task, {"Analogon.Effects.Sensor.Offset", "output T"}, options);
    ASSERT_TRUE(with) << format(with.diagnostics());
    EXPECT_GT(errorPercentOf(*without, Role::Fit), 1);
    EXPECT_LT(errorPercentOf(*with, Role::Fit), 0.05);
    ASSERT_EQ(with->experiments.size(), 1u);
    EXPECT_EQ(with->experiments[0].time.size(), 400u);
}

TEST(Preview, RefusesAPlaceThatIsNotThere) {
    const Outcome<ModelState> with = stateWith(warmBody(), {"Analogon.Effects.Sensor.Offset", "output v"}, {});
    ASSERT_FALSE(with);
    EXPECT_THAT(format(with.diagnostics()), testing::HasSubstr("no such place"));
}

TEST(Preview, StopsWhenItIsAskedTo) {
    std::stop_source stop;
    stop.request_stop();
    const Progress progress(stop.get_token(), [](const Progress::Report&) {});
    (void)stateWith(warmBody(), {"Analogon.Effects.Sensor.Offset", "output T"}, {}, progress);  // and does not crash
}

}  // namespace
}  // namespace analogon
