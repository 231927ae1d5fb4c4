#include "core/fit/held_input.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <sstream>

#include "core/study/run.hpp"
#include "study_fixture.hpp"

namespace analogon {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

Outcome<Study> withInput(const std::string& mapping) {
    return parseStudyJson(
        std::make_shared<const Source>("study.json", R"({"format": "analogon-study-1", "class": "M", "experiments": [
        {"name": "a", "role": "fit", "file": "a.csv", "time": "t", "inputs": {"u": )" +
                                                         mapping + R"(}, "outputs": {"y": "y"}}], "parameters": {}})"));
}

TEST(HeldInputOfAStudy, IsReadAndWritten) {
    const Outcome<Study> held = withInput(R"({"column": "U", "unit": "mV", "interpolation": "hold"})");
    ASSERT_TRUE(held) << format(held.diagnostics());
    EXPECT_TRUE(held.diagnostics().empty());
    const ChannelMapping& mapping = held->experiments[0].inputs.at("u");
    EXPECT_EQ(mapping.interpolation, Interpolation::Hold);
    EXPECT_EQ(mappingText(mapping), R"({"column": "U", "unit": "mV", "interpolation": "hold"})");
    const Outcome<Study> again = parseStudyJson(std::make_shared<const Source>("study.json", studyJson(*held)));
    ASSERT_TRUE(again);
    EXPECT_EQ(again->experiments[0].inputs.at("u"), mapping);
    const Outcome<Study> lines = withInput(R"({"column": "U", "interpolation": "linear"})");
    ASSERT_TRUE(lines);
    EXPECT_EQ(lines->experiments[0].inputs.at("u").interpolation, Interpolation::Linear);
    EXPECT_THAT(studyJson(*lines), HasSubstr("\"interpolation\": \"linear\""));
}

TEST(HeldInputOfAStudy, AWordThatIsNoneIsAFaultThatSaysWhatWasMeant) {
    const std::pair<const char*, const char*> wrong[] = {{"\"held\"", "\"hold\""},     {"\"Hold\"", "\"hold\""},
                                                         {"\"zoh\"", "\"hold\""},      {"\"lineal\"", "\"linear\""},
                                                         {"\"previous\"", "\"hold\""}, {"\"cubic\"", "straight lines"}};
    for (const auto& [word, hint] : wrong) {
        const Outcome<Study> study = withInput(std::string(R"({"column": "U", "interpolation": )") + word + "}");
        ASSERT_FALSE(study) << word;
        EXPECT_THAT(study.diagnostics()[0].message.english(), HasSubstr("experiments/0/inputs/u/interpolation"));
        EXPECT_THAT(study.diagnostics()[0].hint.english(), HasSubstr(hint)) << word;
    }
    EXPECT_FALSE(withInput(R"({"column": "U", "interpolation": true})"));
    const Outcome<Study> output = parseStudyJson(
        std::make_shared<const Source>("study.json", R"({"format": "analogon-study-1", "class": "M", "experiments": [
        {"name": "a", "role": "fit", "file": "a.csv", "time": "t", "inputs": {},
         "outputs": {"y": {"column": "y", "interpolation": "hold"}}}], "parameters": {}})"));
    EXPECT_FALSE(output);
}

Recording ofOneInput(std::vector<double> time, const Eigen::RowVectorXd& values) {
    Recording r;
    r.time = std::move(time);
    r.inputNames = {"u", "s"};
    r.held = {"u"};
    r.inputs.resize(2, values.size());
    r.inputs << values, 2 * values;
    r.outputNames = {"y"};
    r.outputs = values;
    r.spares.push_back({"T", "K", std::vector<double>(values.data(), values.data() + values.size())});
    return r;
}

TEST(HeldInputOfAStudy, AClockMovesItsJumpsBetweenTheSamplesOfOthers) {
    Recording r = ofOneInput({0, 1, 2, 3, 4}, (Eigen::RowVectorXd(5) << 1, 1, 5, 5, 2).finished());
    shiftHeld(r, 0, 0.25);  // stamped late: all happened a quarter earlier
    EXPECT_THAT(r.time, ElementsAre(0, 1, 1.75, 2, 3, 3.75, 4));
    EXPECT_EQ(r.inputs.row(0), (Eigen::RowVectorXd(7) << 1, 1, 5, 5, 5, 2, 2).finished());
    EXPECT_EQ(r.inputs.row(1), (Eigen::RowVectorXd(7) << 2, 2, 8, 10, 10, 5.5, 4).finished());
    EXPECT_TRUE(std::isnan(r.outputs(0, 2)) && std::isnan(r.outputs(0, 5)));
    EXPECT_EQ(r.outputs(0, 6), 2);
    EXPECT_EQ(r.spares[0].values.size(), 7u);
    Recording whole = ofOneInput({0, 1, 2, 3, 4}, (Eigen::RowVectorXd(5) << 1, 1, 5, 5, 2).finished());
    shiftHeld(whole, 0, -1);
    EXPECT_THAT(whole.time, ElementsAre(0, 1, 2, 3, 4));
    EXPECT_EQ(whole.inputs.row(0), (Eigen::RowVectorXd(5) << 1, 1, 1, 5, 5).finished());
}

TEST(HeldInputOfAStudy, AnotherRasterKeepsWhatItDelivers) {
    const std::vector<double> time{0, 1, 2, 3, 4, 5};
    const Eigen::RowVectorXd u = (Eigen::RowVectorXd(6) << 1, 3, 3, 7, 0, 4).finished();
    EXPECT_EQ(heldMeans(time, u, {0.5, 2.5, 4.5}), (Eigen::RowVectorXd(3) << 2.5, 4.25, 0).finished());
    EXPECT_EQ(heldMeans(time, u, {4, 6, 8}), (Eigen::RowVectorXd(3) << 2, 4, 4).finished());
}

/// A motor of which the current follows at once: J*der(w) = k/R*(v - k*w) - b*w, with the true values J = 2e-4 and
/// b = 1e-4, sampled every 50 ms.
class HeldMotor : public test::StudyTest {
protected:
    static constexpr int count = 500;
    static constexpr double interval = 0.05;

