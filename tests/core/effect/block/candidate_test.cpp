#include "core/effect/block/candidate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/effect/text_task.hpp"
#include "tests/core/effect/warm_body.hpp"

namespace analogon {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Not;

std::vector<EffectClass> catalogueOf(const Variant& variant) {
    const Outcome<std::vector<EffectClass>> all = effectCatalogue(variant.task.library);
    EXPECT_TRUE(all);
    return *all;
}

std::vector<Candidate> candidates(const Variant& variant, const std::string& kind) {
    std::vector<EffectClass> ofKind;
    for (const EffectClass& e : catalogueOf(variant))
        if (e.kind == kind) ofKind.push_back(e);
    EXPECT_FALSE(ofKind.empty()) << kind;
    const Outcome<std::vector<Candidate>> found = candidatesFor(variant, ofKind);
    EXPECT_TRUE(found) << format(found.diagnostics());
    return found ? *found : std::vector<Candidate>();
}

std::vector<std::string> placesOf(const Variant& variant, const std::string& kind) {
    std::vector<std::string> at;
    for (const Candidate& c : candidates(variant, kind)) at.push_back(c.place.at);
    return at;
}

Variant heatedBody() { return {warmBody({}), {}, {}}; }

TEST(CandidatesFor, AreAtEveryPlaceWhereTheEffectFits) {
    const Variant variant = heatedBody();
    EXPECT_THAT(placesOf(variant, "sensor.lag"), ElementsAre("output T"));
    EXPECT_THAT(placesOf(variant, "actuator.lag"), ElementsAre("input P"));
    EXPECT_THAT(placesOf(variant, "friction.coulomb"), IsEmpty()) << "nothing turns";
}

TEST(CandidatesFor, AreInAModelWithEventsOfItsOwn) {
    const Variant thermostat{taskOf(R"(model Heated
  Analogon.Interfaces.RealOutput T(unit="K");
  Analogon.Sources.PrescribedHeatFlow source;
  Analogon.Thermal.HeatCapacitor body(C=10, T_start=293.15);
  Analogon.Sensors.TemperatureSensor sensor;
  Boolean isOn(start=true, fixed=true);
equation
  source.Q_flow = if isOn then 5 else 0;
  when {T > 330, T < 320} then
    isOn = not pre(isOn);
  end when;
  connect(source.port, body.port);
  connect(body.port, sensor.port);
  connect(sensor.T, T);
end Heated;
)",
                                    "Heated"),
                             {},
                             {}};
    EXPECT_THAT(placesOf(thermostat, "sensor.lag"), ElementsAre("output T"));
    EXPECT_THAT(placesOf(thermostat, "actuator.lag"), IsEmpty()) << "what happens at events is no input";
    EXPECT_THAT(placesOf(thermostat, "thermal.loss"), Not(IsEmpty()));
}

TEST(CandidatesFor, HaveTheUnitOfTheSignalTheyAreAt) {
    const std::vector<Candidate> offset = candidates(heatedBody(), "sensor.offset"),
                                 drift = candidates(heatedBody(), "sensor.drift");
    ASSERT_EQ(offset.size(), 1u);
    EXPECT_EQ(offset[0].effect.parameters.units.at(offset[0].effect.parameters.strength), "K");
    ASSERT_EQ(drift.size(), 1u);
    EXPECT_EQ(drift[0].effect.parameters.units.at(drift[0].effect.parameters.strength), "K/s");
}

TEST(CandidatesFor, LeaveOutWhatStandsThereAlready) {
    Variant variant = heatedBody();
    const Candidate lag = candidates(variant, "sensor.lag").front();
    const Outcome<Variant> with = withEffect(variant, lag.effect, lag.place, {});
    ASSERT_TRUE(with) << format(with.diagnostics());
    EXPECT_THAT(placesOf(*with, "sensor.lag"), IsEmpty());
    EXPECT_THAT(placesOf(*with, "sensor.offset"), ElementsAre("output T"));
    Variant twin = heatedBody();
    twin.effects.push_back({lag.effect, {"elsewhere", "elsewhere", "", ""}, "lag", "", {}, {}, {lag.place}, {"lag2"}});
    EXPECT_THAT(placesOf(twin, "sensor.lag"), IsEmpty()) << "nor where its twin stands";
}

TEST(CandidatesFor, ThatNeedAChannelTakeWhatIsRecordedInItsUnit) {
    Variant variant = heatedBody();
    EXPECT_THAT(candidates(variant, "thermal.loss").size(), testing::Ge(1u));
    const auto sparesOf = [&] {
        std::vector<std::string> spares;
        for (const Candidate& c : candidates(variant, "thermal.loss")) spares.push_back(c.place.spare);
        return spares;
    };
    EXPECT_THAT(sparesOf(), Not(Contains("T_room")));
    Recording r = warmBodyRecording("run", 3);
    r.spares = {{"T_room", "K", {1, 2, 3}}, {"speed", "rad/s", {1, 2, 3}}};
    variant.task.recordings = {r};
    EXPECT_THAT(sparesOf(), Contains("T_room"));
    EXPECT_THAT(sparesOf(), Not(Contains("speed")));
}

TEST(MostPartsFirst, SortsByTheBlocksThatMeetAndElseKeepsTheOrder) {
    std::vector<std::string> connectors{"surroundings.port", "heater.port", "joint.port_b", "body.port"};
    mostPartsFirst(heatedBody(), connectors, [](const std::string& c) -> const std::string& { return c; });
    EXPECT_THAT(connectors, ElementsAre("heater.port", "body.port", "surroundings.port", "joint.port_b"));
}

}  // namespace
}  // namespace analogon
