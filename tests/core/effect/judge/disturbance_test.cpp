#include "core/effect/judge/disturbance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <set>

#include "tests/core/effect/warm_body.hpp"

namespace analogon {
namespace {

constexpr int rows = 3000, pieces = 100;

/// One channel, and one node whose flow is felt with a delay of first order, as a heat flow by a body.
class OneNode : public testing::Test {
protected:
    OneNode() : disturbance_({channel()}, {{"body.port", true, {{0, 0, responses()}}}}, pieces) {}

    static ResidualChannel channel() {
        ResidualChannel c{0, 0, 0, rows, std::vector<int>(rows)};
        std::iota(c.samples.begin(), c.samples.end(), 0);
        return c;
    }

    static Eigen::VectorXd through(const Eigen::VectorXd& flow) {
        Eigen::VectorXd trace(rows);
        double x = 0;
        for (int k = 0; k < rows; ++k) trace[k] = x += (flow[k] - x) / 60;
        return trace;
    }

    static Eigen::MatrixXd responses() {
        Eigen::MatrixXd columns(rows, pieces + 1);
        for (int j = 0; j <= pieces; ++j) {
            Eigen::VectorXd hat(rows);
            for (int k = 0; k < rows; ++k) hat[k] = std::max(0.0, 1 - std::abs(1.0 * k * pieces / (rows - 1) - j));
            columns.col(j) = through(hat);
        }
        return columns;
    }

    Eigen::VectorXd noise() {
        std::normal_distribution<double> normal;
        Eigen::VectorXd n(rows);
        for (double& x : n) x = normal(random_);
        return n;
    }

    /// A flow that wanders with a correlation time of a fiftieth of the record.
    Eigen::VectorXd wandering() {
        const Eigen::VectorXd white = noise();
        Eigen::VectorXd flow(rows);
        double x = 0;
        for (int k = 0; k < rows; ++k) flow[k] = x += -x / 60 + std::sqrt(2.0 / 60) * white[k];
        return flow;
    }

    /// The model without an effect and the one with it, refitted: its trace is a column of the Jacobian.
    double evidenceOf(const Eigen::VectorXd& trace, const Eigen::VectorXd& residual) const {
        Linearisation without, with;
        without.residuals = residual;
        without.jacobian = Eigen::MatrixXd::Ones(rows, 1);
        with.jacobian.resize(rows, 2);
        with.jacobian << without.jacobian, trace;
        with.residuals = residual - trace * (trace.dot(residual) / trace.squaredNorm());
        return evidenceBeside(beside(without), beside(with), rows, 1);
    }

    BesideDisturbance beside(const Linearisation& model) const {
        const Disturbance::Metric metric = disturbance_.likeliest(model);
        const Eigen::VectorXd left = model.residuals + model.jacobian * disturbance_.step(model, metric, 0);
        return {metric.misfit, disturbance_.independentShare(left, metric)};
    }

    /// What an effect at the node does that follows from the inputs of the experiment: levels held for a while.
    static Eigen::VectorXd effect() {
        Eigen::VectorXd levels(rows);
        for (int k = 0; k < rows; ++k) levels[k] = (k / 170 * 7) % 5 - 2;
        return through(levels);
    }

