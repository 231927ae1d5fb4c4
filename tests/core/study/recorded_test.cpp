#include "core/study/recorded.hpp"

#include <cmath>
#include <random>
#include <sstream>

#include "core/measure/channel_place.hpp"
#include "core/study/run.hpp"
#include "core/study/validate.hpp"
#include "mdf_recording.hpp"
#include "study_fixture.hpp"

namespace analogon {
namespace {

using test::putMdf;
using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsNan;
using ::testing::Not;
using ::testing::Pointwise;

Outcome<Study> withExperiment(const std::string& members) {
    return parseStudyJson(std::make_shared<const Source>(
        "study.json", R"({"format": "analogon-study-1", "class": "M", "experiments": [{"name": "a", "role": "fit",
        "file": "a.csv", )" +
                          members + R"(}], "parameters": {}})"));
}

constexpr const char* mapped = R"("inputs": {"u": "u"}, "outputs": {"y": "y"})";

TEST(RecordedStudy, TakesNoUnitForAnotherThatIsNone) {
    const Outcome<Study> study =
        withExperiment(std::string(R"("time": "t", "read": {"unit_names": {"kpa": "kpa"}}, )") + mapped);
    ASSERT_FALSE(study);
    EXPECT_THAT(format(study.diagnostics()), HasSubstr("the unit \"kpa\" is not known"));
}

TEST(RecordedStudy, TakesNoOtherWordForTheTimesOfChannels) {
    for (const char* told : {R"("both")", "1"}) {
        const Outcome<Study> study =
            withExperiment(std::string(R"("time": "t", "read": {"times": )") + told + "}, " + mapped);
        ASSERT_FALSE(study) << told;
        EXPECT_THAT(format(study.diagnostics()), HasSubstr("expected one, left or right"));
    }
}

TEST(RecordedStudy, KeepsHowAFileIsReadOnTheWayThroughItsText) {
    const std::string members = R"("time": {"column": "t", "group": "fast"},
      "read": {"separator": ";", "decimal": ",", "thousands": ".", "skip": 3, "header": 2, "units": true,
               "time_format": "%d.%m.%Y %H:%M:%S", "time_zone": "Europe/Berlin", "encoding": "windows-1252",
               "times": "left", "unit_names": {"kpa": "kPa", "counts": "1"}},
      "raster": {"column": "w", "group": 2},
      "inputs": {"u": {"column": "U", "sheet": "Messung"}}, "outputs": {"y": {"column": "Y", "group": 3}})";
    const Outcome<Study> study = withExperiment(members);
    ASSERT_TRUE(study) << format(study.diagnostics());
    EXPECT_TRUE(study.diagnostics().empty());
    const StudyExperiment& e = study->experiments[0];
    EXPECT_EQ(e.timeGroup, (GroupName{"fast", 0, false}));
    EXPECT_EQ(e.read.separator, ';');
    EXPECT_EQ(e.read.thousands, '.');
    EXPECT_EQ(e.read.skip, 3u);
    EXPECT_EQ(e.read.header, 2u);
    EXPECT_EQ(e.read.hasUnitsRow, true);
    EXPECT_EQ(e.read.timeZone, "Europe/Berlin");
    EXPECT_EQ(e.read.encoding, "windows-1252");
    EXPECT_EQ(e.read.times, TimeColumns::Left);
    EXPECT_EQ(e.read.unitNames.at("kpa"), "kPa");
    EXPECT_EQ(e.raster, (Raster{Raster::Kind::Channel, {"w", {"", 2, false}}, 0}));
    EXPECT_EQ(e.inputs.at("u").group, (GroupName{"Messung", 0, true}));
    EXPECT_EQ(e.outputs.at("y").group, (GroupName{"", 3, false}));
    const std::string text = studyJson(*study);
    EXPECT_THAT(text, HasSubstr("\"sheet\": \"Messung\""));
    const Outcome<Study> again = parseStudyJson(std::make_shared<const Source>("study.json", text));
    ASSERT_TRUE(again) << format(again.diagnostics());
    EXPECT_EQ(studyJson(*again), text);
    EXPECT_EQ(again->experiments[0].read, e.read);
    EXPECT_EQ(again->experiments[0].raster, e.raster);
    EXPECT_EQ(again->experiments[0].inputs, e.inputs);
    const Outcome<Study> steps = withExperiment(R"("time": "t", "raster": 0.01, )" + std::string(mapped));
    ASSERT_TRUE(steps);
    EXPECT_THAT(studyJson(*steps), HasSubstr("\"raster\": 0.01"));
    const Outcome<Study> usual = withExperiment(R"("time": "t", "raster": "outputs", )" + std::string(mapped));
    ASSERT_TRUE(usual);
    EXPECT_EQ(usual->experiments[0].raster, Raster{});
}

