#include "core/fit/estimation_task.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace analogon {
namespace {

using ::testing::HasSubstr;

const char* const ovenText = R"(
model Oven
  input Real power(unit = "W");
  input Real T_amb(unit = "K");
  output Real T_wall(unit = "K");
  output Real loss(unit = "W");
  parameter Real C(unit = "J/K", min = 1, max = 1000) = 50;
  parameter Real G(unit = "W/K", min = 0) = 2;
  parameter Real T_start(unit = "K") = 293;
  final parameter Real fixedOne = 1;
  parameter Real foundOne(fixed = false);
  Real T(start = T_start, fixed = true);
equation
  C*der(T) = fixedOne*power - loss;
  loss = G*(T - T_amb);
  T_wall = T;
initial equation
  foundOne = 2*fixedOne;
end Oven;
)";

Recording recording(const std::string& name, Role role, int count, double start) {
    Recording r;
    r.name = name;
    r.role = role;
    r.inputNames = {"T_amb", "power"};  // not the model's order
    r.inputs.resize(2, count);
    r.outputNames = {"T_wall"};
    r.outputs.resize(1, count);
    r.weights = Eigen::VectorXd::Ones(1);
    double T = start;
    for (int k = 0; k < count; ++k) {
        r.time.push_back(k);
        r.inputs(0, k) = 290.0;
        r.inputs(1, k) = 100.0;
        r.outputs(0, k) = T;
        // exact over one second at constant power: C = 80, G = 4
        const double end = 290.0 + 25.0;
        T = end + (T - end) * std::exp(-4.0 / 80.0);
    }
    return r;
}

EstimationTask ovenTask() {
    EstimationTask task;
    task.model = std::make_shared<const Source>("oven.mo", ovenText);
    task.library = *Library().withSource(task.model);
    task.className = "Oven";
    for (const char* name : {"C", "G"}) {
        FitParameter p;
        p.name = name;
        p.start = std::nan("");  // the model's own
        task.parameters.push_back(p);
    }
    task.recordings = {recording("cold", Role::Fit, 60, 285.0), recording("check", Role::Validate, 40, 320.0),
                       recording("hot", Role::Fit, 50, 330.0)};
    task.recordings.edit()[0].starts = {{"T_start", 285.0, false}};
    task.recordings.edit()[1].starts = {{"T_start", 320.0, false}};
    task.recordings.edit()[2].starts = {{"T_start", 328.0, true}};
    return task;
}

TEST(Prepare, OrdersChannelsAndTakesWhatIsOpenFromTheModel) {
    const Outcome<PreparedTask> prepared = prepare(ovenTask());
    ASSERT_TRUE(prepared) << format(prepared.diagnostics());
    const FitProblem& problem = prepared->problem;
    ASSERT_EQ(problem.experiments.size(), 2u);
    EXPECT_EQ(prepared->fitRecordings, (std::vector<int>{0, 2}));
    EXPECT_EQ(problem.experiments[0].inputs.values(0, 0), 100.0);
    EXPECT_EQ(problem.experiments[0].inputs.values(1, 0), 290.0);
    EXPECT_EQ(problem.experiments[0].measured(0, 0), 285.0);
    EXPECT_TRUE(std::isnan(problem.experiments[0].measured(1, 0)));
    EXPECT_EQ(problem.experiments[0].weights[1], 0.0);
    EXPECT_GT(problem.experiments[0].weights[0], 0.0);
    EXPECT_FALSE(problem.weightsAreNoise);
    ASSERT_EQ(problem.parameters.size(), 3u);
    EXPECT_EQ(problem.parameters[0].start, 50.0);
    EXPECT_EQ(problem.parameters[0].min, 1.0);
    EXPECT_EQ(problem.parameters[0].max, 1000.0);
    EXPECT_EQ(problem.parameters[0].unit, "J/K");
    EXPECT_EQ(problem.parameters[1].min, 0.0);
    EXPECT_EQ(problem.parameters[2].name, "T_start");
    EXPECT_EQ(problem.parameters[2].experiment, 1);
    EXPECT_EQ(problem.parameters[2].start, 328.0);
    const int start = prepared->system->parameterIndex("T_start");
    EXPECT_EQ(problem.experiments[0].parameters[static_cast<std::size_t>(start)], 285.0);
}

