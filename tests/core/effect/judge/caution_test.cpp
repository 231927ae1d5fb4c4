#include "core/effect/judge/caution.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace analogon {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Recording recording(const std::string& name, Role role, double from, double to) {
    Recording r;
    r.name = name;
    r.role = role;
    r.inputNames = {"v"};
    r.outputNames = {"w"};
    r.inputs.resize(1, 11);
    r.outputs = Eigen::MatrixXd::Zero(1, 11);
    for (int k = 0; k <= 10; ++k) {
        r.time.push_back(k);
        r.inputs(0, k) = from + (to - from) * k / 10;
        r.outputs(0, k) = k % 2;
    }
    r.outputs(0, 3) = std::nan("");
    return r;
}

TEST(Caution, SaysWhereAValidationIsExtrapolated) {
    EstimationTask task;
    task.recordings = {recording("one", Role::Fit, 0, 6), recording("two", Role::Fit, 2, 10),
                       recording("within", Role::Validate, -0.5, 10.5), recording("beyond", Role::Validate, 1, 14)};
    EXPECT_THAT(extrapolations(task), ElementsAre(HasSubstr("'beyond' leaves the range of the fitted recordings on "
                                                            "input v by 40 %")));
}

TEST(Caution, SaysThatTheFittedRecordingsHoldStillWhatMovesLater) {
    EstimationTask task;
    task.recordings = {recording("cold", Role::Fit, 20, 20.1), recording("warm", Role::Validate, 26, 26.5)};
    EXPECT_THAT(extrapolations(task), ElementsAre(HasSubstr("hold input v near 20.05, 'warm' has it between 26 and")));
    const auto said = [](double to) {
        EstimationTask moved;
        moved.recordings = {recording("cold", Role::Fit, 20, 22), recording("warm", Role::Validate, 21, to)};
        return extrapolations(moved);
    };
    EXPECT_THAT(said(25), ElementsAre(HasSubstr("by 150 %"))) << "it did not stand still";
    EXPECT_THAT(said(27), ElementsAre(HasSubstr("hold input v near 21")));
}

TEST(Caution, SaysThatARecordingBeginsElsewhereThanTheModel) {
    ModelState state;
    ExperimentState run;
    run.name = "run";
    OutputState n;
    n.name = "n";
    n.unit = "rad/s";
    n.simulated = Eigen::VectorXd::Constant(200, 250);
    n.measured = n.simulated;
    for (int k = 0; k < 40; ++k) n.simulated[k] = 250 * (1 - std::exp(-0.1 * k));
    run.outputs = {n};
    state.experiments = {run};
    // where nothing moves at all every difference would be clear
    n.measured[100] = 200;
    state.experiments.front().outputs = {n};
    state.residual["n"] = summarise(n.simulated - n.measured);
    EXPECT_THAT(wrongStarts(state, Role::Fit),
                ElementsAre(HasSubstr("'run' begins with n at 250 rad/s where the model begins at 0 rad/s: tell")));
    FitEstimate start;
    start.name = "rotor.phi_start";
    start.experiment = 0;
    state.parameters.push_back(start);
    EXPECT_THAT(wrongStarts(state, Role::Fit), ElementsAre(HasSubstr("though a start value is fitted there")));
    state.parameters.back().experiment = 1;
    EXPECT_THAT(wrongStarts(state, Role::Fit), ElementsAre(HasSubstr("tell its start value")))
        << "of another recording";
    state.experiments.front().outputs.front().simulated[0] = 250;
    EXPECT_THAT(wrongStarts(state, Role::Fit), IsEmpty()) << "a start that is right";
}

/// A recording to validate, in which a speed was measured.
ModelState withCheck(const std::string& name, const Eigen::VectorXd& measured, const Eigen::VectorXd& simulated) {
    ModelState state;
    ExperimentState check;
    check.name = name;
    check.role = Role::Validate;
    OutputState n;
    n.name = "n";
    n.unit = "rad/s";
    n.measured = measured;
    n.simulated = simulated;
    check.outputs = {n};
    state.experiments = {check};
    return state;
}

TEST(Caution, SaysThatACheckBeginsElsewhereThanTheModel) {
    ModelState state =
        withCheck("rest", Eigen::VectorXd::LinSpaced(200, 250, 300), Eigen::VectorXd::LinSpaced(200, 0, 300));
    state.residual["n"].standardDeviation = 1;
    EXPECT_THAT(wrongStarts(state, Role::Fit), IsEmpty());
    EXPECT_THAT(wrongStarts(state, Role::Validate),
                ElementsAre(HasSubstr("'rest' begins with n at 250 rad/s where the model begins at 0 rad/s: tell")));
    state.experiments[0].starts.resize(1);
    EXPECT_THAT(wrongStarts(state, Role::Validate), ElementsAre(HasSubstr("though a start value is fitted there")));
}