TEST(RecordedStudy, KeepsMembersThatItDoesNotKnowOfEachOfThese) {
    const Outcome<Study> study = withExperiment(R"("time": {"column": "t", "note": 1}, "read": {"comment": "#"},
        "raster": {"column": "w", "why": "fast"}, )" +
                                                std::string(mapped));
    ASSERT_TRUE(study);
    EXPECT_EQ(study.diagnostics().size(), 3u);
    const std::string text = studyJson(*study);
    for (const char* const kept : {"\"note\": 1", "\"comment\": \"#\"", "\"why\": \"fast\""})
        EXPECT_THAT(text, HasSubstr(kept));
}

TEST(RecordedStudy, SaysWhereSomethingElseWasExpected) {
    const std::pair<const char*, const char*> wrong[] = {
        {R"("read": {"separator": "::"})", "experiments/0/read/separator: expected , ; | a tab (\\t) or a blank"},
        {R"("read": {"decimal": ";"})", "experiments/0/read/decimal: expected . or ,"},
        {R"("read": {"decimal": ",", "separator": ","})", "one mark cannot be that of the decimals and another one"},
        {R"("read": {"skip": -1})", "experiments/0/read/skip: expected a number of lines"},
        {R"("read": {"units": "yes"})", "experiments/0/read/units: expected true or false"},
        {R"("read": ";")", "experiments/0/read: expected how the text is written"},
        {R"("raster": 0)", "experiments/0/raster: the step of a raster must be above 0 s"},
        {R"("raster": true)", "experiments/0/raster: expected \"outputs\", the name of a channel"},
        {R"("raster": {"column": "a", "group": 0})", "expected the name of a group or its number"},
        {R"("raster": {"column": "a", "group": 1, "sheet": 1})", "are the same thing"}};
    for (const auto& [members, message] : wrong) {
        const Outcome<Study> study = withExperiment(std::string(members) + R"(, "time": "t", )" + mapped);
        ASSERT_FALSE(study) << members;
        EXPECT_THAT(study.diagnostics()[0].message.english(), HasSubstr(message)) << members;
    }
}

class RecordedFiles : public test::StudyTest {
protected:
    void putStudy(const std::string& experiment) const {
        putHeater();
        put("study.json", R"({"format": "analogon-study-1", "class": "Heater", "experiments": [{"name": "run",
            "role": "fit", )" +
                              experiment + R"(}], "parameters": {"R": {"fit": true, "min": 0.1, "max": 20}}})");
    }
    Recording recording() const {
        const Outcome<EstimationTask> task = estimationTask(read());
        EXPECT_TRUE(task.hasValue()) << format(task.diagnostics());
        return task ? task->recordings.all().at(0) : Recording{};
    }
    void putThreeRasters() const {
        putMdf(directory_ / "run.mf4",
               {{"1 s", {{"t_1", "s", {0, 1, 2, 3}}, {"i", "mA", {0, 100, 200, 300}}}},
                {"500 ms",
                 {{"t_05", "s", {0, 0.5, 1, 1.5, 2, 2.5, 3}}, {"u", "mV", {0, 500, 1000, 1500, 2000, 2500, 3000}}}},
                {"events", {{"t_e", "s", {0, 1.25}}, {"T_air", "degC", {20, 30}}, {"mode", "", {0, 1}, true}}}});
    }
};

TEST_F(RecordedFiles, AnMdfFileWithThreeRastersIsARecording) {
    putThreeRasters();
    putStudy(R"("file": "run.mf4", "time": "t_1", "inputs": {"u": "u", "T_amb": {"column": "T_air",
        "interpolation": "hold"}}, "outputs": {"i": "i"})");
    const Recording r = recording();
    EXPECT_THAT(r.time, ElementsAre(0, 1, 1.25, 2, 3));
    EXPECT_THAT(r.inputs.row(0), Pointwise(DoubleNear(1e-12), {0.0, 1.0, 1.25, 2.0, 3.0}));
    EXPECT_THAT(r.inputs.row(1), Pointwise(DoubleNear(1e-9), {293.15, 293.15, 303.15, 303.15, 303.15}));
    EXPECT_THAT(r.held, ElementsAre("T_amb"));
    EXPECT_NEAR(r.outputs(0, 1), 0.1, 1e-12);
    EXPECT_THAT(r.outputs(0, 2), IsNan());
    ASSERT_EQ(r.spares.size(), 1u);
    EXPECT_EQ(r.spares[0].name, "mode");
    EXPECT_THAT(r.spares[0].values, ElementsAre(0, 0, 1, 1, 1));
}

