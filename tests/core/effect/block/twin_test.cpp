#include "core/effect/block/twin.hpp"

#include <gtest/gtest.h>

#include "core/library/library.hpp"
#include "tests/core/effect/text_task.hpp"

namespace analogon {
namespace {

const char* const board = R"(model Board
  Analogon.Interfaces.RealInput P(unit="W");
  Analogon.Interfaces.RealOutput T1(unit="K");
  Analogon.Interfaces.RealOutput T2(unit="K");
  Analogon.Interfaces.RealOutput Q(unit="W");
  Analogon.Sources.PrescribedHeatFlow heater;
  Analogon.Thermal.HeatCapacitor body(C=4);
  Analogon.Thermal.HeatCapacitor base(C=9);
  Analogon.Thermal.ThermalConductor joint(G=0.1);
  Analogon.Sensors.TemperatureSensor first;
  Analogon.Sensors.TemperatureSensor second;
  Analogon.Signals.Gain meter(k=1);
equation
  connect(P, heater.Q_flow);
  connect(P, meter.u);
  connect(heater.port, body.port);
  connect(body.port, joint.port_a);
  connect(joint.port_b, base.port);
  connect(body.port, first.port);
  connect(base.port, second.port);
  connect(first.T, T1);
  connect(second.T, T2);
  connect(meter.y, Q);
end Board;
)";

PlacedEffect lagAt(const std::vector<EffectClass>& catalogue, const std::string& output) {
    for (const EffectClass& e : catalogue)
        if (e.kind == "sensor.lag") return {e, {"output " + output, output, "", ""}, "lag", "", {}, {}};
    ADD_FAILURE() << "no lag among the effects";
    return {};
}

TEST(Twin, StandsAtTheOutputsOfEqualSensorsAlone) {
    const Variant variant{taskOf(board, "Board"), {}, {}};
    const Outcome<std::vector<EffectClass>> catalogue = effectCatalogue(variant.task.library);
    ASSERT_TRUE(catalogue);
    const std::vector<EffectPlace> like = likePlaces(variant, lagAt(*catalogue, "T1"), *catalogue);
    ASSERT_EQ(like.size(), 2u);  // its own place is free as long as the effect is not wired in
    EXPECT_EQ(like[0].at, "output T1");
    EXPECT_EQ(like[1].at, "output T2");
}

TEST(Twin, StandsAtTheInputsOfOneUnitThatFeedEqualBlocks) {
    const Variant variant{taskOf(R"(model Board
  Analogon.Interfaces.RealInput duty1(unit="1");
  Analogon.Interfaces.RealInput duty2(unit="1");
  Analogon.Interfaces.RealInput T_room(unit="K");
  Analogon.Interfaces.RealInput P(unit="W");
  Analogon.Interfaces.RealOutput T(unit="K");
  Analogon.Signals.Gain power1(k=2);
  Analogon.Signals.Gain power2(k=3);
  Analogon.Signals.Gain scaled(k=1);
  Analogon.Sources.PrescribedHeatFlow heater1;
  Analogon.Sources.PrescribedHeatFlow heater2;
  Analogon.Sources.PrescribedHeatFlow heater3;
  Analogon.Sources.PrescribedTemperature room;
  Analogon.Thermal.HeatCapacitor body(C=4);
  Analogon.Thermal.ThermalConductor loss(G=0.1);
  Analogon.Sensors.TemperatureSensor sensor;
equation
  connect(duty1, power1.u);
  connect(duty2, power2.u);
  connect(T_room, scaled.u);
  connect(power1.y, heater1.Q_flow);
  connect(power2.y, heater2.Q_flow);
  connect(P, heater3.Q_flow);
  connect(scaled.y, room.T);
  connect(heater1.port, body.port);
  connect(heater2.port, body.port);
  connect(heater3.port, body.port);
  connect(body.port, loss.port_a);
  connect(loss.port_b, room.port);
  connect(body.port, sensor.port);
  connect(sensor.T, T);
end Board;
)",
                                 "Board"),
                          {},
                          {}};
    const Outcome<std::vector<EffectClass>> catalogue = effectCatalogue(variant.task.library);
    ASSERT_TRUE(catalogue);
    PlacedEffect lag;
    for (const EffectClass& e : *catalogue)
        if (e.kind == "actuator.lag") lag = {e, {"input duty1", "duty1", "", ""}, "lag", "", {}, {}};
    std::vector<std::string> at;
    for (const EffectPlace& p : likePlaces(variant, lag, *catalogue)) at.push_back(p.at);
    EXPECT_EQ(at, (std::vector<std::string>{"input duty1", "input duty2"}));
}

TEST(Twin, HasTheParametersOfTheFirst) {
    const Variant base{taskOf(board, "Board"), {}, {}};
    const Outcome<std::vector<EffectClass>> catalogue = effectCatalogue(base.task.library);
    ASSERT_TRUE(catalogue);
    PlacedEffect lag = lagAt(*catalogue, "T1");
    FitParameter tau;
    tau.name = "lag.T";
    tau.start = 3;
    lag.freed.push_back(tau);
    lag.twins.push_back({"output T2", "T2", "", ""});
    const Outcome<Variant> both = withEffects(base, {lag}, {{"lag.T", -1, 3}});
    ASSERT_TRUE(both) << format(both.diagnostics());
    ASSERT_EQ(both->effects.size(), 1u);
    ASSERT_EQ(both->effects.front().twinInstances.size(), 1u);
    const std::string text = both->task.model->text();
    EXPECT_NE(text.find("(T=lag.T)"), std::string::npos) << text;
    EXPECT_NE(text.find("connect(second.T, " + both->effects.front().twinInstances.front()), std::string::npos) << text;
    // once wired in, neither place is offered again
    EXPECT_TRUE(likePlaces(*both, both->effects.front(), *catalogue).empty());
}

}  // namespace
}  // namespace analogon