TEST(Caution, TellsWhereASensorStuck) {
    EstimationTask task;
    Recording r = recording("run", Role::Fit, 0, 1);
    constexpr int samples = 200;
    r.time.clear();
    r.inputs = Eigen::MatrixXd::Zero(1, samples);
    r.outputs.resize(1, samples);
    for (int k = 0; k < samples; ++k) {
        r.time.push_back(k);
        r.outputs(0, k) = std::sin(0.1 * k + 0.01 * k * k);
    }
    task.recordings = {r};
    EXPECT_THAT(stuckReadings(task), IsEmpty());
    task.recordings.edit()[0].outputs.row(0).segment(80, 30).setConstant(0.25);
    EXPECT_THAT(stuckReadings(task), ElementsAre(AllOf(HasSubstr("reads 0.25 from 80 s to 109 s without any change"),
                                                       HasSubstr("did the sensor or the logger stick?"))));
    for (const double end : {-1.5, 1.5}) {
        task.recordings.edit()[0].outputs.row(0).segment(80, 30).setConstant(end);
        EXPECT_THAT(stuckReadings(task),
                    ElementsAre(HasSubstr("does the range of the sensor or the logger end there?")));
    }
    for (int k = 0; k < samples; ++k) task.recordings.edit()[0].outputs(0, k) = std::round(2 * r.outputs(0, k));
    task.recordings.edit()[0].outputs.row(0).segment(80, 30).setConstant(2);
    EXPECT_THAT(stuckReadings(task), IsEmpty()) << "a coarse converter often reads the same";
}

/// Two recordings of y = p*x with p = 2 in the first; what p is in the second is the test's.
NullModel proportional(double inSecond, double range = 10) {
    NullModel null;
    null.variant.task.recordings = {recording("cold", Role::Fit, 0, 1), recording("warm", Role::Fit, 0, 1)};
    constexpr int rows = 200;
    Eigen::MatrixXd jacobian(2 * rows, 1);
    Eigen::VectorXd measured(2 * rows);
    for (int i = 0; i < 2 * rows; ++i) {
        jacobian(i, 0) = range * std::sin(0.05 * i);
        measured[i] = (i < rows ? 2.0 : inSecond) * jacobian(i, 0) + (i % 2 ? 1.0 : -1.0);
    }
    const double p = jacobian.col(0).dot(measured) / jacobian.col(0).squaredNorm();
    null.fit.optimum.jacobian = jacobian;
    null.fit.optimum.residuals = p * jacobian.col(0) - measured;
    FitEstimate estimate;
    estimate.name = "motor.R";
    estimate.value = p;
    null.fit.estimates = {estimate};
    for (int e = 0; e < 2; ++e) {
        ResidualChannel channel;
        channel.experiment = e;
        channel.begin = e * rows;
        channel.end = channel.begin + rows;
        for (int k = 0; k < rows; ++k) channel.samples.push_back(k);
        null.channels.push_back(channel);
    }
    return null;
}

TEST(Caution, NamesAParameterThatIsAnotherOneInOneRecording) {
    EXPECT_THAT(driftBetweenRecordings(proportional(2.0)), IsEmpty());
    const std::vector<Text> said = driftBetweenRecordings(proportional(2.6));
    ASSERT_EQ(said.size(), 1u);
    EXPECT_THAT(said.front(), HasSubstr("motor.R seems to be another one in '"));
    // two recordings: each is another one than the other
    std::vector<double> values;
    for (std::size_t at = said.front().find("about "); at != std::string::npos;
         at = said.front().english().find("about ", at + 1))
        values.push_back(std::stod(said.front().english().substr(at + 6)));
    EXPECT_THAT(values,
                ::testing::UnorderedElementsAre(::testing::DoubleNear(2.6, 0.01), ::testing::DoubleNear(2.0, 0.01)));
}

TEST(Caution, NamesNoOtherValueThatDiffersByLessThanAThousandth) {
    EXPECT_THAT(driftBetweenRecordings(proportional(2.0026, 1e4)), ::testing::SizeIs(1));
    EXPECT_THAT(driftBetweenRecordings(proportional(2.0014, 1e4)), IsEmpty()) << "however exactly it is known";
}

