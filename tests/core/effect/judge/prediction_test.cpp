#include "core/effect/judge/prediction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <set>

#include "tests/core/effect/heated_board.hpp"
#include "tests/core/effect/left_by.hpp"

namespace analogon {
namespace {

std::vector<ResidualChannel> channelsOf(const std::vector<int>& lengths) {
    std::vector<ResidualChannel> channels;
    int row = 0;
    for (std::size_t e = 0; e < lengths.size(); ++e) {
        ResidualChannel c{static_cast<int>(e), 0, row, row + lengths[e], {}};
        c.samples.resize(static_cast<std::size_t>(lengths[e]));
        std::iota(c.samples.begin(), c.samples.end(), 0);
        c.measured = Eigen::VectorXd::LinSpaced(lengths[e], 0, 50);
        row += lengths[e];
        channels.push_back(std::move(c));
    }
    return channels;
}

Eigen::VectorXd gaussian(Eigen::Index n, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    Eigen::VectorXd x(n);
    for (double& v : x) v = normal(random);
    return x;
}

/// What is recorded of a slow course that begins anew nowhere: a random walk.
Eigen::VectorXd walk(Eigen::Index n, unsigned seed) {
    Eigen::VectorXd x = gaussian(n, seed);
    std::partial_sum(x.begin(), x.end(), x.begin());
    return x;
}

Eigen::VectorXd wave(Eigen::Index n, double turns) {
    return (2 * std::numbers::pi * turns / static_cast<double>(n) *
            Eigen::ArrayXd::LinSpaced(n, 0, static_cast<double>(n - 1)))
        .sin();
}

Prediction predicted(const std::vector<int>& lengths, const Eigen::MatrixXd& without, const Eigen::MatrixXd& with,
                     const Eigen::VectorXd& residual) {
    NullModel null;
    null.channels = channelsOf(lengths);
    null.fit.optimum = leftBy(without, residual);
    FitResult fit;
    fit.optimum = leftBy(with, residual);
    return predict(null, fit);
}

TEST(PartsLeftOut, AreLongPartsOfOneRecordingAndWholeOnesOfSeveral) {
    const auto ofOne = partsLeftOut(channelsOf({103}));
    ASSERT_EQ(ofOne.size(), 5u);
    for (const auto& part : ofOne) EXPECT_EQ(part.back() - part.front() + 1, static_cast<long>(part.size()));
    EXPECT_EQ(partsLeftOut(channelsOf({50, 70})).size(), 10u);
    const auto ofThree = partsLeftOut(channelsOf({10, 20, 30}));
    ASSERT_EQ(ofThree.size(), 3u);
    EXPECT_EQ(ofThree[1].size(), 20u);
    const auto ofMany = partsLeftOut(channelsOf(std::vector<int>(25, 4)));
    EXPECT_EQ(ofMany.size(), 10u);
    std::set<Eigen::Index> rows;
    for (const auto& part : ofMany) rows.insert(part.begin(), part.end());
    EXPECT_EQ(rows.size(), 100u) << "each row is left out once";
}

TEST(Prediction, OfAMissingEffectIsClearlyBetterThoughAnythingElseRemains) {
    const Eigen::Index n = 1000;
    const Eigen::MatrixXd none = Eigen::MatrixXd::Ones(n, 1), effect = wave(n, 40);
    Eigen::MatrixXd both(n, 2);
    both << none, effect;
    const Prediction p = predicted({1000}, none, both, walk(n, 3) + 40 * effect);
    EXPECT_TRUE(isClearlyBetter(p)) << p.errorPercentBefore << " to " << p.errorPercentAfter;
    EXPECT_EQ(p.blocks, 5);
    EXPECT_GT(p.errorPercentBefore, p.errorPercentAfter);
}

/// A course that a disturbance took once is followed where it is fitted, and not foretold.
TEST(Prediction, OfASlowDisturbanceByASlowColumnIsNoBetter) {
    const Eigen::Index n = 1000;
    const Eigen::MatrixXd none = Eigen::MatrixXd::Ones(n, 1);
    int clear = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
        Eigen::MatrixXd both(n, 2);
        both << none, walk(n, 1000 + seed);
        clear += isClearlyBetter(predicted({1000}, none, both, walk(n, seed))) ? 1 : 0;
    }
    EXPECT_LE(clear, 6);
}

TEST(Prediction, IsAskedOfWholeRecordingsWhereThereAreSeveral) {
    // what is right in one recording and wrong in the others
    const Eigen::Index n = 300;
    const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(3 * n, 0);
    Eigen::VectorXd effect(3 * n), left(3 * n);
    effect << wave(n, 7), wave(n, 7), wave(n, 7);
    left << 5 * wave(n, 7), -5 * wave(n, 7), 5 * wave(n, 7);
    const Prediction p = predicted({300, 300, 300}, none, effect, left + gaussian(3 * n, 1));
    EXPECT_EQ(p.blocks, 3);
    EXPECT_FALSE(isClearlyBetter(p));
    left << 5 * wave(n, 7), 4 * wave(n, 7), 6 * wave(n, 7);
    EXPECT_TRUE(isClearlyBetter(predicted({300, 300, 300}, none, effect, left + gaussian(3 * n, 1))));
}

/// A recording in which it does much would decide alone, if the others did not have to bear it out, too.
TEST(Prediction, OfAnEffectThatOnlyOneRecordingShowsIsNotClear) {
    Prediction p{49, 11, 3, 3, true, 1};
    EXPECT_FALSE(isClearlyBetter(p));
    p.clearlyIn = 2;
    EXPECT_TRUE(isClearlyBetter(p));
    p.areRecordings = false;
    p.blocks = p.betterIn = 10;  // of parts of a recording, which are short, any gain counts
    EXPECT_TRUE(isClearlyBetter(p));
}

/// What neither model foretells says nothing of the one or the other, and leaves the others to decide.
TEST(Prediction, IsNotDecidedByARecordingThatNeitherForetells) {
    const Eigen::Index n = 300;
    const Eigen::VectorXd w = wave(n, 7);
    Eigen::VectorXd effect(3 * n), left(3 * n);
    effect << w, w, w;
    left << 5 * w, 5 * w, 5 * w + 40 * wave(n, 3);  // the range is 50, of a deviation of 14
    const Prediction p = predicted({300, 300, 300}, Eigen::MatrixXd::Zero(3 * n, 0), effect, left + gaussian(3 * n, 1));
    EXPECT_EQ(p.blocks, 3);
    EXPECT_EQ(p.clearlyIn, 2);
    EXPECT_GT(p.removed(), 0.5);
    EXPECT_TRUE(isClearlyBetter(p));
}

TEST(Prediction, IsInPercentOfTheRangeOfEachOutput) {
    const Eigen::Index n = 400;
    Eigen::VectorXd left = Eigen::VectorXd::Ones(n);
    const Prediction p = predicted({400}, Eigen::MatrixXd(n, 0), Eigen::MatrixXd::Ones(n, 1), left);
    EXPECT_NEAR(p.errorPercentBefore, 2, 1e-9) << "1 of a range of 50";
    EXPECT_NEAR(p.errorPercentAfter, 0, 1e-3);
    EXPECT_NEAR(p.removed(), 1, 1e-3);
}

/// A model of the board whose losses are fitted, held against one that has them too large, beside the same noise.
class Refits : public testing::Test {
protected:
    static NullModel fitted(const EstimationTask& task, const std::vector<Eigen::VectorXd>& noise) {
        const NoiseLevel level = noise.empty() ? NoiseLevel::Estimate : NoiseLevel::Keep;
        Outcome<NullModel> model = fitNull(Variant{task, {}, {}}, noise, level, {}, {});
        EXPECT_TRUE(model) << format(model.diagnostics());
        return model ? std::move(*model) : NullModel{};
    }
    struct Both {
        NullModel without, with;
    };
    static Both both(const EstimationTask& task) {
        NullModel with = fitted(task, {});
        std::string text = boardText;
        for (std::size_t at; (at = text.find("G=0.1")) != std::string::npos;) text.replace(at, 5, "G=0.2");
        EstimationTask given = taskOf(text, "Board");
        given.parameters = task.parameters;
        given.parameters.resize(2);  // the capacities alone
        given.recordings = task.recordings;
        return {fitted(given, with.noise), std::move(with)};
    }
    static Prediction refitted(const Both& models) {
        const std::optional<Prediction> found = predictByRefits(models.without, models.with, {}, {});
        EXPECT_TRUE(found);
        return found.value_or(Prediction{});
    }
};

TEST_F(Refits, PredictAsTheFirstOrderDoesNearTheOptimum) {
    const Both models = both(heatedBoard(0, 0));
    const Prediction exact = refitted(models), linear = predict(models.without, models.with.fit);
    EXPECT_TRUE(isClearlyBetter(exact));
    EXPECT_EQ(exact.blocks, 5);
    EXPECT_EQ(exact.betterIn, 5);
    EXPECT_NEAR(exact.errorPercentAfter, linear.errorPercentAfter, 0.02 * linear.errorPercentAfter);
    EXPECT_NEAR(exact.errorPercentBefore, linear.errorPercentBefore, 0.2 * linear.errorPercentBefore);
}

/// Each recording keeps its own noise, whatever stands before it.
TEST_F(Refits, DoNotDependOnRecordingsThatOnlyValidate) {
    const EstimationTask task = heatedBoard(0.02, 0, {0.01, 2});
    EstimationTask behind = task;
    Recording check = task.recordings.front();
    check.name = "check";
    check.role = Role::Validate;
    behind.recordings.edit().insert(behind.recordings.edit().begin(), check);
    const Prediction alone = refitted(both(task)), second = refitted(both(behind));
    EXPECT_NEAR(second.errorPercentBefore, alone.errorPercentBefore, 1e-6 * alone.errorPercentBefore);
    EXPECT_NEAR(second.errorPercentAfter, alone.errorPercentAfter, 1e-6 * alone.errorPercentAfter);
}

TEST(IsClearlyBetter, IsWhatTakesAFifthOffTheErrorOfMostRecordings) {
    const auto isClear = [](double after, int clearlyIn, int blocks) {
        Prediction p;
        p.errorPercentBefore = 10;
        p.errorPercentAfter = after;
        p.areRecordings = true;
        p.blocks = blocks;
        p.betterIn = p.clearlyIn = clearlyIn;
        return isClearlyBetter(p);
    };
    EXPECT_TRUE(isClear(7, 5, 5));
    EXPECT_FALSE(isClear(8.5, 5, 5)) << "less than a fifth";
    EXPECT_FALSE(isClear(7, 2, 5)) << "of less than three fifths of them";
    EXPECT_TRUE(isClear(7, 4, 5));
}

TEST(IsClearlyBetter, IsWhatIsClearlyLikelierBesideAFlowAndPredictsBetterAtAll) {
    const auto isClear = [](double evidence, double after) {
        Prediction p;
        p.errorPercentBefore = 10;
        p.errorPercentAfter = after;
        p.blocks = 5;
        p.besideFlow = evidence;
        return isClearlyBetter(p);
    };
    EXPECT_TRUE(isClear(40, 9));
    EXPECT_FALSE(isClear(20, 9)) << "the flow alone may account for it";
    EXPECT_FALSE(isClear(20, 1)) << "what it was chosen by is asked";
    EXPECT_FALSE(isClear(40, 11)) << "what was left out is predicted worse";
}

TEST(IsClearlyBetter, TakesAThirdOffWhereOneRecordingIsAllThereIs) {
    const auto isClear = [](double after, int betterIn) {
        Prediction p;
        p.errorPercentBefore = 10;
        p.errorPercentAfter = after;
        p.blocks = 5;
        p.betterIn = p.clearlyIn = betterIn;
        return isClearlyBetter(p);
    };
    EXPECT_TRUE(isClear(5, 5));
    EXPECT_FALSE(isClear(7, 5)) << "what is peculiar to a recording agrees with itself";
    EXPECT_FALSE(isClear(5, 4)) << "a slow course joins the parts";
}

}  // namespace
}  // namespace analogon
