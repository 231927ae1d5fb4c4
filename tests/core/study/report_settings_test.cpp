#include "core/study/report_settings.hpp"

#include <fmt/format.h>

#include "core/study/results.hpp"
#include "study_fixture.hpp"

namespace analogon {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
namespace fs = std::filesystem;

constexpr const char* svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"9\" height=\"9\"/>";

class ReportSettings : public analogon::test::StudyTest {
protected:
    void SetUp() override {
        StudyTest::SetUp();
        putHeater();
    }
    void putHead(const std::string& head) const {
        change("\"class\": \"Heater\",", "\"class\": \"Heater\", \"report\": " + head + ",");
    }
    /// The page that results have.
    std::string pageOf(const RunResult& result, Diagnostics* told = nullptr) const {
        const fs::path out = directory_ / "out";
        fs::remove_all(out);
        const Outcome<Done> done = writeResults(result, "fit", out);
        EXPECT_TRUE(done) << format(done.diagnostics());
        if (told) *told = done.diagnostics();
        return get(out / "report.html");
    }
};

TEST_F(ReportSettings, AreReadKeptAndHeededByWhateverWritesTheReport) {
    putHead(R"({"title": "Heater 7", "author": "E. N.", "logo": "logo.svg", "leave_out": ["tried"], "other": 3})");
    put("logo.svg", svg);
    const Outcome<Study> study = readStudy(directory_);
    ASSERT_TRUE(study);
    EXPECT_TRUE(study.diagnostics().empty()) << format(study.diagnostics());
    const ReportHead head = reportHeadOf(study->extraJson);
    EXPECT_EQ(head, (ReportHead{"Heater 7", {}, "E. N.", {}, "logo.svg", {ReportSection::Tried}}));
    EXPECT_THAT(studyJson(*study), HasSubstr("\"other\": 3"));
    RunResult result;
    result.completed = *study;
    EXPECT_THAT(pageOf(result), HasSubstr("<h1>Heater 7</h1>"));
    EXPECT_THAT(pageOf(result), HasSubstr("src=\"data:image/svg+xml;base64,"));
    // the study that comes with the report has the head and its picture
    const Outcome<Study> written = readStudy(directory_ / "out" / "study");
    ASSERT_TRUE(written);
    EXPECT_EQ(reportHeadOf(written->extraJson), head);
    EXPECT_EQ(get(directory_ / "out" / "study" / "logo.svg"), svg);
}

TEST_F(ReportSettings, OfAStudyWithoutAHeadChangeNothing) {
    RunResult result;
    result.completed = read();
    EXPECT_EQ(result.completed.extraJson, "");
    EXPECT_EQ(withReportHead("", ReportHead{}), "");
    EXPECT_EQ(withReportHead(R"({"plots":{}})", ReportHead{}), R"({"plots":{}})");
    const std::string page = pageOf(result);
    EXPECT_THAT(page, Not(HasSubstr("class=\"head\"")));
    EXPECT_THAT(get(directory_ / "out" / "study" / "study.json"), Not(HasSubstr("\"report\"")));
}

TEST_F(ReportSettings, AreChangedWithoutLosingWhatIsNotKnown) {
    const std::string before = R"({"plots":{"axes":[]},"report":{"other":[1],"title":"a","leave_out":["tried"]}})";
    ReportHead head = reportHeadOf(before);
    head.title.clear();
    head.date = "today";
    head.leftOut = {ReportSection::Plots, ReportSection::Errors};
    const std::string after = withReportHead(before, head);
    EXPECT_EQ(reportHeadOf(after), head);
    EXPECT_THAT(after, HasSubstr("\"other\":[1]"));
    EXPECT_THAT(after, HasSubstr("\"plots\":{\"axes\":[]}"));
    EXPECT_THAT(after, Not(HasSubstr("title")));
}

TEST_F(ReportSettings, ThatCannotBeUsedAreToldWithTheirPlaceAndTheStudyOpens) {
    putHead("{\"title\": 7,\n \"leave_out\": [\"tried\", \"weather\"], \"logo\": \"none.png\"}");
    const Outcome<Study> study = readStudy(directory_);
    ASSERT_TRUE(study);
    ASSERT_EQ(study.diagnostics().size(), 3u) << format(study.diagnostics());
    for (const Diagnostic& each : study.diagnostics()) EXPECT_EQ(each.severity, Severity::Warning);
    EXPECT_EQ(study.diagnostics()[0].place.line, 3);
    EXPECT_THAT(study.diagnostics()[0].message.english(), HasSubstr("\"title\" must be a text"));
    EXPECT_EQ(study.diagnostics()[1].place.line, 4);
    EXPECT_THAT(study.diagnostics()[1].message.english(), HasSubstr("errors, effects, diagram"));
    EXPECT_THAT(study.diagnostics()[2].message.english(), HasSubstr("the logo 'none.png'"));
    const ReportHead head = reportHeadOf(study->extraJson);
    EXPECT_EQ(head.title, "");
    EXPECT_EQ(head.leftOut, std::set{ReportSection::Tried});
    RunResult result;
    result.completed = *study;
    Diagnostics told;
    EXPECT_THAT(pageOf(result, &told), Not(HasSubstr("<img")));
    ASSERT_EQ(told.size(), 1u);
    EXPECT_EQ(told[0].place.file, "none.png");
    EXPECT_EQ(told[0].severity, Severity::Warning);
}

TEST_F(ReportSettings, OfTheCallerGoBeforeThoseOfTheStudy) {
    putHead(R"({"title": "old"})");
    RunResult result;
    result.completed = read();
    ReportHead head;
    head.title = "new";
    Outcome<ResultsPlace> place = ResultsPlace::take(directory_ / "out");
    ASSERT_TRUE(place);
    ASSERT_TRUE(place->write(result, "fit", Traces::All, {}, head));
    EXPECT_THAT(get(directory_ / "out" / "report.html"), HasSubstr("<h1>new</h1>"));
    EXPECT_EQ(reportHeadOf(readStudy(directory_ / "out" / "study")->extraJson).title, "new");
}

TEST_F(ReportSettings, BringALogoFromElsewhereIntoTheStudy) {
    put("elsewhere/mark.svg", svg);
    put("study/model.mo", get(directory_ / "model.mo"));
    put("study/train.csv", get(directory_ / "train.csv"));
    put("study/study.json", get(directory_ / "study.json"));
    Outcome<Study> study = readStudy(directory_ / "study");
    ASSERT_TRUE(study);
    ReportHead head;
    head.logo = "../elsewhere/mark.svg";
    study->extraJson = withReportHead(study->extraJson, head);
    ASSERT_TRUE(writeStudy(*study, directory_ / "copy"));
    EXPECT_EQ(reportHeadOf(readStudy(directory_ / "copy")->extraJson).logo, "mark.svg");
    EXPECT_EQ(get(directory_ / "copy" / "mark.svg"), svg);
}

TEST_F(ReportSettings, ShowTheDiagramsOfARunThatAddedAnEffect) {
    RunResult result;
    result.completed = read();
    EXPECT_FALSE(diagramsOf(result));
    std::string before = R"(model Heater
  Analogon.Thermal.HeatCapacitor element annotation(Placement(transformation(extent={{-10,-10},{10,10}})));
end Heater;
)";
    std::string after = before;
    after.insert(after.find("end Heater"),
                 "  Analogon.Thermal.HeatCapacitor mass annotation(Placement(transformation(origin={40,0}, "
                 "extent={{-10,-10},{10,10}})));\n");
    AddedEffect effect;
    effect.kind = "thermal.mass";
    effect.wired.instance = "mass";
    effect.at = "element.port";
    result.finding.effects = {effect};
    EXPECT_FALSE(diagramsOf(result));  // a run that kept no texts
    result.finding.baseline.modelText = before;
    result.finding.final.modelText = after;
    const std::optional<DiagramPair> pair = diagramsOf(result);
    ASSERT_TRUE(pair);
    EXPECT_EQ(pair->before.blocks.size(), 1u);
    EXPECT_EQ(pair->after.blocks.size(), 2u);
    EXPECT_EQ(pair->marks, (std::vector<DiagramMark>{{"mass", "thermal.mass"}}));
    EXPECT_THAT(pageOf(result), HasSubstr("The model before and after"));
    // ten blocks of the library cost a page little
    const char* const classes[] = {"Thermal.HeatCapacitor",
                                   "Electric.Resistor",
                                   "Mechanics.Inertia",
                                   "Sources.Chirp",
                                   "ElectricThermal.BasicElectricThermal",
                                   "ThermalFluid.BasicThermalFluid",
                                   "Interfaces.RealInput",
                                   "Sources.PrescribedTemperature",
                                   "ElectricMechanical.BasicElectricMechanical",
                                   "Signals.FirstOrder"};
    std::string ten;
    for (const char* const name : classes)
        ten += fmt::format(
            "  Analogon.{0} b{1} annotation(Placement(transformation(origin={{{1},0}}, "
            "extent={{{{-10,-10}},{{10,10}}}})));\n",
            name, 40 * ten.size() / 100);
    for (std::string* const text : {&before, &after}) text->insert(text->find("end Heater"), ten);
    result.finding.baseline.modelText = before;
    result.finding.final.modelText = after;
    const std::optional<DiagramPair> large = diagramsOf(result);
    ASSERT_TRUE(large);
    const std::string pictures = diagramsHtml(*large);
    EXPECT_LT(pictures.size() + std::string(diagramStyle()).size(), 60000u);
    EXPECT_EQ(large->after.blocks.size(), 12u);
    for (const Block& block : large->after.blocks) EXPECT_TRUE(block.isResolved) << block.className;
    // one that took the place of a block, and one within a component
    result.finding.effects[0].wired.instance = "element.inner.mass";
    EXPECT_EQ(diagramsOf(result)->marks.front().block, "element");
    result.finding.effects[0].wired.instance = "gone";
    EXPECT_EQ(diagramsOf(result)->marks.front().block, "element");
}

}  // namespace
}  // namespace analogon
