#include "core/study/run_history.hpp"

#include <array>
#include <random>

#include "core/study/run_json.hpp"
#include "study_fixture.hpp"

namespace analogon {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

/// Runs of the heater: a fit, and a discovery whose every member holds something.
class RunHistory : public analogon::test::StudyTest {
protected:
    PastRun fitted() const {
        const Study study = read();
        const Outcome<RunResult> result = runFit(study, {});
        EXPECT_TRUE(result) << format(result.diagnostics());
        return {"fit", "2026-03-01T14:02:11", 0.125, std::make_shared<const Study>(study),
                std::make_shared<const RunResult>(*result)};
    }
    static PastRun discovered(const PastRun& fit) {
        auto result = std::make_shared<RunResult>(*fit.result);
        Finding& finding = result->finding;
        finding.kind = FindingKind::Partial;
        finding.final.experiments[0].outputs[0].simulated.array() += 0.25;
        finding.final.experiments[0].outputs[0].deviation = finding.final.experiments[0].outputs[0].simulated * 0.01;
        finding.final.experiments[0].role = Role::Validate;
        finding.final.experiments[0].failure = {true, 1.5, "T", "not finite"};
        finding.final.parameters[0].interval =
            ConfidenceInterval{1, std::numeric_limits<double>::infinity(), false, true, {1, 2}, {0, 3.84}, "no limit"};
        finding.final.parameters[0].prior = NormalPrior{3, 0.1};
        finding.final.parameters[0].standardError = std::numeric_limits<double>::quiet_NaN();
        finding.final.status = FitStatus::IterationLimit;
        finding.final.remarks = {phrase("{} and {}", "R", "C")};
        finding.effects.push_back({"thermal.radiation",
                                   "Analogon.Effects.Thermal.Radiation",
                                   "element.solid",
                                   "radiation",
                                   {Way::Specialise, "element", "flow", "flow"},
                                   {{"k_r", 2.1e-11, 3e-13, "W/K4"}},
                                   {812, 0, -1540, 0.9, 8.6, 1.1},
                                   Confidence::Indicated,
                                   Prediction{2.5, 1.25, 10, 8, true},
                                   {{{"thermal.loss", "element.solid", -610, true}}, {"core.C = 302 J/K"}}});
        finding.candidates.push_back({"sensor.lag",
                                      "output i",
                                      "L",
                                      {3.2, 0.1, {"R", "C"}},
                                      -2.5,
                                      Verdict::FailsHeldOut,
                                      2,
                                      phrase("the range ends at {:.3g}", 0.1 + 0.2),
                                      phrase("explains less than {}", phrase("{} at {}", "thermal.loss", "x"))});
        finding.unexplained.remainders.push_back({"i",
                                                  "element.solid",
                                                  7,
                                                  0.5,
                                                  1.5,
                                                  "warm-up",
                                                  {{"T_air", -0.7}},
                                                  phrase("y = {}", "a*u"),
                                                  "C",
                                                  "block C end C;",
                                                  0.5,
                                                  0.6,
                                                  0.7});
        finding.unexplained.proposed = ProposedModel{finding.baseline, {{"flow", "flow"}}};
        result->proposed = result->completed;
        result->proposed->models["proposed.mo"] = "block C end C;";
        finding.nextExperiment = phrase("run {}", phrase("the {} again", "heater")) + " Then stop.";
        finding.warnings = {"plain words", phrase("{} \"quoted\"\n", 1)};
        finding.end.interrupted = true;
        finding.end.seconds = 1.0 / 3;
        result->completed.parameters["R"].value = 3.0000000000000004;
        return {"discover", "2026-03-02T09:00:00", 2.5, fit.ranOn, std::move(result)};
    }
    /// All of a run, its arrays among it.
    static std::string whole(const PastRun& run) {
        return runJson(run, [](std::span<const double> values) {
            std::string digits;
            for (const double value : values) digits += fmt::format("{:a} ", value);
            return digits;
        });
    }
    std::vector<PastRun> readBack(Diagnostics* warnings = nullptr) const {
        const Outcome<std::vector<PastRun>> runs = readHistory(directory_ / "history", read());
        EXPECT_TRUE(runs);
        if (warnings) *warnings = runs.diagnostics();
        return runs ? *runs : std::vector<PastRun>();
    }
    std::vector<fs::path> files(const std::string& ending) const {
        std::vector<fs::path> found;
        for (const auto& entry : fs::directory_iterator(directory_ / "history"))
            if (entry.path().extension() == ending) found.push_back(entry.path());
        std::sort(found.begin(), found.end());
        return found;
    }
};

TEST_F(RunHistory, ReadsBackToTheLastDigit) {
    putHeater();
    const PastRun fit = fitted(), discovery = discovered(fit);
    ASSERT_TRUE(writeHistory({fit, discovery}, directory_ / "history"));
    Diagnostics warnings;
    const std::vector<PastRun> runs = readBack(&warnings);
    EXPECT_TRUE(warnings.empty()) << format(warnings);
    ASSERT_EQ(runs.size(), 2u);
    EXPECT_EQ(whole(runs[0]), whole(fit));
    EXPECT_EQ(whole(runs[1]), whole(discovery));
    EXPECT_NE(whole(runs[0]), whole(runs[1]));
    const Finding& finding = runs[1].result->finding;
    EXPECT_TRUE(std::isnan(finding.final.parameters[0].standardError));
    EXPECT_EQ(finding.final.parameters[0].interval->upper, std::numeric_limits<double>::infinity());
    EXPECT_EQ(finding.effects[0].wired.way, Way::Specialise);
    EXPECT_EQ(finding.candidates[0].verdict, Verdict::FailsHeldOut);
    EXPECT_EQ(finding.candidates[0].failure.pattern(), "the range ends at {:.3g}") << "it can be said in German";
    EXPECT_EQ(finding.candidates[0].reason, "explains less than thermal.loss at x");
    EXPECT_EQ(finding.candidates[0].reason.pattern(), "explains less than {}");
    EXPECT_TRUE(finding.candidates[0].failure.arguments().front().isNumber()) << "with a decimal comma";
    EXPECT_EQ(finding.final.experiments[0].outputs[0].simulated,
              discovery.result->finding.final.experiments[0].outputs[0].simulated);
    EXPECT_EQ(runs[1].ranOn->models, fit.ranOn->models);
    EXPECT_FALSE(runs[0].result->proposed);
    ASSERT_TRUE(runs[1].result->proposed && finding.unexplained.proposed);
    EXPECT_EQ(runs[1].result->proposed->models, discovery.result->proposed->models);
    EXPECT_EQ(finding.unexplained.proposed->newInputs, discovery.result->finding.unexplained.proposed->newInputs);
    EXPECT_EQ(runs[1].result->completed.parameters.at("R").value, 3.0000000000000004);
    EXPECT_EQ(runs[1].ranOn->tables.at("train.csv")->columns[1].values,
              fit.ranOn->tables.at("train.csv")->columns[1].values)
        << "measurements are those of the study";
}

TEST_F(RunHistory, KeepsWhatTheUserSaidOfARun) {
    putHeater();
    PastRun fit = fitted();
    auto before = std::make_shared<ModelState>(fit.result->finding.final);
    before->experiments[0].outputs[0].simulated.array() += 0.5;
    fit.before = before;
    fit.name = "cold start \"B\"";
    fit.note = "Lüfter aus,\nsecond sample";
    fit.isPinned = fit.isShown = true;
    fit.plots = R"({"axes":[],"formulas":["u*i"]})";
    ASSERT_TRUE(writeHistory({fit, fitted()}, directory_ / "history"));
    const std::vector<PastRun> runs = readBack();
    ASSERT_EQ(runs.size(), 2u);
    EXPECT_EQ(runs[0].name, fit.name);
    EXPECT_EQ(runs[0].note, fit.note);
    EXPECT_EQ(runs[0].plots, fit.plots);
    EXPECT_TRUE(runs[0].isPinned && runs[0].isShown);
    ASSERT_TRUE(runs[0].before);
    EXPECT_EQ(runs[0].before->experiments[0].outputs[0].simulated, before->experiments[0].outputs[0].simulated);
    EXPECT_TRUE(runs[1].name.empty() && runs[1].note.empty() && runs[1].plots.empty());
    EXPECT_FALSE(runs[1].isPinned || runs[1].isShown || runs[1].before);
}

TEST_F(RunHistory, KeepsPinnedRunsAndTheTracesOfTheOneThatIsShown) {
    putHeater();
    const PastRun fit = fitted();
    std::vector<PastRun> runs;
    for (int i = 0; i < 6; ++i) {
        auto result = std::make_shared<RunResult>(*fit.result);
        result->finding.final.experiments[0].time.assign(1000, i);
        result->finding.final.experiments[0].outputs[0].figures.errorPercent = i;
        runs.push_back({"fit", "2026-03-01T14:02:11", 1, fit.ranOn, std::move(result)});
    }
    runs[0].isPinned = true;
    runs[3].isShown = true;
    ASSERT_TRUE(writeHistory(runs, directory_ / "history", {3, 12000}));
    const std::vector<PastRun> kept = readBack();
    ASSERT_EQ(kept.size(), 4u);
    const std::array<int, 4> expected{0, 3, 4, 5};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(kept[i].result->finding.final.experiments[0].outputs[0].figures.errorPercent, expected[i]);
        EXPECT_EQ(hasTraces(*kept[i].result), i == 1) << "of run " << expected[i];
    }
    EXPECT_TRUE(kept[0].isPinned);
}