TEST_F(RecordedFiles, TheTimeIsThatOfTheFileWhereTheStudyNamesNone) {
    putThreeRasters();
    const std::string channels = R"("inputs": {"u": "u", "T_amb": {"column": "T_air", "interpolation": "hold"}},
        "outputs": {"i": "i"})";
    putStudy(R"("file": "run.mf4", )" + channels);
    EXPECT_THAT(recording().time, ElementsAre(0, 1, 1.25, 2, 3));
    EXPECT_EQ(read().experiments[0].timeColumn, "t_1");  // of the group of its output
    EXPECT_THAT(studyJson(read()), Not(HasSubstr("\"time\"")));
    put("run.csv", "u [mV],Zeit [ms],T_air [degC],i [mA]\n0,0,20,0\n500,500,20,167\n1000,1000,21,333\n");
    putStudy(R"("file": "run.csv", )" + channels);
    EXPECT_THAT(recording().time, ElementsAre(0, 0.5, 1));
    put("run.csv", "u [mV],T_air [degC],i [mA]\n0,20,0\n500,20,167\n1000,21,333\n");
    EXPECT_THAT(format(estimationTask(read()).diagnostics()), HasSubstr("tells which column is the time"));
}

TEST_F(RecordedFiles, AStateIsHeldUnlessTheStudyAsksForLines) {
    putThreeRasters();
    putStudy(R"("file": "run.mf4", "time": "t_1", "inputs": {"u": "mode", "T_amb": {"column": "T_air",
        "interpolation": "hold"}}, "outputs": {"i": "i"})");
    EXPECT_THAT(recording().held, ElementsAre("u", "T_amb"));
    change("\"mode\"", R"({"column": "mode", "interpolation": "linear"})");
    EXPECT_THAT(recording().held, ElementsAre("T_amb"));
}

TEST_F(RecordedFiles, ARangeCutsTheCommonRaster) {
    putThreeRasters();
    putStudy(R"("file": "run.mf4", "time": "t_1", "range": [1, 2.5], "inputs": {"u": "u", "T_amb": {"column":
        "T_air", "interpolation": "hold"}}, "outputs": {"i": "i"})");
    EXPECT_THAT(recording().time, ElementsAre(1, 1.25, 2));
}

TEST_F(RecordedFiles, ARasterThatIsNoChannelIsNamedWhereItStands) {
    putThreeRasters();
    putStudy(R"("file": "run.mf4", "time": "t_1", "raster": "uu", "inputs": {"u": "u", "T_amb": {"column": "T_air",
        "interpolation": "hold"}}, "outputs": {"i": "i"})");
    EXPECT_THAT(taskFault().message.english(), HasSubstr("has no column 'uu'"));
    EXPECT_GT(taskFault().place.line, 0);
    change("\"uu\"", "\"u\"");
    EXPECT_THAT(recording().time, ElementsAre(0, 0.5, 1, 1.25, 1.5, 2, 2.5, 3));
}

TEST_F(RecordedFiles, AChannelOfWhichThereAreTwoIsAskedFor) {
    putMdf(directory_ / "run.mf4",
           {{"ECU", {{"t", "s", {0, 1}}, {"u", "V", {1, 2}}, {"T", "K", {300, 300}}, {"i", "A", {1, 2}}}},
            {"bench", {{"t", "s", {0, 1}}, {"u", "V", {3, 4}}}}});
    putStudy(R"("file": "run.mf4", "time": "t", "inputs": {"u": "u", "T_amb": "T"}, "outputs": {"i": "i"})");
    const Diagnostic asked = taskFault();
    EXPECT_THAT(asked.message.english(), HasSubstr("'run.mf4' has 2 channels 'u'"));
    EXPECT_THAT(asked.hint.english(), HasSubstr("one of 'ECU' and 'bench'"));
    EXPECT_GT(asked.place.line, 0);
    change(R"("u": "u")", R"("u": {"column": "u", "group": "bench"})");
    EXPECT_THAT(recording().inputs.row(0), ElementsAre(3, 4));
    EXPECT_EQ(recording().spares.at(0).name, "u (ECU)");
    change(R"("group": "bench")", R"("group": 1)");
    EXPECT_THAT(recording().inputs.row(0), ElementsAre(1, 2));
    change(R"("group": 1)", R"("group": "CAN")");
    EXPECT_THAT(taskFault().message.english(), HasSubstr("no channel 'u' in this group"));
    EXPECT_THAT(taskFault().hint.english(), HasSubstr("It is in 'ECU' and 'bench'."));
}