TEST(Caution, NamesNoOtherValueWhereTheDataDetermineNone) {
    NullModel null = proportional(2.6);
    null.fit.estimates.front().standardError = std::nan("");
    EXPECT_THAT(driftBetweenRecordings(null), IsEmpty());
    // nor one that the parameter may not have
    null = proportional(2.6);
    FitParameter bounded;
    bounded.name = "motor.R";
    bounded.min = 0;
    bounded.max = 2.3;
    null.variant.task.parameters = {bounded};
    EXPECT_THAT(driftBetweenRecordings(null), IsEmpty());
    // nor a difference that no figure shows
    null = proportional(2.6);
    null.fit.estimates.front().value = 1e9;
    EXPECT_THAT(driftBetweenRecordings(null), IsEmpty());
}

/// A fitted recording that leaves noise of 0.1, and one to validate of which this is measured where 'simulated' is.
ModelState validated(const std::function<double(double simulated, double noise)>& measured) {
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0, 0.1);
    Eigen::VectorXd fitted(500), model(500), read(500);
    for (int k = 0; k < 500; ++k) {
        fitted[k] = noise(random);
        model[k] = 5 + 3 * std::sin(0.05 * k);
        read[k] = measured(model[k], noise(random));
    }
    read[7] = std::nan("");
    ModelState state = withCheck("check", read, model);
    state.residual["n"] = summarise(fitted);
    return state;
}

TEST(Caution, SaysWhatAPoorValidationLooksLike) {
    EXPECT_THAT(poorValidations(validated([](double y, double e) { return y + e; })), IsEmpty());
    EXPECT_THAT(poorValidations(validated([](double y, double e) { return y + 0.25 + e; })),
                ElementsAre(::testing::AllOf(HasSubstr("'check': n is off by 0.2"), HasSubstr("rad/s"),
                                             HasSubstr("an offset of +0.24"))));
    EXPECT_THAT(poorValidations(validated([](double y, double e) { return 0.9 * y + e; })),
                ElementsAre(HasSubstr("a gain of 0.89")));
    EXPECT_THAT(poorValidations(validated([](double y, double e) { return y + 0.2 * (y - 5) * (y - 5) + e; })),
                ElementsAre(HasSubstr("neither an offset")));
}

TEST(Caution, TakesLouderNoiseAndUncertainParametersForNoise) {
    EXPECT_THAT(poorValidations(validated([](double y, double e) { return y + 2 * e; })), IsEmpty());
    ModelState state = validated([](double y, double e) { return y + 0.25 + e; });
    state.experiments.front().outputs.front().deviation = Eigen::VectorXd::Constant(500, 0.2);
    EXPECT_THAT(poorValidations(state), IsEmpty());
}

TEST(Caution, TakesForNoiseWhatIsFiveTimesWhatTheParametersLeaveOpen) {
    const auto said = [](double deviation) {
        ModelState state = validated([](double y, double e) { return y + 0.25 + e; });
        state.experiments.front().outputs.front().deviation = Eigen::VectorXd::Constant(500, deviation);
        return poorValidations(state).size();
    };
    EXPECT_EQ(said(0.03), 1u) << "an offset of eight deviations";
    EXPECT_EQ(said(0.06), 0u) << "of four";
}

TEST(Caution, SaysWhenADeadTimeIsShorterThanTheSampling) {
    EstimationTask task;
    task.recordings = {recording("one", Role::Fit, 0, 1)};  // a sample each second
    AddedEffect effect;
    effect.kind = "actuator.delay";
    effect.at = "input v";
    effect.parameters = {{"T", 0.47, 0.01, "s"}};
    EXPECT_THAT(delaysInSamples(task, {effect}), ElementsAre(HasSubstr("held between its samples")));
    effect.kind = "sensor.delay";
    EXPECT_THAT(delaysInSamples(task, {effect}), ElementsAre(HasSubstr("0.47 of a sample interval")));
    effect.parameters.front().value = 1.5;
    EXPECT_THAT(delaysInSamples(task, {effect}), IsEmpty());
    effect.parameters.front().value = 40;
    EXPECT_THAT(delaysInSamples(task, {effect}), ElementsAre(HasSubstr("samples long")));
}

TEST(Caution, NamesWhatRestsAtABound) {
    FitResult fit;
    fit.estimates.resize(2);
    fit.estimates[0].name = "motor.R";
    fit.estimates[1] = {};
    fit.estimates[1].name = "motor.k";
    fit.estimates[1].value = 0.05;
    fit.estimates[1].unit = "N.m/A";
    fit.estimates[1].atBound = true;
    EXPECT_THAT(boundHits(fit), ElementsAre(HasSubstr("motor.k rests at a bound (0.05 N.m/A)")));
}

}  // namespace
}  // namespace analogon