    std::mt19937 random_{3};
    Disturbance disturbance_;
};

TEST_F(OneNode, LetsAWeakEffectBeSeenInWhiteNoise) {
    const Eigen::VectorXd trace = effect();
    EXPECT_GT(evidenceOf(trace, noise() + 0.3 * trace), 50);
    EXPECT_LT(evidenceOf(trace, noise()), 0) << "nothing there";
}

TEST_F(OneNode, TakesOverWhatAnEffectOnlyImitates) {
    int imitated = 0;
    for (int run = 0; run < 10; ++run) {
        const Eigen::VectorXd trace = effect(), residual = noise() + 5 * through(wandering());
        const double chi2Decrease = trace.dot(residual) * trace.dot(residual) / trace.squaredNorm();
        imitated += chi2Decrease > 100;
        EXPECT_LT(evidenceOf(trace, residual), 15) << "run " << run;
    }
    EXPECT_GT(imitated, 5) << "in white noise it would pass for certain";
}

TEST_F(OneNode, LeavesAnEffectThatStandsOutOfADisturbance) {
    const Eigen::VectorXd trace = effect();
    EXPECT_GT(evidenceOf(trace, noise() + 5 * through(wandering()) + 8 * trace), 30);
}

TEST_F(OneNode, IsAsLikelyInEachOfTwoEqualRecordings) {
    const Eigen::VectorXd residual = noise() + 5 * through(wandering());
    const Eigen::MatrixXd felt = responses();
    ResidualChannel second = channel();
    second.experiment = 1;
    second.begin = rows;
    second.end = 2 * rows;
    Eigen::VectorXd twice(2 * rows);
    twice << residual, residual;
    const Disturbance both({channel(), second}, {{"body.port", true, {{0, 0, felt}, {1, rows, felt}}}}, pieces);
    const double once = disturbance_.likeliest(residual).misfit;
    EXPECT_LT(once, rows * std::log(residual.squaredNorm() / rows) - 100) << "it is there";
    EXPECT_NEAR(both.likeliest(twice).misfit, 2 * once, 1e-6 * std::abs(once));
}

TEST_F(OneNode, IsNotTheOnlyPlaceWhereAnotherFeelsTheSame) {
    const Eigen::MatrixXd felt = responses(),
                          later = through(felt.col(pieces / 2)) * Eigen::RowVectorXd::Ones(pieces + 1);
    Linearisation model;
    model.residuals = noise() + 5 * through(wandering());
    model.jacobian = Eigen::MatrixXd::Ones(rows, 1);
    const auto placesWith = [&](const Eigen::MatrixXd& other, bool isFlow) {
        const Disturbance both({channel()},
                               {{"body.port", true, {{0, 0, felt}}}, {"gear.port", isFlow, {{0, 0, other}}}}, pieces);
        const std::vector<std::string> places = both.likeliestPlaces(model);
        return std::set<std::string>(places.begin(), places.end());
    };
    EXPECT_EQ(placesWith(19 * felt, true), (std::set<std::string>{"body.port", "gear.port"})) << "behind a gear";
    EXPECT_EQ(placesWith(later, true), std::set<std::string>{"body.port"});
    EXPECT_EQ(placesWith(19 * felt, false).size(), 1u) << "a sensor is no other place of a flow";
}

TEST_F(OneNode, TellsTheSizeAndTheMemoryOfAFlow) {
    const Disturbance known({channel()}, {{"body.port", true, {{0, 0, responses()}}, 30, "W"}}, pieces);
    std::vector<double> sizes, times;
    for (int run = 0; run < 9; ++run) {
        Linearisation model;
        model.residuals = 2 * noise() + 5 * through(wandering());  // a size of 5, within 60 samples
        model.jacobian = Eigen::MatrixXd::Ones(rows, 1);
        const std::optional<UnmeasuredFlow> flow = known.flowAt(model, "body.port");
        ASSERT_TRUE(flow);
        EXPECT_EQ(flow->node, "body.port");
        EXPECT_EQ(flow->unit, "W");
        sizes.push_back(flow->size);
        times.push_back(flow->timeConstant);
    }
    const auto median = [](std::vector<double> of) {
        std::sort(of.begin(), of.end());
        return of[of.size() / 2];
    };
    EXPECT_NEAR(median(sizes), 5, 0.75);
    EXPECT_GT(median(times), 35);
    EXPECT_LT(median(times), 100);
    EXPECT_FALSE(known.flowAt({}, "gear.port")) << "nothing is felt there";
}

/// A node that two sensors feel, one behind the other.
class TwoSensors : public OneNode {
protected:
    static Disturbance disturbance() {
        ResidualChannel near = channel(), far = channel();
        far.output = 1;
        far.begin = rows;
        far.end = 2 * rows;
        const Eigen::MatrixXd felt = responses();
        Eigen::MatrixXd hats(rows, pieces + 1), later(rows, pieces + 1);
        for (int j = 0; j <= pieces; ++j) {
            for (int k = 0; k < rows; ++k) hats(k, j) = std::max(0.0, 1 - std::abs(1.0 * k * pieces / (rows - 1) - j));
            later.col(j) = through(felt.col(j));
        }
        return {{near, far},
                {{"body.port", true, {{0, 0, stacked(felt, later)}}},
                 {"output near", false, {{0, 0, hats}}},
                 {"output far", false, {{0, rows, hats}}}},
                pieces};
    }

    static Eigen::MatrixXd stacked(const Eigen::MatrixXd& near, const Eigen::MatrixXd& far) {
        Eigen::MatrixXd both(near.rows() + far.rows(), near.cols());
        both << near, far;
        return both;
    }

    std::string placeOf(const Eigen::VectorXd& near, const Eigen::VectorXd& far) {
        Linearisation model;
        model.residuals = stacked(near + noise(), far + noise());
        model.jacobian = Eigen::MatrixXd::Ones(2 * rows, 1);
        const std::vector<std::string> places = disturbance().likeliestPlaces(model);
        return places.empty() ? std::string() : places.front();
    }

