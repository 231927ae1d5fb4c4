#include "core/report/report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "core/base/number_text.hpp"
#include "core/report/words.hpp"
#include "sample_finding.hpp"

namespace analogon {
namespace {

using analogon::test::sampleFinding;
using ::testing::HasSubstr;
using ::testing::Not;

const ReportContext discoverContext{"Sensor <1>", "discover", "1.2.3"};

std::size_t occurrences(const std::string& text, const std::string& what) {
    std::size_t count = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++count;
    return count;
}

Finding fitOnly() {
    Finding finding;
    finding.baseline = analogon::test::sampleState(0.02);
    finding.final = finding.baseline;
    return finding;
}

TEST(ReportJson, HasTheShapeOfTheFormat) {
    const auto json = nlohmann::json::parse(reportJson(sampleFinding(), discoverContext));
    EXPECT_EQ(json["format"], "analogon-report-1");
    EXPECT_EQ(json["finding"], "effect");
    const auto& parameter = json["baseline"]["parameters"]["heater.R"];
    EXPECT_DOUBLE_EQ(parameter["value"], 3.0961);
    EXPECT_DOUBLE_EQ(parameter["std"], 0.0213);
    EXPECT_EQ(parameter["unit"], "Ohm");
    EXPECT_EQ(parameter["at_bound"], false);
    const auto& experiment = json["baseline"]["experiments"]["warm-up"];
    EXPECT_EQ(experiment["role"], "fit");
    for (const char* figure : {"rmse", "error_percent", "relative_rms_percent", "fit_percent", "max_abs"})
        EXPECT_TRUE(experiment["outputs"]["i_mod"][figure].is_number()) << figure;
    EXPECT_EQ(json["baseline"]["experiments"]["drive cycle <2>"]["role"], "validate");
    EXPECT_EQ(json["baseline"]["residual"]["i_mod"]["white"], true);
    EXPECT_DOUBLE_EQ(json["baseline"]["residual"]["i_mod"]["noise_std"], 0.0231);
    EXPECT_TRUE(json["final"]["parameters"].contains("radiation.k_r"));
    EXPECT_LT(json["final"]["experiments"]["warm-up"]["error_percent"].get<double>(),
              json["baseline"]["experiments"]["warm-up"]["error_percent"].get<double>());
}

TEST(ReportJson, TellsEffectsCandidatesAndNextExperiment) {
    const auto json = nlohmann::json::parse(reportJson(sampleFinding(), discoverContext));
    const auto& effect = json["effects"][0];
    EXPECT_EQ(effect["kind"], "thermal.radiation");
    EXPECT_EQ(effect["way"], "attach");
    EXPECT_EQ(effect["at"], "element.solid");
    EXPECT_DOUBLE_EQ(effect["parameters"]["k_r"]["std"], 3.1e-13);
    EXPECT_DOUBLE_EQ(effect["evidence"]["delta_bic"], -1540.2);
    EXPECT_EQ(effect["alternatives"][1]["equivalent"], true);
    EXPECT_EQ(json["candidates"].size(), 7u);
    EXPECT_EQ(json["candidates"][4]["verdict"], "not significant");
    EXPECT_FALSE(json["candidates"][4].contains("absorbed_by"));
    EXPECT_EQ(json["candidates"][5]["absorbed_by"][0], "element.C");
    EXPECT_TRUE(json["next_experiment"].is_string());
    EXPECT_FALSE(json.contains("remainder"));
}

TEST(Reports, TellHowSureAnEffectIsAndWhatThatRestsOn) {
    const auto effectOf = [](const Finding& f) {
        return nlohmann::json::parse(reportJson(f, discoverContext))["effects"][0];
    };
    Finding finding = sampleFinding();
    EXPECT_EQ(effectOf(finding)["confidence"], "established");
    EXPECT_FALSE(effectOf(finding).contains("prediction"));
    EXPECT_THAT(confidenceWords(finding.effects.front()).english(), HasSubstr("established"));
    finding.kind = FindingKind::Partial;
    finding.effects.front().confidence = Confidence::Indicated;
    EXPECT_THAT(confidenceWords(finding.effects.front()).english(), HasSubstr("ended before its last tests"));
    finding.effects.front().prediction = Prediction{2.65, 1.01, 5, 4};
    const auto effect = effectOf(finding);
    EXPECT_EQ(effect["confidence"], "indicated");
    EXPECT_EQ(effect["prediction"]["blocks"], 5);
    EXPECT_EQ(effect["prediction"]["better_in"], 4);
    EXPECT_NEAR(effect["prediction"]["error_percent_before"].get<double>(), 2.65, 1e-12);
    EXPECT_THAT(confidenceWords(finding.effects.front()).english(),
                HasSubstr("from 2.65 % to 1.01 %, in 4 of 5 parts"));
    EXPECT_THAT(summaryWords(finding, "discover"), HasSubstr("indicated, not established"));
    EXPECT_THAT(reportHtml(finding, discoverContext), HasSubstr("in 4 of 5 parts"));
    EXPECT_FALSE(effect["prediction"].contains("delta_bic_beside_flow"));
    finding.effects.front().prediction->besideFlow = 212;
    EXPECT_DOUBLE_EQ(effectOf(finding)["prediction"]["delta_bic_beside_flow"], -212);
    EXPECT_THAT(confidenceWords(finding.effects.front()).english(), HasSubstr("a flow that nobody measured"));
}

TEST(ReportJson, WritesNullForWhatIsNotFinite) {
    Finding finding = sampleFinding();
    finding.final.experiments[0].outputs[0].figures.rmse = std::numeric_limits<double>::infinity();
    const auto json = nlohmann::json::parse(reportJson(finding, discoverContext));
    EXPECT_TRUE(json["baseline"]["parameters"]["element.C"]["std"].is_null());
    EXPECT_TRUE(json["final"]["experiments"]["warm-up"]["outputs"]["i_mod"]["rmse"].is_null());
}

TEST(ReportJson, NamesTheRemainder) {
    Finding finding = sampleFinding();
    finding.kind = FindingKind::Unexplained;
    finding.effects.clear();
    finding.unexplained.remainders.push_back(
        {"i_mod", "element.solid", 33, 3, 8, "warm-up", {{"T_air", 0.83}}, "0.1*T_air"});
    const auto json = nlohmann::json::parse(reportJson(finding, discoverContext));
    EXPECT_EQ(json["finding"], "unexplained");
    EXPECT_EQ(json["remainder"]["output"], "i_mod");
    EXPECT_EQ(json["remainder"]["moves_with"][0]["variable"], "T_air");
    EXPECT_DOUBLE_EQ(json["remainder"]["to"], 8);
    EXPECT_EQ(json["remainder"]["proposed_equation"], "0.1*T_air");
    EXPECT_EQ(json["remainder"]["proposed_block"], "");
    EXPECT_FALSE(json.contains("with_proposals"));
    EXPECT_EQ(summaryText(finding).find("study-proposed"), std::string::npos);
    finding.unexplained.proposed = ProposedModel{finding.final, {}};
    const auto with = nlohmann::json::parse(reportJson(finding, discoverContext));
    EXPECT_EQ(with["with_proposals"], with["final"]) << "of the same shape";
    EXPECT_NE(summaryText(finding).find("study-proposed"), std::string::npos) << "and where it is, is told";
    EXPECT_NE(reportHtml(finding, discoverContext).find("study-proposed"), std::string::npos);
}

TEST(ReportJson, KeepsStartValuesOfExperimentsApart) {
    Finding finding = fitOnly();
    finding.final.parameters.push_back({"element.T_start", "K", 291, 0.1, false, 0});
    const auto json = nlohmann::json::parse(reportJson(finding, {"x", "fit", "1"}));
    EXPECT_EQ(json["final"]["parameters"]["element.T_start (warm-up)"]["experiment"], "warm-up");
    EXPECT_TRUE(json["finding"].is_null());
}

TEST(ReportJson, ListsStartValuesThatOneRecordingAloneHadToTell) {
    Finding finding = fitOnly();
    ExperimentState& last = finding.final.experiments.back();
    last.starts.push_back({"element.T_start", "K", 291, 0.1, false, 0});
    const auto json = nlohmann::json::parse(reportJson(finding, {"x", "simulate", "1"}));
    EXPECT_EQ(json["final"]["parameters"]["element.T_start (" + last.name + ")"]["value"], 291);
    EXPECT_THAT(std::string(json["summary"]), ::testing::HasSubstr("each recording had to tell itself"));
    EXPECT_THAT(reportHtml(finding, {"x", "simulate", "1"}), ::testing::HasSubstr("T_start</code>"));
}

TEST(ReportHtml, IsOneFileWithoutAnythingFromOutside) {
    const std::string html = reportHtml(sampleFinding(), discoverContext);
    EXPECT_THAT(html, HasSubstr("<!DOCTYPE html>"));
    EXPECT_THAT(html, Not(HasSubstr("http")));
    EXPECT_THAT(html, Not(HasSubstr("<script")));
    EXPECT_THAT(html, Not(HasSubstr("src=")));
    EXPECT_THAT(html, HasSubstr("prefers-color-scheme: dark"));
}

TEST(ReportHtml, TakesNoLetterOfASentenceForAnExponent) {
    const std::string html = reportHtml(sampleFinding(), discoverContext);
    EXPECT_THAT(html, HasSubstr("<dt>Confidence</dt><dd>" + confidenceWords(sampleFinding().effects[0]).english()));
    EXPECT_THAT(html, HasSubstr("·10<sup>−11</sup>"));
}

TEST(ReportHtml, EscapesEveryText) {
    Finding finding = sampleFinding();
    finding.baseline.experiments[0].name = finding.final.experiments[0].name = "<img onerror=alert(1)>";
    finding.candidates[0].at = "\"><b>";
    finding.effects[0].description = "a & b <i>";
    finding.baseline.experiments[0].outputs[0].unit = "<u>";
    const std::string html = reportHtml(finding, {"<h1>", "discover", "<v>"});
    for (const char* raw : {"<img", "<b>", "<i>", "<u>", "<h1><", "<v>"}) EXPECT_THAT(html, Not(HasSubstr(raw))) << raw;
    EXPECT_THAT(html, HasSubstr("a &amp; b &lt;i&gt;"));
}

TEST(ReportHtml, ShowsEverySection) {
    const std::string html = reportHtml(sampleFinding(), discoverContext);
    for (const char* heading : {"How well the model follows", "The effect that was missing", "Next experiment",
                                "Measured and simulated", "Parameters", "What is left", "What was tried", "Warnings"})
        EXPECT_THAT(html, HasSubstr(heading));
    EXPECT_EQ(occurrences(html, "<svg"), 4u);
    EXPECT_EQ(occurrences(html, "class=\"trace before\""), 8u);  // signal and residual of four plots
    EXPECT_THAT(html, HasSubstr("at its bound"));
    EXPECT_THAT(html, HasSubstr("not determined"));
    EXPECT_THAT(html, HasSubstr("(2.103 ± 0.031)·10<sup>−11</sup>"));
}

TEST(ReportHtml, ShowsOneModelWhenNothingWasAdded) {
    const std::string html = reportHtml(fitOnly(), {"x", "fit", "1"});
    EXPECT_EQ(occurrences(html, "class=\"trace before\""), 0u);
    EXPECT_THAT(html, Not(HasSubstr("What was tried")));
    EXPECT_THAT(html, Not(HasSubstr("Effects added")));
}

TEST(ReportHtml, StaysSmallForLongRecordings) {
    Finding finding = fitOnly();
    ExperimentState& experiment = finding.baseline.experiments[0];
    experiment.time.clear();
    for (int k = 0; k < 200000; ++k) experiment.time.push_back(k * 1e-3);
    experiment.outputs.resize(1);
    experiment.outputs[0] = analogon::test::sampleOutput(experiment.time, 0.1, 0.1);
    finding.baseline.experiments.resize(1);
    finding.final = finding.baseline;
    EXPECT_LT(reportHtml(finding, {"x", "fit", "1"}).size(), 120000u);
}

TEST(Traces, HoldMeasuredBeforeAndAfter) {
    Finding finding = sampleFinding();
    std::istringstream lines(tracesCsv(finding));
    std::string header, first;
    std::getline(lines, header);
    std::getline(lines, first);
    EXPECT_EQ(header,
              "experiment,time [s],i_mod measured [A],i_mod before [A],i_mod after [A],T_element measured [K],"
              "T_element before [K],T_element after [K]");
    EXPECT_THAT(first, ::testing::StartsWith("warm-up,0,"));
    EXPECT_EQ(std::count(first.begin(), first.end(), ','), 7);
    const std::string all = tracesCsv(finding);
    EXPECT_EQ(static_cast<std::size_t>(std::count(all.begin(), all.end(), '\n')), 1u + 4000 + 900);
}

TEST(Traces, EscapeFormulasAndLeaveGapsEmpty) {
    Finding finding = fitOnly();
    finding.baseline.experiments[0].outputs[0].name = "=1+1";
    finding.baseline.experiments[0].outputs[0].measured[0] = std::nan("");
    finding.baseline.experiments[0].name = "@SUM(A1)";
    const std::string csv = tracesCsv(finding);
    EXPECT_THAT(csv, HasSubstr("\"'=1+1 measured [A]\""));
    EXPECT_THAT(csv, HasSubstr("\"'@SUM(A1)\",0,,"));
}

TEST(Report, ShowsPriorsAndSaysWhenTheDataContradictThem) {
    Finding finding = fitOnly();
    FitEstimate& estimate = finding.baseline.parameters[0];
    estimate.prior = NormalPrior{estimate.value + 0.4, 0.1};
    finding.final = finding.baseline;
    const ReportContext context{"x", "fit", "1"};
    const auto json = nlohmann::json::parse(reportJson(finding, context));
    const auto& prior = json["baseline"]["parameters"][estimate.name]["prior"];
    EXPECT_EQ(prior["std"], 0.1);
    EXPECT_NEAR(prior["distance"].get<double>(), -4.0, 1e-9);
    EXPECT_FALSE(json["baseline"]["parameters"][finding.baseline.parameters[1].name].contains("prior"));
    const std::string html = reportHtml(finding, context);
    EXPECT_THAT(html, HasSubstr(">−4.0 std</td>"));
    EXPECT_THAT(html, HasSubstr("contradicts its prior"));
    EXPECT_THAT(summaryText(finding), HasSubstr("-4.0 std: the data contradict it"));
    finding.final.parameters[0].prior->mean = estimate.value;
    finding.baseline = finding.final;
    EXPECT_THAT(reportHtml(finding, context), Not(HasSubstr("contradicts its prior")));
    EXPECT_THAT(reportHtml(fitOnly(), context), Not(HasSubstr(">Prior</th>")));
}

TEST(Report, ShadesThe95PercentBandsWhereTheyAreKnown) {
    Finding finding = fitOnly();
    const ReportContext context{"x", "fit", "1"};
    EXPECT_THAT(reportHtml(finding, context), Not(HasSubstr("class=\"band")));
    OutputState& output = finding.baseline.experiments[0].outputs[0];
    output.deviation = Eigen::VectorXd::Constant(output.simulated.size(), 0.03);
    finding.baseline.residual[output.name].standardDeviation = 0.04;
    finding.final = finding.baseline;
    const std::string html = reportHtml(finding, context);
    EXPECT_EQ(occurrences(html, "class=\"band parameters\""), 1u);
    EXPECT_EQ(occurrences(html, "class=\"band noise\""), 1u);
    EXPECT_THAT(html, HasSubstr("95 % band"));

    std::istringstream lines(tracesCsv(finding));
    std::string header, first;
    std::getline(lines, header);
    std::getline(lines, first);
    EXPECT_THAT(header, HasSubstr("T_element simulated [K],i_mod std of model [A],i_mod std of measurement [A]"));
    EXPECT_THAT(first, HasSubstr(",0.03,0.05,"));
    EXPECT_EQ(std::count(header.begin(), header.end(), ','), std::count(first.begin(), first.end(), ','));
}

TEST(Report, DrawsAProfileAndCallsAValleyFlat) {
    Finding finding = fitOnly();
    ConfidenceInterval interval;
    interval.lower = 1.0;
    interval.upper = 9.0;
    interval.isOpenAbove = true;
    interval.values = {0.5, 3.0, 9.0};
    interval.rises = {4.0, 0.0, 0.01};
    interval.remark = "these data set no upper limit to R: up to 9 the misfit hardly rises (a flat valley)";
    finding.baseline.parameters[0].interval = interval;
    finding.final = finding.baseline;
    const ReportContext context{"x", "fit", "1"};
    const std::string html = reportHtml(finding, context);
    EXPECT_THAT(html, HasSubstr("class=\"plot profile\""));
    EXPECT_THAT(html, HasSubstr(">flat valley</span>"));
    EXPECT_THAT(html, HasSubstr("open →"));
    const auto json = nlohmann::json::parse(reportJson(finding, context));
    const auto& written = json["baseline"]["parameters"][finding.baseline.parameters[0].name]["interval"];
    EXPECT_EQ(written["profile"]["rises"].size(), 3u);
    EXPECT_TRUE(written["upper"].is_null());
}

TEST(Summary, SaysHowASearchEndedThatHasNotLookedAtEverything) {
    Finding finding = sampleFinding();
    finding.end.interrupted = true;
    EXPECT_THAT(summaryText(finding), HasSubstr("The search was interrupted; this is the best so far."));
    finding.end.isAtLimitOfWork = true;
    EXPECT_THAT(summaryText(finding), HasSubstr("The search ended at its limit of work; this is the best so far."));
}

TEST(Summary, AlignsTheTableAndTellsTheFinding) {
    const std::string text = summaryText(sampleFinding());
    EXPECT_THAT(text,
                HasSubstr("Finding: effect. The model lacked thermal.radiation at element.solid (radiation to the "
                          "surroundings)."));
    EXPECT_THAT(text, HasSubstr("what is left is noise"));
    std::istringstream lines(text);
    std::vector<std::size_t> ends;
    for (std::string line; std::getline(lines, line);)
        if (line.find(" %") != std::string::npos && line.find("Finding") == std::string::npos)
            ends.push_back(displayWidth(line));
    ASSERT_EQ(ends.size(), 6u);
    for (const std::size_t end : ends) EXPECT_EQ(end, ends[0]);
}

TEST(Summary, SaysWhereValidationDoesNotBearOutWhatWasFound) {
    Finding finding = sampleFinding();
    EXPECT_THAT(summaryText(finding), Not(HasSubstr("do not rely on it")));
    for (ExperimentState& e : finding.final.experiments)
        if (e.role == Role::Validate) e.errorPercent = 50;
    EXPECT_THAT(summaryText(finding), HasSubstr("grows from"));
    EXPECT_THAT(summaryText(finding), HasSubstr("do not rely on it"));
    finding.kind = FindingKind::Partial;
    EXPECT_THAT(summaryText(finding), HasSubstr("Part of what the model lacks is explained by thermal.radiation"));
}

TEST(Summary, LeavesOutWhatHardlyMovesWithTheResidual) {
    Remainder remainder;
    remainder.output = "T";
    remainder.movesWith = {{"u", 0.4}, {"w", -0.06}};
    EXPECT_THAT(remainderWords(remainder), HasSubstr("moves with u (correlation 0.40)."));
    remainder.movesWith.erase(remainder.movesWith.begin());
    EXPECT_THAT(remainderWords(remainder), Not(HasSubstr("moves")));
    remainder.node = "gear.flange_b";
    EXPECT_THAT(remainderWords(remainder), Not(HasSubstr("as well")));
    remainder.proposal.equalNodes = {"motor.flange"};
    EXPECT_THAT(remainderWords(remainder), HasSubstr("it acts at gear.flange_b, or as well at motor.flange"));
}

TEST(Summary, NamesWhereASimulationStopped) {
    Finding finding = fitOnly();
    finding.final.experiments[0].failure = {true, 1.25, "heater.T", "not finite"};
    EXPECT_THAT(summaryText(finding),
                HasSubstr("The simulation of 'warm-up' stopped at 1.25 s: not finite in heater.T."));
}

TEST(Words, TellEachKindOfFinding) {
    Finding finding = sampleFinding();
    finding.effects.clear();
    finding.kind = FindingKind::Adequate;
    EXPECT_THAT(summaryWords(finding, "discover"), HasSubstr("what is left is noise, and nothing was added"));
    finding.kind = FindingKind::Unexplained;
    EXPECT_THAT(summaryWords(finding, "discover"), HasSubstr("no known effect explains it"));
    finding = sampleFinding();
    finding.kind = FindingKind::Partial;
    EXPECT_THAT(summaryWords(finding, "discover"), HasSubstr("still has a structure"));
    EXPECT_THAT(summaryWords(finding, "simulate"), HasSubstr("simulated as it stands"));
}

TEST(Words, SayWhenAProposalIsNotBorneOutByValidation) {
    Remainder remainder;
    remainder.output = "T";
    remainder.proposal.equation = "y = u";
    remainder.proposal.errors.fit = 1.15;
    remainder.proposal.errors.validate = 3.0;
    remainder.proposal.errorValidateWithout = 4.31;
    EXPECT_THAT(remainderWords(remainder), ::testing::Not(::testing::HasSubstr("worse")));
    remainder.proposal.errors.validate = 5.17;
    EXPECT_THAT(remainderWords(remainder), ::testing::HasSubstr("not borne out by validation: y = u"));
    EXPECT_THAT(remainderWords(remainder), ::testing::HasSubstr("5.17 % on validation data, worse than the 4.31 %"));
}

TEST(Words, GiveTheValuesOfWhatAnEquationNames) {
    const std::vector<EffectValue> values{{"s", 250, 1, ""}, {"y_max", 0.004, 0, "m"}, {"u_max", 3, 0, ""}};
    EXPECT_EQ(withValues("y = min(u, y_max)", values), "y = min(u, y_max) with y_max = 0.004 m");
    EXPECT_EQ(withValues("y = u", {}), "y = u");
}

TEST(ReportJson, SaysOfACandidateThatCouldNotBeTriedWhyAndNamesNoVerdictOfItsOwn) {
    Finding finding;
    CandidateResult candidate;
    candidate.kind = "compliance.shaft";
    candidate.verdict = Verdict::Failed;
    candidate.failure = phrase("no simulation with this effect succeeded");
    finding.candidates.push_back(candidate);
    const auto json = nlohmann::json::parse(reportJson(finding, discoverContext));
    EXPECT_EQ(json["candidates"][0]["verdict"], "not significant");
    EXPECT_EQ(json["candidates"][0]["failure"], "no simulation with this effect succeeded");
}

TEST(Reports, SayOfEachCandidateThatWasNotTakenWhy) {
    Finding finding = sampleFinding();
    finding.candidates[1].reason = phrase("explains less than {}", "thermal.radiation at <element.solid>");
    const auto json = nlohmann::json::parse(reportJson(finding, discoverContext));
    ASSERT_EQ(json["candidates"].size(), finding.candidates.size());
    for (std::size_t i = 0; i < finding.candidates.size(); ++i)
        EXPECT_EQ(json["candidates"][i].value("reason", "").empty(), finding.candidates[i].verdict == Verdict::Chosen)
            << finding.candidates[i].kind << ", also of a run that kept none";
    EXPECT_EQ(json["candidates"][1]["reason"], "explains less than thermal.radiation at <element.solid>");
    EXPECT_EQ(json["candidates"][5]["reason"], "the data cannot show it: it only shifts element.C and heater.R");
    const std::string html = reportHtml(finding, discoverContext);
    EXPECT_NE(html.find("explains less than thermal.radiation at &lt;element.solid&gt;"), std::string::npos);
    EXPECT_EQ(html.find("explains part of it"), std::string::npos) << "the decision that was made, not what is usual";
}

TEST(Reports, NamesTheChannelThatDrivesACandidate) {
    Finding finding = sampleFinding();
    finding.candidates[0].channel = "gas_flow";
    const nlohmann::json json = nlohmann::json::parse(reportJson(finding, discoverContext));
    EXPECT_EQ(json["candidates"][0]["channel"], "gas_flow");
    EXPECT_FALSE(json["candidates"][1].contains("channel"));
    EXPECT_NE(reportHtml(finding, discoverContext).find("by channel gas_flow"), std::string::npos);
}

TEST(Reports, TellsTheFlowThatNobodyMeasured) {
    Finding finding = sampleFinding();
    EXPECT_FALSE(nlohmann::json::parse(reportJson(finding, discoverContext)).contains("disturbance"));
    finding.unexplained.remainders.resize(1);
    finding.unexplained.disturbance = UnmeasuredFlow{"block.port", 0.8, "W", 150};
    const nlohmann::json json = nlohmann::json::parse(reportJson(finding, discoverContext))["disturbance"];
    EXPECT_EQ(json["node"], "block.port");
    EXPECT_EQ(json["size"], 0.8);
    EXPECT_EQ(json["unit"], "W");
    EXPECT_EQ(json["time_constant"], 150);
    for (const std::string& text : {reportHtml(finding, discoverContext), summaryText(finding)})
        EXPECT_NE(text.find("a flow of 0.8 W (root mean square) at block.port that nobody measured"),
                  std::string::npos);
}

}  // namespace
}  // namespace analogon