TEST_F(RecordedFiles, AStartValueIsTakenFromTheGroupThatIsNamed) {
    putMdf(directory_ / "run.mf4",
           {{"ECU", {{"t", "s", {0, 1}}, {"u", "V", {1, 2}}, {"T", "K", {300, 300}}, {"i", "A", {1, 2}}}},
            {"bench", {{"t", "s", {0, 1}}, {"T", "K", {310, 310}}}}});
    putStudy(R"("file": "run.mf4", "time": "t", "initial": {"T_start": "T"}, "inputs": {"u": "u",
        "T_amb": {"column": "T", "group": "ECU"}}, "outputs": {"i": "i"})");
    const auto start = [this] { return recording().starts.at(0).value; };
    EXPECT_EQ(start(), 300) << "that of the column that is mapped";
    change(R"("T_start": "T")", R"("T_start": {"column": "T", "group": "bench"})");
    EXPECT_EQ(start(), 310);
    EXPECT_THAT(studyJson(read()), HasSubstr("\"group\": \"bench\""));
}

TEST_F(RecordedFiles, TheSpareOfOneGroupIsMappedByItsGroup) {
    putMdf(directory_ / "run.mf4",
           {{"ECU", {{"t", "s", {0, 1}}, {"u", "V", {1, 2}}, {"T", "K", {300, 300}}, {"i", "A", {1, 2}}}},
            {"bench", {{"t", "s", {0, 1}}, {"u", "V", {3, 4}}}}});
    putStudy(R"("file": "run.mf4", "time": "t", "inputs": {"u": {"column": "u", "group": "bench"}, "T_amb": "T"},
        "outputs": {"i": "i"})");
    const Study study = read();
    const std::shared_ptr<const Table> file = fileTable(study.tables, study.experiments[0]);
    ASSERT_TRUE(file);
    EXPECT_EQ(channelOf(*file, "u (ECU)"), (ChannelName{"u", {"ECU", 0, false}}));
}

TEST_F(RecordedFiles, WhatIsToldOfATextIsTakenForIt) {
    put("run.txt", "# bench 3\ntime;u;T;i\n0;1,5;300;0,5\n1;2,5;300;1,5\n");
    putStudy(R"("file": "run.txt", "time": "time", "read": {"separator": ";", "decimal": ",", "skip": 1},
        "inputs": {"u": "u", "T_amb": {"column": "T", "unit": "K"}}, "outputs": {"i": "i"})");
    EXPECT_THAT(recording().inputs.row(0), ElementsAre(1.5, 2.5));
    const Study study = read();
    EXPECT_FALSE(study.tables.contains("run.txt"));
    EXPECT_TRUE(fileTable(study.tables, study.experiments[0]));
}

TEST_F(RecordedFiles, TwoExperimentsMayReadOneFileInTwoWays) {
    put("run.csv", "t,u,T,i\n0,1,300,1\n1,2,300,2\n2,3,300,3\n");
    putHeater();
    const std::string channels = R"("inputs": {"u": "u", "T_amb": {"column": "T", "unit": "K"}},
        "outputs": {"i": "i"})";
    put("study.json", R"({"format": "analogon-study-1", "class": "Heater", "experiments": [
        {"name": "a", "role": "fit", "file": "run.csv", "time": "t", )" +
                          channels +
                          R"(}, {"name": "b", "role": "validate", "file": "run.csv", "time": "t",
        "read": {"encoding": "iso-8859-1"}, )" +
                          channels + R"(}], "parameters": {"R": {"fit": true, "min": 0.1, "max": 20}}})");
    const Study study = read();
    EXPECT_EQ(study.tables.size(), 2u);
    const Outcome<EstimationTask> task = estimationTask(study);
    ASSERT_TRUE(task) << format(task.diagnostics());
    EXPECT_EQ(task->recordings[0].time, task->recordings[1].time);
    const Outcome<Done> written = writeStudy(study, directory_ / "copy");
    ASSERT_TRUE(written) << format(written.diagnostics());
    EXPECT_TRUE(readStudy(directory_ / "copy"));
}