    /// Held for a while: no flow that is felt with a delay does that.
    static Eigen::VectorXd levels(int length) {
        Eigen::VectorXd l(rows);
        for (int k = 0; k < rows; ++k) l[k] = (k / length * 7) % 5 - 2;
        return l;
    }
};

TEST_F(TwoSensors, PutWhatOneOfThemShowsToItAndWhatBothDoToTheNode) {
    const Eigen::VectorXd nothing = Eigen::VectorXd::Zero(rows), flow = through(10 * wandering());
    EXPECT_EQ(placeOf(5 * levels(170), nothing), "output near");
    EXPECT_EQ(placeOf(nothing, 5 * levels(170)), "output far");
    EXPECT_EQ(placeOf(flow, through(flow)), "body.port");
    EXPECT_EQ(placeOf(nothing, nothing), "");
}

TEST_F(TwoSensors, AreNotToBlameWhileTheOtherIsUnexplained) {
    // what it shows is too fast for any of the three
    EXPECT_EQ(placeOf(50 * levels(170), 10 * levels(5)), "body.port");
}

TEST_F(TwoSensors, AreDisturbedAtEveryPlaceThatShowsIt) {
    const auto random = [&] {  // a flow as it may be, each piece straight
        const Eigen::VectorXd white = noise();
        Eigen::VectorXd pieceByPiece(pieces + 1);
        double x = 0;
        for (int j = 0; j <= pieces; ++j) pieceByPiece[j] = x = 0.8 * x + 0.6 * white[j];
        return pieceByPiece;
    };
    const Eigen::VectorXd flow = responses() * (20 * random()), error = responses() * (10 * random());
    Disturbance one = disturbance();
    one.settle(stacked(flow + noise(), through(flow) + noise()));
    EXPECT_TRUE(one.settledPlaces().empty()) << "one flow accounts for all";

    const Eigen::VectorXd both = stacked(flow + noise(), through(flow) + error + noise());
    Disturbance two = disturbance();
    const Disturbance::Metric alone = two.likeliest(both);
    EXPECT_LT(two.independentShare(both, alone), 0.5);
    two.settle(both);
    const Disturbance::Metric beside = two.likeliest(both);
    EXPECT_EQ(two.settledPlaces().size(), 1u);
    EXPECT_LT(beside.misfit, alone.misfit - 100);
    EXPECT_GT(two.independentShare(both, beside), 0.8);
}

/// A body that is heated in steps and cools to 300 K, in a draught.
class BodyInADraught : public testing::Test {
protected:
    static constexpr double capacity = 4, conductance = 0.2;  // [J/K], [W/K]

    static EstimationTask task() {
        constexpr int samples = 2000, inner = 20;
        constexpr double step = 0.25;  // [s]
        EstimationTask task = warmBody({{"body.C", "J/K", 6, 0.1, 100}, {"joint.G", "W/K", 0.3, 0.001, 10}});
        Recording r = warmBodyRecording("steps", samples);
        std::mt19937 random(8);
        std::normal_distribution<double> normal;
        double temperature = 300, draught = 0;
        for (int k = 0; k < samples; ++k) {
            r.time.push_back(step * k);
            r.inputs(0, k) = k % 500 < 250 ? 8 : 6;
            r.outputs(0, k) = temperature + 0.05 * normal(random);
            draught += -draught / 60 + 1.0 * std::sqrt(2.0 / 60) * normal(random);
            const double power = k % 250 == 249 ? 7 : r.inputs(0, k);  // straight between samples
            for (int i = 0; i < inner; ++i)
                temperature += step / inner * (power + draught - conductance * (temperature - 300)) / capacity;
        }
        task.recordings = {r};
        return task;
    }

    static NullModel fitted() {
        const EstimationTask body = task();
        Variant variant{body, {}, {}};
        for (const FitParameter& p : body.parameters) variant.values.push_back({p.name, -1, p.start});
        Outcome<NullModel> null = fitNull(variant, {}, NoiseLevel::Estimate, {}, {});
        EXPECT_TRUE(null) << format(null.diagnostics());
        return null ? std::move(*null) : NullModel{};
    }