    void SetUp() override {
        StudyTest::SetUp();
        put("model.mo", R"(model Motor
  input Real v(unit="V");
  output Real w(unit="rad/s");
  parameter Real R(unit="Ohm") = 2;
  parameter Real k(unit="N.m/A") = 0.05;
  parameter Real J(unit="kg.m2") = 1e-4;
  parameter Real b(unit="N.m.s/rad") = 3e-4;
  Real speed(start=0, fixed=true);
equation
  J*der(speed) = k/R*(v - k*speed) - b*speed;
  w = speed;
end Motor;
)");
    }

    void putStudy(const std::string& mapping) const {
        put("study.json", R"({"format": "analogon-study-1", "class": "Motor", "experiments": [
  {"name": "steps", "role": "fit", "file": "train.csv", "time": "t", "inputs": {"v": )" +
                              mapping + R"(}, "outputs": {"w": "w"}}],
  "parameters": {"J": {"fit": true, "min": 1e-6, "max": 0.01, "scale": "log"},
                 "b": {"fit": true, "min": 1e-6, "max": 0.01, "scale": "log"}}})");
    }

    /// `command` at a sample; `between`: what it is from there to the next, by the part that has passed.
    void record(const std::function<double(int)>& command, const std::function<double(int, double)>& between) const {
        std::mt19937 random(11);
        std::normal_distribution<double> noise(0, 0.3);
        std::ostringstream csv;
        csv << "t [s],u_cmd [V],w [rad/s]\n";
        double w = 0;
        for (int k = 0; k < count; ++k) {
            csv << k * interval << ',' << command(k) << ',' << w + noise(random) << '\n';
            constexpr int inner = 400;
            for (int i = 0; i < inner; ++i) {
                const double v = between(k, (i + 0.5) / inner), h = interval / inner;
                const auto rate = [&](double speed) { return (0.025 * (v - 0.05 * speed) - 1e-4 * speed) / 2e-4; };
                w += h * rate(w + 0.5 * h * rate(w));
            }
        }
        put("train.csv", csv.str());
    }

    static double level(int k) {
        constexpr double levels[] = {9, 0, 3, 12, 6, 9, 3, 0, 12, 6, 3};
        return levels[(k / 7 + k / 45) % 11];
    }
    static double everySample(int k) { return 6 + 4 * std::sin(1.9 * k) + 2 * std::sin(0.37 * k); }
    static std::function<double(int, double)> held(double (*of)(int)) {
        return [of](int k, double) { return of(k); };
    }
    static std::function<double(int, double)> onLines(double (*of)(int)) {
        return [of](int k, double part) { return (1 - part) * of(k) + part * of(k + 1); };
    }