TEST_F(RecordedFiles, ATimeOfWordsIsToldHowToBeRead) {
    put("run.csv", "when,u,T,i\nfirst,1,300,1\nsecond,2,300,2\nthird,3,300,3\n");
    putStudy(R"("file": "run.csv", "time": "when", "inputs": {"u": "u", "T_amb": {"column": "T", "unit": "K"}},
        "outputs": {"i": "i"})");
    EXPECT_THAT(taskFault().hint.english(), HasSubstr("\"read\": {\"time_format\":"));
}

TEST_F(RecordedFiles, EmptyCellsOfAnInputAreBridgedWhereTheStudySaysHow) {
    put("run.csv", "t,u,T,i\n0,1,300,1\n1,,300,1\n2,3,300,3\n");
    putStudy(R"("file": "run.csv", "time": "t", "inputs": {"u": "u", "T_amb": {"column": "T", "unit": "K"}},
        "outputs": {"i": "i"})");
    EXPECT_THAT(taskFault().hint.english(), HasSubstr("\"interpolation\": \"hold\" or \"linear\""));
    change(R"("u": "u")", R"("u": {"column": "u", "interpolation": "hold"})");
    EXPECT_THAT(recording().inputs.row(0), ElementsAre(1, 1, 3));
    change(R"("hold")", R"("linear")");
    EXPECT_THAT(recording().inputs.row(0), ElementsAre(1, 2, 3));
}

TEST_F(RecordedFiles, ToldReadingOfABinaryFileIsSaidToHaveNoEffect) {
    putThreeRasters();
    putStudy(R"("file": "run.mf4", "time": "t_1", "read": {"decimal": ","}, "inputs": {"u": "u", "T_amb": {"column":
        "T_air", "interpolation": "hold"}}, "outputs": {"i": "i"})");
    const Outcome<Study> study = readStudy(directory_);
    ASSERT_TRUE(study);
    ASSERT_EQ(study.diagnostics().size(), 1u);
    EXPECT_THAT(study.diagnostics()[0].message.english(), HasSubstr("it has no effect"));
}

/// A shaft on which dry friction is missing in the model: J*der(w) = u - 0.05*sign(w), J = 0.02.
class RecordedShaft : public test::StudyTest {
protected:
    static constexpr int count = 1201;
    static constexpr double interval = 0.02;

    void SetUp() override {
        StudyTest::SetUp();
        put("model.mo", R"(model Drive
  Analogon.Interfaces.RealInput u(unit="N.m");
  Analogon.Interfaces.RealOutput w(unit="rad/s");
  Analogon.Sources.PrescribedTorque drive;
  Analogon.Mechanics.Inertia rotor(J = 0.015);
  Analogon.Sensors.SpeedSensor tacho;
equation
  connect(u, drive.tau);
  connect(drive.flange, rotor.flange_a);
  connect(rotor.flange_b, tacho.flange);
  connect(tacho.w, w);
end Drive;
)");
    }

    /// The speed at each sample; `command`: the torque at a moment.
    template <class Command>
    static std::vector<double> speed(const Command& command) {
        std::mt19937 random(3);
        std::normal_distribution<double> noise(0, 0.05);
        std::vector<double> shown;
        double w = 0;
        for (int k = 0; k < count; ++k) {
            shown.push_back(w + noise(random));
            constexpr int inner = 200;
            for (int i = 0; i < inner; ++i) {
                const double free = w + interval / inner * command(k * interval + (i + 0.5) * interval / inner) / 0.02;
                const double stop = interval / inner * 0.05 / 0.02;  // by which friction slows it down
                w = std::abs(free) < stop ? 0 : free - std::copysign(stop, free);
            }
        }
        return shown;
    }

