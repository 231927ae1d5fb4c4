#include "core/effect/block/law_term.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/core/effect/block/candidates_of.hpp"
#include "tests/core/effect/hand_made.hpp"
#include "tests/core/effect/lagging_body.hpp"

namespace analogon {
namespace {

using ::testing::ElementsAre;

LawQuantity speed() {
    LawQuantity w;
    w.name = w.shown = "w";
    w.unit = UnitFactors::of("rad/s");
    w.range = {-4, 10};
    return w;
}

std::vector<std::string> shown(const std::vector<Term>& terms) {
    std::vector<std::string> texts;
    for (const Term& t : terms) texts.push_back(t.shown);
    return texts;
}

TEST(LawTerms, OfOneQuantityAreItsPowersWithTheirUnits) {
    std::vector<Term> terms;
    addPowers(speed(), true, 1, terms);
    EXPECT_THAT(shown(terms), ElementsAre("w", "w*abs(w)", "w^2", "w^3", "abs(w)", "sign(w)"));
    EXPECT_EQ(terms[5].text, "w/sqrt(w^2 + 0.1^2)") << "rounded off over a hundredth of the largest";
    EXPECT_EQ(terms[2].unit->text(), UnitFactors::of("rad/s")->toThe(2).text());
    terms.clear();
    addPowers(speed(), false, 1, terms);
    EXPECT_EQ(terms.size(), 5u);
}

TEST(LawTerms, OfTwoQuantitiesAreTheirProducts) {
    LawQuantity x = speed();
    x.name = x.shown = "x";
    x.unit.reset();
    std::vector<Term> terms;
    addProducts(speed(), x, true, 2, terms);
    EXPECT_THAT(shown(terms), ElementsAre("w*x", "w*abs(x)", "w*x^2", "sign(w)*abs(x)"));
    EXPECT_FALSE(terms[0].unit) << "the unit of one is not known";
    EXPECT_EQ(terms[0].complexity, 2);
}

TEST(LawTerms, SetInWithinTheRangeOfAQuantity) {
    std::vector<Term> terms;
    addHinges(speed(), {0, 10}, terms);
    ASSERT_EQ(terms.size(), 10u);
    EXPECT_EQ(terms[0].shown, "max(0, w - (3))");
    EXPECT_EQ(terms[1].shown, "min(0, w - (7))");
}

TEST(LawTerms, AreWavesOnceToThriceATurn) {
    std::vector<Term> terms;
    LawQuantity phi = speed();
    phi.name = phi.shown = "phi";
    addWaves(phi, terms);
    EXPECT_THAT(shown(terms),
                ElementsAre("sin(phi)", "cos(phi)", "sin(2*phi)", "cos(2*phi)", "sin(3*phi)", "cos(3*phi)"));
}

constexpr int samples = 500;

std::vector<Term> termsOf(const std::vector<int>& complexities) {
    std::vector<Term> terms;
    for (const int c : complexities) {
        Term t;
        t.complexity = c;
        terms.push_back(t);
    }
    return terms;
}

std::vector<std::vector<std::size_t>> setsOf(const Eigen::VectorXd& residual, const Eigen::MatrixXd& columns,
                                             const std::vector<int>& complexities) {
    const NullModel null = modelThatLeaves(residual, Eigen::MatrixXd(samples, 0));
    std::vector<std::vector<std::size_t>> sets;
    const std::vector<Term> terms = termsOf(complexities);
    for (const TermSet& set : likeliestSets(null, terms, columns)) sets.push_back(set.terms);
    return sets;
}

TEST(LikeliestSets, AreTheBestTermsAloneAndTheBestWithWhatAddsMost) {
    Eigen::MatrixXd columns(samples, 3);
    columns << sineWave(samples, 2), sineWave(samples, 3), sineWave(samples, 4);
    const Eigen::VectorXd residual = 3 * columns.col(2) + 2 * columns.col(0) + whiteNoise(samples);
    EXPECT_THAT(setsOf(residual, columns, {1, 1, 1}),
                ElementsAre(ElementsAre(2u), ElementsAre(0u), ElementsAre(2u, 0u)));
    EXPECT_TRUE(setsOf(whiteNoise(samples), columns, {1, 1, 1}).empty()) << "chance";
}

TEST(LikeliestSets, TakeOneOfTracesThatAreAlike) {
    const Eigen::VectorXd first = sineWave(samples, 2), other = sineWave(samples, 5);
    const auto count = [&](double correlation) {
        Eigen::MatrixXd columns(samples, 2);
        columns << first, correlation * first + std::sqrt(1 - correlation * correlation) * other;
        return setsOf(3 * first + whiteNoise(samples), columns, {1, 1}).size();
    };
    EXPECT_EQ(count(0.995), 1u);
    EXPECT_EQ(count(0.985), 2u);
}

TEST(LikeliestSets, PreferTheSimplerAsLongAsItExplainsNineTenths) {
    const Eigen::VectorXd first = sineWave(samples, 2), other = sineWave(samples, 5);
    const auto best = [&](double shareOfSimple) {
        Eigen::MatrixXd columns(samples, 2);
        columns << std::sqrt(shareOfSimple) * first + std::sqrt(1 - shareOfSimple) * other, first;
        const std::vector<std::vector<std::size_t>> sets = setsOf(30 * first + whiteNoise(samples), columns, {1, 2});
        return sets.empty() ? std::vector<std::size_t>() : sets.front();
    };
    EXPECT_THAT(best(0.92), ElementsAre(0u));
    EXPECT_THAT(best(0.88), ElementsAre(1u));
}

TEST(LikeliestSets, LeaveOutAFurtherTermThatIsDecoration) {
    Eigen::MatrixXd columns(samples, 2);
    columns << sineWave(samples, 2), sineWave(samples, 5);
    const auto hasPair = [&](double share) {
        const Eigen::VectorXd residual =
            30 * (columns.col(0) + std::sqrt(share) * columns.col(1)) + whiteNoise(samples);
        const std::vector<std::vector<std::size_t>> sets = setsOf(residual, columns, {1, 1});
        return std::any_of(sets.begin(), sets.end(), [](const auto& set) { return set.size() == 2; });
    };
    EXPECT_TRUE(hasPair(0.025));
    EXPECT_FALSE(hasPair(0.015));
}

TEST(OriginOf, IsANumberNearTheFirstValue) {
    EXPECT_NEAR(originOf(Eigen::Vector2d(293.157, 300)), 293.2, 1e-9);
    EXPECT_NEAR(originOf(Eigen::Vector2d(-12.3456, 4)), -12.35, 1e-9);
    EXPECT_EQ(originOf(Eigen::Vector2d(1e-9, 4)), 0);
}

TEST(QuantityOf, IsTakenAsTheDifferenceToItsOrigin) {
    const LawQuantity q =
        quantityOf("x1", "body.T", "T", "K", {Eigen::Vector2d(290, 310), Eigen::Vector2d(280, 300)}, 293);
    EXPECT_EQ(q.shown, "(T - 293)");
    EXPECT_EQ(q.range.low, -13);
    EXPECT_EQ(q.range.high, 17);
    EXPECT_EQ(q.largest(), 17);
    EXPECT_EQ(quantityOf("x1", "w", "w", "rad/s", {Eigen::Vector2d(0, 3)}, 0).shown, "w");
}

TEST(MovingSeries, LeaveOutWhatStandsStill) {
    const NullModel null = fittedModel(laggingBody(0));
    const Outcome<PreparedTask> held = prepareHeld(null.variant, {}, null.noise);
    ASSERT_TRUE(held);
    const Series series = movingSeries(null, *held, {"body.T", "surroundings.T"}, {});
    ASSERT_EQ(series.size(), 1u);
    ASSERT_EQ(series.at("body.T").size(), 1u);
    EXPECT_EQ(series.at("body.T")[0].size(), 400);
    EXPECT_NEAR(series.at("body.T")[0][0], 300, 1e-9);
}

TEST(QuantitiesOf, AreInputsOutputsAndStatesOnce) {
    const NullModel null = fittedModel(laggingBody(0));
    const Outcome<PreparedTask> held = prepareHeld(null.variant, {}, null.noise);
    ASSERT_TRUE(held);
    EXPECT_THAT(quantitiesOf(*held->system),
                ElementsAre(std::pair("P", "W"), std::pair("T", "K"), std::pair("body.T", "K")));
}

}  // namespace
}  // namespace analogon
