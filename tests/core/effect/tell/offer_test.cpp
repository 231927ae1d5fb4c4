#include "core/effect/tell/offer.hpp"

#include <gtest/gtest.h>

namespace analogon {
namespace {

Remainder left(const std::string& output, double evidence, double from, double to) {
    Remainder r;
    r.output = output;
    r.experiment = "run";
    r.evidence = evidence;
    r.from = from;
    r.to = to;
    r.movesWith = {{"motor.i", 0.8}};
    return r;
}

TEST(Offer, StandsFirstAndShowsWhereTheStrongestRemainderDoes) {
    Remainder proposed;
    proposed.node = "shaft.flange";
    proposed.proposal.equation = "tau = c*w^3";
    std::vector<Remainder> all = {left("a", 20, 1, 2), left("b", 50, 3, 4)};
    offer({proposed}, {}, {}, all);
    ASSERT_EQ(all.size(), 3u);
    EXPECT_EQ(all[0].node, "shaft.flange");
    EXPECT_EQ(all[0].output, "b");
    EXPECT_EQ(all[0].from, 3);
    ASSERT_EQ(all[0].movesWith.size(), 1u);
    EXPECT_EQ(all[0].movesWith[0].variable, "motor.i");
}

TEST(Offer, OfASensorIsOfItsOutputWhereNothingElseIsLeft) {
    ModelState state;
    ExperimentState run;
    run.name = "run";
    run.time = {0, 10};
    run.outputs.resize(1);
    run.outputs[0].name = "T";
    state.experiments = {run};
    Remainder proposed;
    proposed.node = "output w";
    std::vector<Remainder> all;
    offer({proposed}, {}, state, all);
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(all[0].output, "w");
    EXPECT_EQ(all[0].experiment, "run");
    EXPECT_EQ(all[0].to, 10);
}

TEST(Offer, OfACourseNeedsSomethingThatIsLeft) {
    std::vector<Remainder> none;
    offerAlone({}, {}, {}, none);
    EXPECT_TRUE(none.empty());
    offerAlone({}, {{"T", "run", 3}}, {}, none);
    EXPECT_EQ(none.size(), 1u) << "what it accounts for may pass for noise with a memory";
}

}  // namespace
}  // namespace analogon