    void putDrive(const std::string& experiment) const {
        put("study.json", R"({"format": "analogon-study-1", "class": "Drive", "experiments": [{"name": "run",
            "role": "fit", )" +
                              experiment +
                              R"(, "outputs": {"w": "w"}}],
            "parameters": {"rotor.J": {"fit": true, "min": 1e-4, "max": 1}}})");
    }

    Finding discovered() const {
        RunOptions options;
        options.discover.kinds = {"friction.coulomb", "friction.viscous", "drag.quadratic"};
        const Outcome<RunResult> result = runDiscover(read(), options);
        EXPECT_TRUE(result.hasValue()) << format(result.diagnostics());
        return result ? result->finding : Finding{};
    }

    static FitEstimate fitted(const Finding& finding, const std::string& ending) {
        for (const FitEstimate& e : finding.final.parameters)
            if (e.name.ends_with(ending)) return e;
        return {};
    }

    static void expectAlike(const Finding& a, const Finding& b) {
        ASSERT_EQ(a.effects.size(), 1u);
        ASSERT_EQ(b.effects.size(), 1u);
        EXPECT_EQ(a.effects[0].kind, "friction.coulomb");
        EXPECT_EQ(b.effects[0].kind, "friction.coulomb");
        for (const char* const name : {"rotor.J", "tau_c"}) {
            const FitEstimate first = fitted(a, name), second = fitted(b, name);
            ASSERT_GT(first.standardError, 0) << name;
            EXPECT_NEAR(first.value, second.value, 2 * std::hypot(first.standardError, second.standardError)) << name;
        }
        EXPECT_NEAR(fitted(b, "tau_c").value, 0.05, 0.003);
        EXPECT_NEAR(fitted(b, "rotor.J").value, 0.02, 0.0008);
    }
};

double straight(double t) {
    const double levels[] = {0.4, -0.3, 0.3, 0.15, -0.45, 0.2, -0.1, 0.35};
    const int k = static_cast<int>(t / 2.0);
    const double part = t / 2.0 - k;
    return (1 - part) * levels[k % 8] + part * levels[(k + 1) % 8];
}

TEST_F(RecordedShaft, ThreeRastersTellTheSameEffectAsOne) {
    const std::vector<double> w = speed(straight);
    std::vector<double> slow, fast, rare, u, T;
    std::ostringstream csv;
    csv.precision(17);
    csv << "t [s],u [N.m],w [rad/s],T [degC]\n";
    for (int k = 0; k < count; ++k) {
        slow.push_back(k * interval);
        csv << slow.back() << ',' << straight(slow.back()) << ',' << w[static_cast<std::size_t>(k)] << ",20\n";
    }
    for (int k = 0; k <= 2 * (count - 1); ++k) {
        fast.push_back(0.5 * k * interval);
        u.push_back(straight(fast.back()));
    }
    for (int k = 0; k < count; k += 10) {
        rare.push_back(k * interval);
        T.push_back(20);
    }
    put("run.csv", csv.str());
    putMdf(directory_ / "run.mf4", {{"10 ms", {{"t", "s", fast}, {"u", "N.m", u}}},
                                    {"20 ms", {{"t", "s", slow}, {"w", "rad/s", w}}},
                                    {"200 ms", {{"t", "s", rare}, {"T", "degC", T}}}});
    putDrive(R"("file": "run.csv", "time": "t", "inputs": {"u": "u"})");
    const Finding one = discovered();
    putDrive(R"("file": "run.mf4", "time": {"column": "t", "group": "20 ms"}, "inputs": {"u": "u"})");
    expectAlike(one, discovered());
}

double steps(double t) {
    const double levels[] = {0.4, -0.3, 0.3, 0.15, -0.45, 0.2, -0.1, 0.35};
    return levels[static_cast<int>(t / 1.307) % 8];  // on no stamp of the raster
}

TEST_F(RecordedShaft, ACommandThatIsWrittenWhenItChangesTellsTheSameEffect) {
    const std::vector<double> w = speed(steps);
    std::vector<double> stamps, events, u;
    std::ostringstream csv;
    csv.precision(17);
    csv << "t [s],u [N.m],w [rad/s]\n";
    double next = 0;
    for (int k = 0; k < count; ++k) {
        const double t = k * interval;
        for (; next < t || events.empty(); next = 1.307 * static_cast<double>(events.size())) {
            events.push_back(next);
            u.push_back(steps(next + 1e-6));
            if (events.size() > 1) csv << next << ',' << u.back() << ",\n";
        }
        stamps.push_back(t);
        csv << t << ',' << steps(t) << ',' << w[static_cast<std::size_t>(k)] << '\n';
    }
    put("run.csv", csv.str());
    putMdf(directory_ / "run.mf4",
           {{"events", {{"t", "s", events}, {"u", "N.m", u}}}, {"20 ms", {{"t", "s", stamps}, {"w", "rad/s", w}}}});
    putDrive(R"("file": "run.csv", "time": "t", "inputs": {"u": {"column": "u", "interpolation": "hold"}})");
    const Finding one = discovered();
    putDrive(R"("file": "run.mf4", "time": {"column": "t", "group": "20 ms"},
        "inputs": {"u": {"column": "u", "interpolation": "hold"}})");
    expectAlike(one, discovered());
}

}  // namespace
}  // namespace analogon