    static NullModel at(NullModel model, const std::vector<double>& values) {
        for (std::size_t i = 0; i < values.size(); ++i) model.variant.values[i].value = values[i];
        const Outcome<PreparedTask> prepared = prepareAt(model.variant, model.noise);
        EXPECT_TRUE(prepared) << format(prepared.diagnostics());
        if (prepared)
            model.fit.optimum =
                linearise(prepared->problem, prepared->problem.startValues(), true, model.fit.plans, {}, {});
        return model;
    }
};

TEST_F(BodyInADraught, IsLikeliestNearTheTruthWhereverTheFitHasEnded) {
    const NullModel model = fitted();
    ASSERT_EQ(model.fit.values.size(), 2);
    const double ofTruth = besideDisturbance(at(model, {capacity, conductance}), {}, {}).misfit;
    for (const std::vector<double>& values : {std::vector<double>{9, 0.1}, std::vector<double>{2, 0.5}}) {
        const NullModel bent = at(model, values);
        EXPECT_GT(Disturbance(bent, {}, {}).likeliest(bent.fit.optimum.residuals).misfit, ofTruth + 100);
        EXPECT_NEAR(besideDisturbance(bent, {}, {}).misfit, ofTruth, 3);
    }
}

TEST_F(BodyInADraught, IsSoughtFromWhereTheModelWithoutAnEffectIsLikeliestWhereADescentEndsAboveThat) {
    const NullModel model = fitted();
    ASSERT_EQ(model.fit.values.size(), 2);
    const BesideDisturbance alone = besideDisturbance(model, {}, {});
    const NullModel astray = at(model, {0.1, 10});  // follows the power at once: no slope tells of a capacity
    EXPECT_GT(besideDisturbance(astray, {}, {}).misfit, alone.misfit + 100);
    EXPECT_NEAR(besideDisturbanceAlso(alone, astray, {}, {}).misfit, alone.misfit, 1);
}

TEST_F(BodyInADraught, IsSoughtFromWhatIsOfferedWhereAnEffectGainsNothingElsewhere) {
    const NullModel model = fitted();
    ASSERT_EQ(model.fit.values.size(), 2);
    BesideDisturbance alone = besideDisturbance(model, {}, {});
    const NullModel astray = at(model, {0.1, 10});
    alone.values = astray.variant.values;  // no better a beginning
    EXPECT_GT(besideDisturbanceAlso(alone, astray, {}, {}).misfit, alone.misfit + 100);
    const std::vector<ParameterValue> offered{{"body.C", -1, capacity}, {"joint.G", -1, conductance}};
    const BesideDisturbance sought = besideDisturbanceAlso(alone, astray, {}, {}, mostDisturbances, offered);
    EXPECT_NEAR(sought.misfit, alone.misfit, 3);
}

TEST(IsFallen, IsWhatIsWorthAnotherStep) {
    EXPECT_TRUE(isFallen(100, 97.9));
    EXPECT_FALSE(isFallen(100, 98.1));
}

TEST(IsFeltElsewhere, ByWhatIsLeftOnTheOtherOutputsAgainstAll) {
    EXPECT_TRUE(isFeltElsewhere(2.1, 10));
    EXPECT_FALSE(isFeltElsewhere(1.9, 10));
    EXPECT_TRUE(isFeltElsewhere(21, 1000));
    EXPECT_FALSE(isFeltElsewhere(19, 1000)) << "a fiftieth of all may be left";
}

/// Sensors, each with a slow error of its own.
class SensorsThatWander : public OneNode {
protected:
    static Eigen::MatrixXd hats() {
        Eigen::MatrixXd columns(rows, pieces + 1);
        for (int j = 0; j <= pieces; ++j)
            for (int k = 0; k < rows; ++k)
                columns(k, j) = std::max(0.0, 1 - std::abs(1.0 * k * pieces / (rows - 1) - j));
        return columns;
    }

    std::size_t settledOf(int sensors) {
        const Eigen::MatrixXd felt = hats();
        std::vector<ResidualChannel> channels;
        std::vector<FlowResponse> responses;
        Eigen::VectorXd residuals(sensors * rows);
        for (int i = 0; i < sensors; ++i) {
            ResidualChannel c = channel();
            c.output = i;
            c.begin = i * rows;
            c.end = c.begin + rows;
            channels.push_back(c);
            responses.push_back({"output y" + std::to_string(i), false, {{0, i * rows, felt}}});
            residuals.segment(c.begin, rows) = noise() + 5 * wandering();
        }
        Disturbance disturbance(channels, responses, pieces);
        disturbance.settle(residuals);
        return disturbance.settledPlaces().size();
    }
};

TEST_F(SensorsThatWander, AreSettledUpToThreeWithTheOneThatIsSought) {
    EXPECT_EQ(settledOf(2), 1u);
    EXPECT_EQ(settledOf(5), 2u);
}

}  // namespace
}  // namespace analogon