    RunResult fitted() const {
        Outcome<RunResult> result = runFit(read(), {});
        EXPECT_TRUE(result) << format(result.diagnostics());
        return result ? std::move(*result) : RunResult{};
    }
    static double valueOf(const RunResult& result, const std::string& name) {
        for (const FitEstimate& e : result.finding.final.parameters)
            if (e.name == name) return e.value;
        return 0;
    }
    static std::string remarksOf(const std::vector<Text>& remarks) {
        std::string all;
        for (const Text& remark : remarks) all += remark.english() + '\n';
        return all;
    }
};

constexpr const char* heldMapping = R"({"column": "u_cmd", "interpolation": "hold"})";

TEST_F(HeldMotor, TheTrueInertiaIsFoundWithTheCommandHeld) {
    record(level, held(level));
    putStudy(heldMapping);
    const RunResult result = fitted();
    EXPECT_NEAR(valueOf(result, "J"), 2e-4, 0.01 * 2e-4);
    EXPECT_NEAR(valueOf(result, "b"), 1e-4, 0.03 * 1e-4);
    EXPECT_THAT(remarksOf(result.finding.final.remarks), Not(HasSubstr("interpolation")));
}

TEST_F(HeldMotor, OnStraightLinesARemarkTellsWhatItIsAndTheRemedy) {
    record(level, held(level));
    putStudy("\"u_cmd\"");
    const RunResult result = fitted();
    EXPECT_GT(valueOf(result, "J"), 1.05 * 2e-4);
    const std::string remarks = remarksOf(result.finding.final.remarks);
    EXPECT_THAT(remarks, HasSubstr("the input 'v' is held between its samples"));
    EXPECT_THAT(remarks, HasSubstr(R"("v": {"column": "u_cmd", "interpolation": "hold"})"));
    const Outcome<RunResult> simulated = runSimulate(read(), {});
    ASSERT_TRUE(simulated);
    EXPECT_THAT(remarksOf(simulated->finding.final.remarks), HasSubstr(R"("interpolation": "hold")"));
}

TEST_F(HeldMotor, ACommandThatChangesAtEverySampleIsSeenByWhatTheOutputsSay) {
    record(everySample, held(everySample));
    putStudy("\"u_cmd\"");
    EXPECT_THAT(remarksOf(fitted().finding.final.remarks), HasSubstr("the input 'v' is held between its samples"));
    putStudy(heldMapping);
    EXPECT_NEAR(valueOf(fitted(), "J"), 2e-4, 0.01 * 2e-4);
}

TEST_F(HeldMotor, WhatRunsStraightIsNotTakenForHeld) {
    putStudy("\"u_cmd\"");
    for (double (*command)(int) : {level, everySample}) {
        record(command, onLines(command));
        const RunResult result = fitted();
        EXPECT_NEAR(valueOf(result, "J"), 2e-4, 0.01 * 2e-4);
        EXPECT_THAT(remarksOf(result.finding.final.remarks), Not(HasSubstr("held")));
        EXPECT_THAT(remarksOf(runSimulate(read(), {})->finding.final.remarks), Not(HasSubstr("held")));
    }
}

TEST_F(HeldMotor, ADeadTimeIsNotTakenForAHeldCommand) {
    putStudy("\"u_cmd\"");
    for (const int later : {1, 2}) {
        record(level, [later](int k, double part) {
            const int at = std::max(0, k - later);
            return k < later ? level(0) : (1 - part) * level(at) + part * level(at + 1);
        });
        EXPECT_THAT(remarksOf(fitted().finding.final.remarks), Not(HasSubstr("held")));
    }
}

TEST_F(HeldMotor, ASearchHoldsTheCommandAndAddsNothing) {
    record(level, held(level));
    for (const char* mapping : {"\"u_cmd\"", heldMapping}) {
        putStudy(mapping);
        const Outcome<RunResult> result = runDiscover(read(), {});
        ASSERT_TRUE(result) << format(result.diagnostics());
        EXPECT_EQ(result->finding.kind, FindingKind::Adequate) << mapping;
        EXPECT_TRUE(result->finding.effects.empty());
        const bool isTold = mapping == std::string(heldMapping);
        EXPECT_EQ(remarksOf(result->finding.warnings).find("interpolation") == std::string::npos, isTold);
        EXPECT_EQ(remarksOf(result->finding.warnings).find("jump"), std::string::npos);
        EXPECT_EQ(result->completed.experiments[0].inputs.at("v").interpolation, Interpolation::Hold);
        EXPECT_NEAR(valueOf(*result, "J"), 2e-4, 0.01 * 2e-4);
    }
}

}  // namespace
}  // namespace analogon