TEST_F(RunHistory, HoldsWhatRunsShareOnce) {
    putHeater();
    const PastRun fit = fitted();
    ASSERT_TRUE(writeHistory({fit, fit, fit, discovered(fit)}, directory_ / "history"));
    EXPECT_EQ(files(".json").size(), 4u);
    std::set<std::vector<double>> arrays;
    for (const PastRun& run : {fit, discovered(fit)})
        for (const ModelState* state : {&run.result->finding.baseline, &run.result->finding.final})
            for (const ExperimentState& e : state->experiments) {
                arrays.insert(e.time);
                for (const OutputState& o : e.outputs)
                    for (const Eigen::VectorXd* v : {&o.measured, &o.simulated, &o.deviation})
                        if (v->size() > 0) arrays.insert({v->data(), v->data() + v->size()});
            }
    EXPECT_EQ(files(traceEnding).size(), arrays.size());
}

TEST_F(RunHistory, HasABoundedSize) {
    putHeater();
    const PastRun fit = fitted();
    std::vector<PastRun> runs;
    for (int i = 0; i < 6; ++i) {
        auto result = std::make_shared<RunResult>(*fit.result);
        OutputState& output = result->finding.final.experiments[0].outputs[0];
        result->finding.final.experiments[0].time.assign(1000, i);
        output.simulated = Eigen::VectorXd::Constant(1000, 10 + i);
        output.measured = output.simulated;
        output.figures.errorPercent = i;
        runs.push_back({"fit", "2026-03-01T14:02:11", 1, fit.ranOn, std::move(result)});
    }
    ASSERT_TRUE(writeHistory(runs, directory_ / "history", {4, 40000}));
    std::uintmax_t bytes = 0;
    for (const fs::path& file : files(traceEnding)) bytes += fs::file_size(file);
    EXPECT_LE(bytes, 40000u);
    const std::vector<PastRun> kept = readBack();
    ASSERT_EQ(kept.size(), 4u);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(kept[i].result->finding.final.experiments[0].outputs[0].figures.errorPercent, 2 + i)
            << "the last ones";
        EXPECT_EQ(hasTraces(*kept[i].result), i >= 2) << "of the latest, two traces of 8 kB each and what all share";
    }
}

