#include "core/effect/model/variant.hpp"

#include <gtest/gtest.h>

#include "core/effect/catalogue/catalogue.hpp"
#include "tests/core/effect/warm_body.hpp"

namespace analogon {
namespace {

PlacedEffect lag(const std::vector<EffectClass>& catalogue, const std::string& kind, const std::string& channel) {
    for (const EffectClass& e : catalogue)
        if (e.kind == kind)
            return {
                e, {e.placement.signalSide + " " + channel, channel, "", ""}, "lag", "", {{"lag.T", "s", 1, 0.01, 100}},
                {}};
    ADD_FAILURE() << "no " << kind << " among the effects";
    return {};
}

// An effect that stood aside while the search went on may have the name that another one has got since.
TEST(WithEffects, LeavesTheValueOfANameToTheFirstThatBearsIt) {
    const Variant base{warmBody({}), {}, {}};
    const Outcome<std::vector<EffectClass>> catalogue = effectCatalogue(base.task.library);
    ASSERT_TRUE(catalogue);
    const Outcome<Variant> both = withEffects(
        base, {lag(*catalogue, "sensor.lag", "T"), lag(*catalogue, "actuator.lag", "P")}, {{"lag.T", -1, 7}});
    ASSERT_TRUE(both) << format(both.diagnostics());
    ASSERT_EQ(both->effects.size(), 2u);
    const std::string first = both->effects[0].freed.front().name, second = both->effects[1].freed.front().name;
    EXPECT_NE(first, second);
    ASSERT_EQ(both->values.size(), 1u);
    EXPECT_EQ(both->values.front().name, first);
    EXPECT_EQ(both->values.front().value, 7);
    ASSERT_EQ(both->task.parameters.size(), 2u);
    EXPECT_EQ(both->task.parameters[1].name, second);
}

TEST(WithEffects, ForgetsTheValuesOfWhatIsNotThere) {
    const Variant base{warmBody({}), {}, {}};
    const Outcome<std::vector<EffectClass>> catalogue = effectCatalogue(base.task.library);
    ASSERT_TRUE(catalogue);
    const Outcome<Variant> one =
        withEffects(base, {lag(*catalogue, "sensor.lag", "T")}, {{"other.T", -1, 2}, {"lag.T", -1, 7}});
    ASSERT_TRUE(one) << format(one.diagnostics());
    ASSERT_EQ(one->values.size(), 1u);
    EXPECT_EQ(one->values.front().value, 7);
}

}  // namespace
}  // namespace analogon