TEST(Prepare, MakesAProblemThatFits) {
    const Outcome<PreparedTask> prepared = prepare(ovenTask());
    ASSERT_TRUE(prepared);
    const FitResult result = fit(prepared->problem);
    ASSERT_EQ(result.status, FitStatus::Converged) << result.message;
    EXPECT_NEAR(result.values[0], 80.0, 1e-3);
    EXPECT_NEAR(result.values[1], 4.0, 1e-4);
    EXPECT_NEAR(result.values[2], 330.0, 1e-3);
}

TEST(Prepare, WeighsByTheNoiseAndTheWishOfTheStudy) {
    EstimationTask task = ovenTask();
    task.recordings.edit()[0].weights[0] = 2.0;
    const std::vector<Eigen::VectorXd> noise(3, (Eigen::VectorXd(2) << 0.5, 0.0).finished());
    const Outcome<PreparedTask> prepared = prepare(task, noise);
    ASSERT_TRUE(prepared);
    EXPECT_EQ(prepared->problem.experiments[0].weights[0], 4.0);
    EXPECT_EQ(prepared->problem.experiments[1].weights[0], 2.0);
    EXPECT_TRUE(prepared->problem.weightsAreNoise);
}

TEST(Prepare, TakesTheRecordingsOfTheRole) {
    const Outcome<PreparedTask> prepared = prepare(ovenTask(), {}, Role::Validate, {"T_start"});
    ASSERT_TRUE(prepared);
    ASSERT_EQ(prepared->problem.experiments.size(), 1u);
    EXPECT_EQ(prepared->problem.experiments[0].name, "check");
    EXPECT_EQ(prepared->fitRecordings, (std::vector<int>{1}));
}

std::string faultOf(const EstimationTask& task) {
    const Outcome<PreparedTask> prepared = prepare(task);
    EXPECT_FALSE(prepared);
    return prepared ? std::string{} : format(prepared.diagnostics());
}

TEST(Prepare, NamesWhatIsWrong) {
    EstimationTask task = ovenTask();
    task.parameters[0].name = "Cc";
    EXPECT_THAT(faultOf(task), HasSubstr("Oven has no parameter Cc"));
    task = ovenTask();
    task.parameters[0].name = "T_strat";
    EXPECT_THAT(faultOf(task), HasSubstr("did you mean 'T_start'?"));
    task = ovenTask();
    task.parameters[0].name = "T";
    EXPECT_THAT(faultOf(task), HasSubstr("T is no parameter"));
    task = ovenTask();
    task.parameters[0].name = "fixedOne";
    EXPECT_THAT(faultOf(task), HasSubstr("fixedOne is final"));
    task.parameters[0].name = "foundOne";
    EXPECT_THAT(faultOf(task), HasSubstr("foundOne follows from an initial equation"));
    task = ovenTask();
    task.recordings.edit()[2].starts[0].parameter = "T_begin";
    EXPECT_THAT(faultOf(task), HasSubstr("Oven has no parameter T_begin"));
    task = ovenTask();
    task.recordings.edit()[0].inputNames[0] = "T_ambient";
    EXPECT_THAT(faultOf(task), HasSubstr("experiment 'cold': the model has no input T_ambient"));
    task = ovenTask();
    task.recordings.edit()[0].outputNames[0] = "T_walls";
    EXPECT_THAT(faultOf(task), HasSubstr("did you mean T_wall?"));
    task = ovenTask();
    task.recordings.edit()[0].inputNames.pop_back();
    task.recordings.edit()[0].inputs.conservativeResize(1, Eigen::NoChange);
    EXPECT_THAT(faultOf(task), HasSubstr("experiment 'cold': input power has no channel"));
    task = ovenTask();
    task.recordings.edit()[0].starts = {{"C", 4.0, false}};
    EXPECT_THAT(faultOf(task), HasSubstr("C is fitted for all experiments and has a start of its own here"));
}

}  // namespace
}  // namespace analogon
