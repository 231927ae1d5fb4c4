/// A state that an initial equation lets begin in balance begins elsewhere in a recording that starts in mid run.
#include <gtest/gtest.h>

#include <random>

#include "core/fit/fit.hpp"
#include "tests/core/effect/text_task.hpp"

namespace analogon {
namespace {

constexpr const char* bodyText = R"(model Body
  Analogon.Interfaces.RealInput P(unit="W");
  Analogon.Interfaces.RealOutput T(unit="K");
  Analogon.Sources.PrescribedHeatFlow heater;
  Analogon.Thermal.HeatCapacitor body(C=4, T_start=300);
  Analogon.Thermal.ThermalConductor loss(G=0.1);
  Analogon.Sources.FixedTemperature room(T=300);
  Analogon.Sensors.TemperatureSensor sensor;
  Analogon.Effects.Thermal.Mass mass(C2=5, tau_2=16);
equation
  connect(P, heater.Q_flow);
  connect(heater.port, body.port);
  connect(body.port, loss.port_a);
  connect(loss.port_b, room.port);
  connect(body.port, sensor.port);
  connect(body.port, mass.port);
  connect(sensor.T, T);
end Body;
)";

/// The body at T, the mass behind it at T2, integrated in small steps; noise of 0.02 K.
Recording recorded(const std::string& name, double T, double T2, unsigned seed) {
    constexpr int samples = 400, within = 50;
    constexpr double step = 0.5, dt = step / within;
    Recording r = blankRecording(name, {"P"}, {"T"}, samples);
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    const auto power = [](int k) { return (k / 80) % 2 == 0 ? 6.0 : 1.0; };
    for (int k = 0; k < samples; ++k) {
        r.time.push_back(step * k);
        r.inputs(0, k) = power(k);
        r.outputs(0, k) = T + 0.02 * normal(random);
        for (int i = 0; i < within; ++i) {
            const double part = (i + 0.5) / within, P = (1 - part) * power(k) + part * power(k + 1);
            const double behind = 5.0 / 16 * (T - T2);
            T += dt / 4 * (P - 0.1 * (T - 300) - behind);
            T2 += dt / 5 * behind;
        }
    }
    return r;
}

TEST(HiddenStart, IsFittedInTheRecordingsThatSaySoAndInBalanceInTheOthers) {
    EstimationTask task = taskOf(bodyText, "Body");
    task.parameters.push_back({"body.C", "J/K", 3, 0.1, 100});
    task.parameters.push_back({"loss.G", "W/K", 0.2, 0.001, 10});
    task.recordings = {recorded("cold", 300, 300, 1), recorded("mid run", 320, 310, 2)};
    task.recordings.edit()[1].starts = {{"body.T_start", 319, true}, {"mass.T2.start", 293.15, true}};
    const Outcome<PreparedTask> prepared = prepare(task);
    ASSERT_TRUE(prepared) << format(prepared.diagnostics());
    const FitResult result = fit(prepared->problem, {}, Progress());
    const FitEstimate* const hidden = result.find("mass.T2.start", 1);
    ASSERT_NE(hidden, nullptr);
    EXPECT_NEAR(hidden->value, 310, 4 * hidden->standardError);
    EXPECT_LT(hidden->standardError, 0.2);
    const FitEstimate* const capacity = result.find("body.C");
    ASSERT_NE(capacity, nullptr);
    EXPECT_NEAR(capacity->value, 4, 4 * capacity->standardError) << "as if both had begun as they were told to";
    EXPECT_LT(capacity->standardError, 0.02);
}

}  // namespace
}  // namespace analogon
