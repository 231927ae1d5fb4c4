#include "core/effect/course/held_parameter.hpp"

#include <gtest/gtest.h>

#include "tests/core/effect/held_body.hpp"

namespace analogon {
namespace {

NullModel fitted(const EstimationTask& task) {
    Outcome<NullModel> null = fitNull({task, {}, {}}, {}, NoiseLevel::Estimate, {}, {});
    EXPECT_TRUE(null) << format(null.diagnostics());
    return null ? std::move(*null) : NullModel{};
}

const FitParameter joint{"joint.G", "W/K", 0.3, 0.01, 10};

TEST(HeldInstead, IsTheValueOfWhatIsHeldWrongly) {
    const NullModel null = fitted(bodyHeldAt(6, {joint}));
    const std::vector<HeldInstead> values = heldInstead(null, null, {}, {});
    ASSERT_FALSE(values.empty());
    EXPECT_EQ(values[0].parameter, "body.C");
    EXPECT_EQ(values[0].held, 6);
    EXPECT_NEAR(values[0].value, 4, 5 * values[0].standardError);
    EXPECT_TRUE(values[0].leavesNoise);
    EXPECT_FALSE(values[0].byBound);
    EXPECT_GT(values[0].gain, 1000);
    EXPECT_LT(values[0].errors.fit, 1);
    EXPECT_EQ(values[0].errors.validate, -1) << "nothing validates";
}

TEST(HeldInstead, IsNoneWhereTheModelLeavesNoise) {
    const NullModel null = fitted(bodyHeldAt(4, {joint}));
    for (const HeldInstead& h : heldInstead(null, null, {}, {})) EXPECT_LT(h.gain, 10) << h.parameter;
}

TEST(HeldInstead, MayLieBeyondABoundThatIsTooNarrow) {
    const NullModel null = fitted(bodyHeldAt(6, {joint, {"body.C", "J/K", 6, 5.5, 10}}));
    const std::vector<HeldInstead> values = heldInstead(null, null, {}, {});
    ASSERT_FALSE(values.empty());
    EXPECT_EQ(values[0].parameter, "body.C");
    EXPECT_TRUE(values[0].byBound);
    EXPECT_EQ(values[0].held, 5.5);
    EXPECT_NEAR(values[0].value, 4, 0.1);
}

TEST(HeldInstead, IsOfNothingThatTheRecordingsTellApart) {
    EstimationTask task = bodyHeldAt(6, {joint});
    Recording second = task.recordings.front();
    second.starts = {{"body.C", 7, false}};
    task.recordings.push_back(second);
    const NullModel null = fitted(task);
    for (const HeldInstead& h : heldInstead(null, null, {}, {})) EXPECT_NE(h.parameter, "body.C");
}

TEST(HeldInstead, IsToldAsAnEquation) {
    HeldInstead held;
    held.parameter = "core.C";
    held.unit = "J/K";
    held.value = 302.0004;
    EXPECT_EQ(held.text(), "core.C = 302 J/K");
}

/// What a body held at so many J/K is told beside an account that leaves noise, and so much more of chi-square.
std::vector<HeldInstead> toldBeside(double capacity, double more) {
    const NullModel held = fitted(bodyHeldAt(capacity, {joint}));
    NullModel with = fitted(bodyHeldAt(4, {joint, {"body.C", "J/K", 4, 1, 20}}));
    Eigen::VectorXd& residuals = with.fit.optimum.residuals;
    residuals *= std::sqrt(1 + more / static_cast<double>(residuals.size()));
    std::vector<HeldInstead> told = heldInstead(held, with, {}, {});
    std::erase_if(told, [](const HeldInstead& h) { return h.parameter != "body.C"; });
    return told;
}

TEST(HeldInstead, IsPlausibleWithinAFactorOfThree) {
    EXPECT_EQ(toldBeside(10, 0).size(), 1u) << "two fifths of what is held";
    EXPECT_TRUE(toldBeside(14, 0).empty()) << "less than a third";
}

TEST(HeldInstead, MayBeFarOffWhereItIsClearlyTheBetterAccount) {
    EXPECT_TRUE(toldBeside(14, 15).empty());
    EXPECT_EQ(toldBeside(14, 60).size(), 1u);
}

}  // namespace
}  // namespace analogon
