#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/analogon-cli/command_line.hpp"
#include "tests/app/command_process.hpp"

namespace analogon::cli {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// A package beside the block library with a body that falls and bounces.
class SimulateClass : public CommandLine {
protected:
    void SetUp() override {
        CommandLine::SetUp();
        out = scratch / "traces";
        fs::create_directories(scratch / "Toys");
        std::ofstream(scratch / "Toys/package.mo") << "package Toys\nend Toys;\n";
        std::ofstream(scratch / "Toys/Ball.mo") << R"(within Toys;
model Ball
  Real h(start = 1, fixed = true), v(start = 0, fixed = true), span[2];
equation
  der(h) = v;
  der(v) = -9.81;
  span = {h, v};
  when h < 0 then
    reinit(v, -0.5*pre(v));
  end when;
  annotation (experiment(StopTime = 0.6, Interval = 0.1));
end Ball;
)";
    }
    Result simulate(std::vector<std::string> more = {}) {
        std::vector<std::string> all{"simulate", "--class",   "Toys.Ball", "--library", (scratch / "Toys").string(),
                                     "--out",    out.string()};
        all.insert(all.end(), more.begin(), more.end());
        return run(all);
    }
    std::string header() const {
        const std::string traces = contentOf(out / "traces.csv");
        return traces.substr(0, traces.find('\n'));
    }

    fs::path out;
};

TEST_F(SimulateClass, LeavesTracesAsItsExperimentSays) {
    const Result result = simulate();
    ASSERT_EQ(result.status, done) << result.err;
    EXPECT_THAT(result.out, HasSubstr("Toys.Ball: 0 to 0.6 s, 2 states"));
    EXPECT_EQ(header(), "time,h,v,span[1],span[2],pre(v),der(h),der(v)") << "no name of our own";
    EXPECT_THAT(contentOf(out / "traces.csv"), HasSubstr("\n0.6,"));
}

/// A directory of models that are in no package: each names the others by its file.
TEST_F(SimulateClass, FindsTheClassesOfADirectoryByTheirFiles) {
    const fs::path models = scratch / "models";
    fs::create_directories(models);
    std::ofstream(models / "Air.mo") << "model Air parameter Real T = 290; end Air;\n";
    std::ofstream(models / "Body.mo")
        << "model Body outer Air air; Real T(start = 350, fixed = true); equation der(T) = air.T - T; end Body;\n";
    std::ofstream(models / "Rig.mo") << "model Rig inner Air air(T = 300); Body a; Body b; end Rig;\n";
    std::ofstream(models / "Other.mo") << "model Other Real x end Other;\n";
    const auto simulated = [&](const std::string& name) {
        return run({"simulate", "--class", name, "--library", models.string(), "--stop", "1", "--out", out.string()});
    };
    const Result whole = simulated("Rig");
    ASSERT_EQ(whole.status, done) << whole.err;
    EXPECT_THAT(header(), HasSubstr(",b.T"));
    EXPECT_THAT(simulated("Body").err, HasSubstr("air"));
    const Result broken = simulated("Other");
    EXPECT_EQ(broken.status, inputAtFault) << "the fault of a file tells where it is used, and hinders no other";
    EXPECT_THAT(broken.err, HasSubstr("Other.mo"));
    std::ofstream(models / "User.mo") << "model User Other other; end User;\n";
    EXPECT_THAT(simulated("User").err, AllOf(HasSubstr("'Other' is not known"), HasSubstr("Other.mo")));
}

TEST_F(SimulateClass, TellsTheVariablesThatFitAPattern) {
    ASSERT_EQ(simulate({"--variables", "v,*[?],der(*)"}).status, done);
    EXPECT_EQ(header(), "time,v,span[1],span[2],der(h),der(v)");
    ASSERT_EQ(simulate({"--variables", "*a*[2*"}).status, done);
    EXPECT_EQ(header(), "time,span[2]");
    ASSERT_EQ(simulate({"--variables", std::string(60, '*') + "x"}).status, done) << "at once";
    EXPECT_EQ(header(), "time");
}

/// As for every command: what is not ours stays, and earlier results give way.
TEST_F(SimulateClass, ReplacesEarlierTracesAndNothingElse) {
    ASSERT_EQ(simulate().status, done);
    ASSERT_EQ(simulate({"--stop", "0.2"}).status, done);
    EXPECT_THAT(contentOf(out / "traces.csv"), Not(HasSubstr("\n0.6,")));
    fs::remove_all(out);
    fs::create_directories(out);
    std::ofstream(out / "traces.csv") << "a user's own\n";
    const Result refused = simulate();
    EXPECT_EQ(refused.status, inputAtFault);
    EXPECT_THAT(refused.err, HasSubstr("holds something else"));
    EXPECT_EQ(contentOf(out / "traces.csv"), "a user's own\n");
}

TEST_F(SimulateClass, EndsSoonWhenItIsInterrupted) {
    std::ofstream(scratch / "Toys/Spring.mo")
        << "within Toys;\nmodel Spring\n  Real x(start = 1, fixed = true), v(start = 0, "
           "fixed = true);\nequation\n  der(x) = v;\n  der(v) = -1000*x;\nend Spring;\n";
    Process process({"simulate", "--class", "Toys.Spring", "--library", (scratch / "Toys").string(), "--stop", "1e9",
                     "--out", out.string()},
                    scratch);
    usleep(700'000);
    ASSERT_FALSE(process.poll());
    process.interrupt();
    EXPECT_EQ(process.wait(), interrupted);
    EXPECT_FALSE(fs::exists(out)) << "nothing is left where nothing was written";
}

TEST_F(SimulateClass, IsEvaluatedAtItsStartWhereItLastsNoTime) {
    std::ofstream(scratch / "Toys/Still.mo") << "within Toys;\nmodel Still\n  Real x = 7;\n  annotation "
                                                "(experiment(StopTime = 0));\nend Still;\n";
    const Result result =
        run({"simulate", "--class", "Toys.Still", "--library", (scratch / "Toys").string(), "--out", out.string()});
    ASSERT_EQ(result.status, done) << result.err;
    EXPECT_EQ(contentOf(out / "traces.csv"), "time,x\n0,7\n");
}

TEST_F(SimulateClass, IsAStudyOrAClass) {
    EXPECT_EQ(simulate({"--stop", "-1"}).status, inputAtFault);
    EXPECT_EQ(run({"simulate", study(lag).string(), "--class", "Toys.Ball", "--out", out.string()}).status,
              inputAtFault);
    EXPECT_FALSE(fs::exists(out));
}

}  // namespace
}  // namespace analogon::cli