TEST_F(RunHistory, LosesOnlyWhatIsDamaged) {
    putHeater();
    const PastRun fit = fitted(), discovery = discovered(fit);
    std::mt19937 random(11);
    int lost = 0, without = 0;
    for (int i = 0; i < 200; ++i) {
        fs::remove_all(directory_ / "history");
        ASSERT_TRUE(writeHistory({fit, discovery}, directory_ / "history"));
        std::vector<fs::path> all = files(".json"), traces = files(traceEnding);
        all.insert(all.end(), traces.begin(), traces.end());
        const fs::path file = all[random() % all.size()];
        std::string bytes = get(file);
        if (i % 3 == 0)
            bytes.resize(random() % bytes.size());
        else
            bytes[random() % bytes.size()] ^= static_cast<char>(1 << (random() % 7));
        std::ofstream(file, std::ios::binary) << bytes;
        Diagnostics warnings;
        const std::vector<PastRun> runs = readBack(&warnings);
        ASSERT_GE(runs.size(), 1u) << "the other run is there";
        lost += runs.size() < 2 ? 1 : 0;
        for (const PastRun& run : runs) without += hasTraces(*run.result) ? 0 : 1;
        if (runs.size() < 2) {
            EXPECT_FALSE(warnings.empty());
            EXPECT_FALSE(hasError(warnings));
        }
        if (file.extension() == traceEnding) {
            EXPECT_EQ(runs.size(), 2u) << "a run without traces is a run";
            EXPECT_FALSE(warnings.empty()) << file;
        }
    }
    EXPECT_GT(lost, 10);
    EXPECT_GT(without, 10);
    put("history/run-0001.json", "{\"format\": \"analogon-run-9\"}");
    put("history/run-0002.json", std::string(100000, '['));
    Diagnostics warnings;
    EXPECT_TRUE(readBack(&warnings).empty());
    ASSERT_EQ(warnings.size(), 2u);
    EXPECT_THAT(warnings[0].message.english(), HasSubstr("analogon-run-9"));
    EXPECT_TRUE(readHistory(directory_ / "nowhere", read())->empty());
}

TEST_F(RunHistory, TakesThePlaceOfTheOneBefore) {
    putHeater();
    const PastRun fit = fitted(), discovery = discovered(fit);
    put("run-history/notes.txt", "mine");
    ASSERT_TRUE(replaceHistory({fit, discovery}, directory_));
    ASSERT_TRUE(replaceHistory({fit}, directory_));
    EXPECT_EQ(readHistory(directory_ / "run-history", read())->size(), 1u);
    EXPECT_FALSE(fs::exists(directory_ / ".run-history.writing"));
    ASSERT_TRUE(replaceHistory({}, directory_));
    EXPECT_EQ(get(directory_ / "run-history" / "notes.txt"), "mine");
    EXPECT_TRUE(readHistory(directory_ / "run-history", read())->empty());
}

/// A recording that came from elsewhere lies beside the study once this is saved: its runs know it there.
TEST_F(RunHistory, FindsARecordingThatWasTakenIntoTheStudy) {
    putHeater();
    PastRun fit = fitted();
    Study then = *fit.ranOn;
    then.experiments[0].file = "/bench/2026/train.csv";
    fit.ranOn = std::make_shared<const Study>(then);
    ASSERT_TRUE(writeHistory({fit}, directory_ / "history"));
    EXPECT_EQ(readBack()[0].ranOn->experiments[0].file, "train.csv");
}

}  // namespace
}  // namespace analogon
