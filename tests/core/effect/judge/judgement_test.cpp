#include "core/effect/judge/judgement.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace analogon {
namespace {

/// A periodic torque of strength tau_n and n periods a turn, of which fewer than 7 do not show in the record.
PlacedEffect cogging() {
    PlacedEffect placed;
    placed.instance = "cogging";
    placed.effect.trial.reach["n"] = 1.3;
    FitParameter strength, periods, phase;
    strength.name = "cogging.tau_n";
    periods.name = "cogging.n";
    periods.min = 7;
    periods.max = 15;
    phase.name = "cogging.phi_0";
    phase.min = -1;
    placed.freed = {strength, periods, phase};
    return placed;
}

FitResult ended(double n, bool nAtBound, bool strengthAtBound = false, bool phaseAtBound = false) {
    FitResult fit;
    FitEstimate estimate;
    estimate.name = "cogging.tau_n";
    estimate.atBound = strengthAtBound;
    fit.estimates.push_back(estimate);
    estimate.name = "cogging.n";
    estimate.value = n;
    estimate.atBound = nAtBound;
    fit.estimates.push_back(estimate);
    estimate.name = "cogging.phi_0";
    estimate.value = -1;
    estimate.atBound = phaseAtBound;
    fit.estimates.push_back(estimate);
    return fit;
}

TEST(IsAtBound, IsAnEffectThatEndsWhereItIsNoLongerWhatItIsCalled) {
    EXPECT_FALSE(isAtBound(cogging(), ended(9, false)));
    EXPECT_TRUE(isAtBound(cogging(), ended(9, false, true))) << "its strength ends at a bound";
    EXPECT_TRUE(isAtBound(cogging(), ended(7, true))) << "fewer periods than the record shows";
    EXPECT_FALSE(isAtBound(cogging(), ended(15, true))) << "more of them are the same effect";
    EXPECT_FALSE(isAtBound(cogging(), ended(9, false, false, true))) << "a phase may be any";
}

TEST(HasShapeAtBound, IsAnEffectThatDoesNotGoFarEnough) {
    PlacedEffect placed = cogging();
    placed.effect.wave.phase = "phi_0";
    EXPECT_FALSE(hasShapeAtBound(placed, ended(9, false)));
    EXPECT_TRUE(hasShapeAtBound(placed, ended(15, true)));
    EXPECT_FALSE(hasShapeAtBound(placed, ended(9, false, true))) << "its strength is no shape";
    EXPECT_FALSE(hasShapeAtBound(placed, ended(9, false, false, true))) << "a phase may be any";
}

TEST(LacksAPart, IsABreakawayWithoutFrictionAtSpeed) {
    PlacedEffect placed;
    placed.instance = "stribeck";
    placed.effect.parameters.strength = "tau_s";
    placed.effect.trial.part["tau_c"] = 0.05;
    FitResult fit;
    for (const char* name : {"stribeck.tau_s", "stribeck.tau_c"}) {
        FitEstimate estimate;
        estimate.name = name;
        estimate.value = 0.2;
        fit.estimates.push_back(estimate);
    }
    EXPECT_FALSE(lacksAPart(placed, fit));
    fit.estimates.back().value = 0.001;
    EXPECT_TRUE(lacksAPart(placed, fit));
}

TEST(IsScaleOpen, IsAModelOfWhichAParameterIsNotDeterminedEither) {
    FitResult fit = ended(9, false);
    FitEstimate resistance;
    resistance.name = "cogging.R";  // of the component itself, where an effect specialises it
    resistance.value = 2;
    resistance.standardError = 0.1;
    fit.estimates.push_back(resistance);
    EXPECT_FALSE(isScaleOpen(cogging(), fit.estimates)) << "the effect's own do not count";
    fit.estimates.back().standardError = 50;
    EXPECT_TRUE(isScaleOpen(cogging(), fit.estimates));
}

TEST(IsTold, IsAStrengthThatStandsOutTwiceAsFarBesideStructure) {
    FitResult fit = ended(9, false);
    fit.estimates.front().value = 6.1;
    fit.estimates.front().standardError = 4;
    const Acceptance missed;
    EXPECT_TRUE(isTold(cogging(), fit.estimates, missed, true));
    EXPECT_FALSE(isTold(cogging(), fit.estimates, missed, false));
    fit.estimates.front().standardError = 3;
    EXPECT_TRUE(isTold(cogging(), fit.estimates, missed, false));
    fit.estimates.front().standardError = 6.2;
    EXPECT_FALSE(isTold(cogging(), fit.estimates, missed, true));
}

TEST(OutweighsRest, ASmallerShareDoesWhereAnEquationIsOfferedForTheRest) {
    NullModel null;
    null.fit.optimum.residuals = Eigen::VectorXd::Constant(100, 2);  // 300 above the noise
    EXPECT_TRUE(outweighsRest(160, null, leastOfRest));
    EXPECT_FALSE(outweighsRest(100, null, leastOfRest));
    EXPECT_TRUE(outweighsRest(100, null, leastBesideOffered));
    EXPECT_FALSE(outweighsRest(50, null, leastBesideOffered));
    null.fit.optimum.residuals.setConstant(1.1);  // hardly more than noise
    EXPECT_TRUE(outweighsRest(1, null, leastOfRest));
}

TEST(DrivesToBound, AnEffectThatDoesTheWorkOfAParameter) {
    const FitResult inside = ended(9, false), atBound = ended(15, true);
    EXPECT_TRUE(drivesToBound(inside, atBound));
    EXPECT_FALSE(drivesToBound(inside, inside));
    EXPECT_FALSE(drivesToBound(atBound, atBound)) << "it rested there before";
    FitResult ofEffect;  // parameters of its own are judged otherwise
    EXPECT_FALSE(drivesToBound(ofEffect, atBound));
}

/// A trial with three parameters that leaves noise and explains so much.
Trial leavingNoise(double evidence, const std::string& proposal) {
    Trial trial;
    trial.ok = true;
    trial.evidence = evidence;
    trial.screened.candidate.effect.proposal = proposal;
    PlacedEffect placed = cogging();
    placed.effect.proposal = proposal;
    trial.variant.effects = {placed};
    std::mt19937 random(2);
    std::normal_distribution<double> noise;
    trial.fit.optimum.residuals = Eigen::VectorXd::NullaryExpr(1000, [&] { return noise(random); });
    return trial;
}

TEST(BeatsNames, DoesNoEquationThatMayOnlyMendTheFormOfAName) {
    NullModel null;
    ResidualChannel channel;
    channel.end = 1000;
    null.channels = {channel};
    null.fit.optimum.residuals = Eigen::VectorXd::Constant(1000, 20);
    const auto beats = [&](double named, double equation) {
        return beatsNames(null, {leavingNoise(equation, "a*w^3"), leavingNoise(named, "")}, 0, 1);
    };
    EXPECT_FALSE(beats(100'000, 100'040)) << "no form of an effect is so exact";
    EXPECT_TRUE(beats(100'000, 100'200));
    EXPECT_TRUE(beats(1000, 1040)) << "of so little the form of a name leaves nothing";
    EXPECT_FALSE(beats(1000, 1005)) << "the data do not tell them apart";
}

TEST(BeatsNames, DoesNoEquationWhereNamesExplainNearlyAsMuch) {
    NullModel null;
    ResidualChannel channel;
    channel.end = 1000;
    null.channels = {channel};
    null.fit.optimum.residuals = Eigen::VectorXd::Constant(1000, 20);  // 400 000
    const auto beats = [&](double namedLeaves) {
        Trial equation = leavingNoise(5000, "a*w^3"), named = leavingNoise(1000, "");
        equation.fit.optimum.residuals.setConstant(2);  // 4 000: structure
        named.fit.optimum.residuals.setConstant(std::sqrt(namedLeaves / 1000));
        return beatsNames(null, {equation, named}, 0, 1);
    };
    EXPECT_TRUE(beats(200'000)) << "half of what the equation explains";
    EXPECT_FALSE(beats(100'000)) << "three quarters of it: a name may be near, structure is left";
}

TEST(IsLikelier, AsksLessOfWhatLeavesNoiseThanOfWhatLeavesStructure) {
    const BesideDisturbance without{1000, 0.5};  // 500 of 1000 samples are independent
    const auto evidence = [](double e) { return BesideDisturbance{1000 - (e + std::log(500.0)) / 0.5, 0.5}; };
    EXPECT_TRUE(isLikelier(without, evidence(12), 1000, 1));
    EXPECT_FALSE(isLikelier(without, evidence(5), 1000, 1));
    EXPECT_FALSE(isBorneOut(without, evidence(20), 1000, 1));
    EXPECT_TRUE(isBorneOut(without, evidence(50), 1000, 1));
}

TEST(FightsAnother, IsWhatMakesAnEffectGrowFivefold) {
    NullModel null;
    null.variant.effects = {cogging()};
    null.fit = ended(9, false);
    FitResult with = ended(9, false);
    null.fit.estimates.front().value = 0.1;
    with.estimates.front().value = -0.8;
    EXPECT_TRUE(fightsAnother(null, with));
    with.estimates.front().value = 0.3;
    EXPECT_FALSE(fightsAnother(null, with));
}

TEST(IsGoodPart, IsThreeTenthsOfWhatIsLeftAboveTheNoise) {
    NullModel null;
    null.fit.optimum.residuals = Eigen::VectorXd::Constant(100, 2);  // 300 above the noise
    EXPECT_TRUE(isGoodPart(91, null));
    EXPECT_FALSE(isGoodPart(89, null));
}

TEST(IsBeyondDoubt, IsWhatNothingElseLooksLikeByChance) {
    EXPECT_TRUE(isBeyondDoubt(1001));
    EXPECT_FALSE(isBeyondDoubt(999));
}

}  // namespace
}  // namespace analogon
