#include "core/study/validate.hpp"

#include "core/study/run.hpp"
#include "study_fixture.hpp"

namespace analogon {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class Validate : public analogon::test::StudyTest {
protected:
    Diagnostics said(Purpose purpose = Purpose::Check) const { return validated(read(), purpose).diagnostics(); }
    std::vector<std::string> messages(Purpose purpose = Purpose::Check) const {
        std::vector<std::string> all;
        for (const Diagnostic& d : said(purpose)) all.push_back(d.message.english());
        return all;
    }
    void initial(const std::string& members) const {
        putHeater();
        const std::string outputs = "\"outputs\": {\"i\": \"current\"}";
        change(outputs, outputs + ", \"initial\": {" + members + "}");
    }
    static constexpr const char* fitted = R"("parameters": {
    "R": {"fit": true, "min": 0.1, "max": 20.0},
    "C": {"fit": true, "min": 1, "max": 100, "scale": "log"}
  })";
};

TEST_F(Validate, ColumnsThatNoSignalTakesCostASearchAlone) {
    putHeater();
    for (const Purpose purpose : {Purpose::Check, Purpose::Simulate, Purpose::Fit, Purpose::Discover}) {
        const Outcome<ValidStudy> valid = validated(read(), purpose);
        ASSERT_TRUE(valid) << format(valid.diagnostics());
        EXPECT_EQ(valid->task.recordings.all().at(0).spares.empty(), purpose != Purpose::Discover);
    }
}

/// What a command accepts, the others accept, too.
TEST_F(Validate, ACheckAcceptsWhateverAFitDoes) {
    for (const char* start : {"\"T\": 290", "\"T\": \"fit\"", "\"T.start\": \"T_air\"", "\"T_start\": \"fit\""}) {
        initial(start);
        for (const Purpose purpose : {Purpose::Check, Purpose::Simulate, Purpose::Fit, Purpose::Discover})
            EXPECT_TRUE(validated(read(), purpose)) << start << format(said(purpose));
        EXPECT_TRUE(runSimulate(read(), {})) << start;
    }
    putHeater();
    change("\"i\": \"current\"", "\"i\": {\"column\": \"current\", \"clock\": \"fit\"}");
    EXPECT_TRUE(validated(read(), Purpose::Check)) << format(said());
}

TEST_F(Validate, GivesTheModelAsAFitTakesIt) {
    initial("\"T\": \"fit\"");
    const Outcome<ValidStudy> valid = validated(read(), Purpose::Check);
    ASSERT_TRUE(valid) << format(valid.diagnostics());
    EXPECT_TRUE(valid->model.model->find("T.start").valid());
    EXPECT_GE(valid->model.system->parameterIndex("T.start"), 0);
    EXPECT_GE(valid->model.system->parameterIndex("R"), 0);
}

TEST_F(Validate, AllCommandsSayTheSameFaultsOnceWithTheirPlace) {
    initial("\"T_strt\": 290");
    change("\"u_heater\"", "\"u_heatr\"");
    change("\"C\": {", "\"T_stat\": {");
    const auto wanted = ElementsAre("the model 'Heater' has no parameter 'T_stat'",
                                    "experiment 'warm-up': 'train.csv' has no column 'u_heatr'",
                                    "the model 'Heater' has no parameter and no variable 'T_strt'");
    for (const Purpose purpose : {Purpose::Check, Purpose::Simulate, Purpose::Fit, Purpose::Discover})
        EXPECT_THAT(messages(purpose), wanted);
    for (const Diagnostic& d : said()) {
        EXPECT_EQ(d.place.file, (directory_ / "study.json").string()) << d.message;
        EXPECT_GT(d.place.line, 0);
        EXPECT_GT(d.place.column, 0);
        EXPECT_THAT(d.hint.english(), HasSubstr("Did you mean")) << d.message;
    }
    const Outcome<RunResult> run = runFit(read(), {});
    ASSERT_FALSE(run);
    EXPECT_EQ(format(run.diagnostics()), format(said()));
}

/// One remark on a file, however many experiments read it, and beside a fault, too.
TEST_F(Validate, WhatIsRemarkedOfAFileIsToldOnceForAllItsExperiments) {
    putHeater();
    put("train.csv", "t [ms],u_heater [mV],T_air [degC],current [mA]\n0,0,20,0\n500,1000,-300,333\n1000,1000,21,333\n");
    change("\"experiments\": [",
           "\"experiments\": [{\"name\": \"again\", \"role\": \"validate\", \"file\": \"train.csv\", "
           "\"time\": \"t\", \"inputs\": {\"u\": \"u_heater\", \"T_amb\": \"T_air\"}, "
           "\"outputs\": {\"i\": \"current\"}},");
    const auto isOfTheFile = HasSubstr("below absolute zero");
    EXPECT_THAT(messages(), ElementsAre(isOfTheFile));
    change("\"C\": {", "\"T_stat\": {");
    EXPECT_THAT(messages(), ElementsAre(HasSubstr("no parameter 'T_stat'"), isOfTheFile));
}

TEST_F(Validate, AFitOfNothingIsToldAndASimulationOfItIsNone) {
    putHeater();
    change(fitted, "\"parameters\": {}");
    const std::string wanted = "there is nothing to fit: no parameter and no start value is to be found";
    EXPECT_THAT(messages(Purpose::Check), ElementsAre(wanted));
    EXPECT_THAT(messages(Purpose::Simulate), IsEmpty());
    EXPECT_THAT(messages(Purpose::Discover), ElementsAre(wanted));
    EXPECT_TRUE(validated(read(), Purpose::Discover));
    const Outcome<RunResult> run = runFit(read(), {});
    ASSERT_FALSE(run);
    EXPECT_EQ(run.diagnostics().front().message.english(), wanted);
    EXPECT_GT(run.diagnostics().front().place.line, 0);
    // the start of a recording is something to fit
    initial("\"T\": \"fit\"");
    change(fitted, "\"parameters\": {}");
    EXPECT_THAT(messages(Purpose::Fit), IsEmpty());
}

TEST_F(Validate, WeightsOfZeroAreOneSentence) {
    putHeater();
    change("\"i\": \"current\"", "\"i\": {\"column\": \"current\", \"weight\": 0}");
    EXPECT_TRUE(runSimulate(read(), {})) << "nothing is weighed there";
    EXPECT_TRUE(validated(read(), Purpose::Check));
    EXPECT_THAT(messages(), ElementsAre(HasSubstr("nothing is compared")));
    for (const Outcome<RunResult>& run : {runFit(read(), {}), runDiscover(read(), {})}) {
        ASSERT_FALSE(run);
        ASSERT_EQ(run.diagnostics().size(), 1u);
        EXPECT_EQ(run.diagnostics()[0].place.line, 7);
        EXPECT_THAT(format(run.diagnostics()), Not(HasSubstr("error: error")));
    }
}

TEST_F(Validate, AWeightThatCountsForNothingOrForAllIsAFaultWithItsPlace) {
    for (const char* const weight : {"1e308", "1e-320", "1e9"}) {
        putHeater();
        change("\"i\": \"current\"", std::string("\"i\": {\"column\": \"current\", \"weight\": ") + weight + "}");
        const Outcome<Study> study = readStudy(directory_);
        ASSERT_FALSE(study) << weight;
        EXPECT_THAT(study.diagnostics()[0].message.english(), HasSubstr("is beyond what can be weighed")) << weight;
        EXPECT_EQ(study.diagnostics()[0].place.line, 7) << weight;
    }
    for (const char* const weight : {"1e-6", "0.25", "1e6"}) {
        putHeater();
        change("\"i\": \"current\"", std::string("\"i\": {\"column\": \"current\", \"weight\": ") + weight + "}");
        EXPECT_TRUE(readStudy(directory_)) << weight;
    }
}

TEST_F(Validate, AnInputThatIsHeldInOneRecordingAndNotInAnotherIsToldOnce) {
    putHeater();
    const std::string plain = "\"inputs\": {\"u\": \"u_heater\", \"T_amb\": \"T_air\"}";
    const auto inputs = [](const std::string& interpolation) {
        return "\"inputs\": {\"u\": {\"column\": \"u_heater\"" + interpolation + "}, \"T_amb\": \"T_air\"}";
    };
    const std::string held = inputs(", \"interpolation\": \"hold\"");
    const auto told = [&](const std::string& others) {
        putHeater();
        change(plain, held);
        const std::string first = "\"outputs\": {\"i\": \"current\"}}";
        std::string more = first;
        for (const char* const name : {"drive", "rest"})
            more += std::string(",\n    {\"name\": \"") + name +
                    R"(", "role": "validate", "file": "train.csv", "time": "t",)" + "\n     " + others + ", " + first;
        change(first, more);
    };
    told(plain);
    EXPECT_THAT(messages(), ElementsAre("the input 'u' is held between its samples in 'warm-up' and joined by straight "
                                        "lines in 'drive' and 'rest'"));
    EXPECT_EQ(said()[0].severity, Severity::Warning);
    EXPECT_EQ(said()[0].place.line, 9);
    told(held);
    EXPECT_THAT(messages(), IsEmpty());
    told(inputs(", \"interpolation\": \"linear\""));
    EXPECT_THAT(messages(), IsEmpty()) << "that is asked for";
}

TEST_F(Validate, AStudyWithoutARecordingToFitIsToldToAll) {
    putHeater();
    change("\"role\": \"fit\"", "\"role\": \"validate\"");
    EXPECT_THAT(messages(Purpose::Check), ElementsAre(HasSubstr("no experiment with the role \"fit\"")));
    EXPECT_THAT(messages(Purpose::Simulate), IsEmpty());
    EXPECT_FALSE(validated(read(), Purpose::Fit));
    EXPECT_FALSE(validated(read(), Purpose::Discover));
}

TEST_F(Validate, TheRangeOfTheModelHolds) {
    putHeater();
    std::string text = get(directory_ / "model.mo");
    put("model.mo", text.replace(text.find("min=0) = 3"), 10, "min=0) = -3"));
    const Diagnostics faults = said();
    ASSERT_EQ(faults.size(), 1u) << "that it is outside the bounds of the fit, too, is the same fault";
    EXPECT_EQ(faults[0].message, "the parameter 'R' is -3, below its min 0");
    EXPECT_EQ(faults[0].place.file, (directory_ / "model.mo").string());
    EXPECT_EQ(faults[0].place.line, 6);
    EXPECT_FALSE(runSimulate(read(), {}));
    // a value of the study stands in its place
    change("\"R\": {\"fit\": true,", "\"R\": {\"fit\": true, \"value\": 3,");
    EXPECT_THAT(said(), IsEmpty()) << format(said());

    putHeater();
    change("\"R\": {\"fit\": true,", "\"R\": {\"fit\": false, \"value\": -1,");
    EXPECT_THAT(messages(), ElementsAre("the parameter 'R' is -1, below its min 0"));
    EXPECT_EQ(said()[0].place.line, 10);
    initial("\"R\": -2");
    change("\"R\": {\"fit\": true, \"min\": 0.1, \"max\": 20.0},", "");
    EXPECT_THAT(messages(), ElementsAre("the parameter 'R' is -2, below its min 0"));
    EXPECT_EQ(said()[0].place.line, 7);
}

TEST_F(Validate, ABoundBeyondTheRangeIsTakenBackAndTold) {
    putHeater();
    change("\"min\": 0.1, \"max\": 20.0", "\"min\": -5, \"max\": 20.0");
    const Outcome<ValidStudy> valid = validated(read(), Purpose::Fit);
    ASSERT_TRUE(valid) << format(valid.diagnostics());
    ASSERT_EQ(valid.diagnostics().size(), 1u);
    EXPECT_EQ(valid.diagnostics()[0].severity, Severity::Warning);
    EXPECT_THAT(valid.diagnostics()[0].message, HasSubstr("the lower bound -5 of 'R' lies below the min 0"));
    EXPECT_EQ(valid.diagnostics()[0].place.line, 10);
    for (const FitParameter& p : valid->task.parameters) {
        if (p.name != "R") continue;
        EXPECT_EQ(p.min, 0);
    }
    change("\"min\": -5, \"max\": 20.0", "\"min\": -5, \"max\": -1");
    EXPECT_THAT(messages(), Contains(HasSubstr("'R' has no room between its bounds 0 and -1")));
}

TEST_F(Validate, AParameterHasOneStartOrAnother) {
    initial("\"R\": 2");
    EXPECT_THAT(messages(), ElementsAre(HasSubstr("R is fitted for all experiments and has a start of its own here")));
    EXPECT_EQ(said()[0].place.line, 7);
}

/// Their squares are no numbers of a computer: a fit ended with "the sensitivities are not finite", or with the start
/// values for a result.
TEST_F(Validate, SignalsOfASizeThatNothingHasAreTold) {
    const auto fault = [&](const char* size) {
        putHeater();
        std::string rows = "t [ms],u_heater [mV],T_air [degC],current [mA],flow [l/min],broken\n";
        for (int i = 0; i < 4; ++i)
            rows += std::to_string(500 * i) + "," + std::to_string(i) + "000,20," + std::to_string(i) + size + ",1,1\n";
        put("train.csv", rows);
        EXPECT_TRUE(validated(read(), Purpose::Simulate));
        EXPECT_TRUE(validated(read(), Purpose::Check)) << "told, and no hindrance";
        return said();
    };
    EXPECT_THAT(fault("e45"), IsEmpty());
    EXPECT_THAT(fault("e-45"), IsEmpty());
    const Diagnostics large = fault("e60"), small = fault("e-300");
    ASSERT_EQ(large.size(), 1u);
    EXPECT_EQ(large[0].message, "experiment 'warm-up': 'i' is up to 3e+57 in size, too large to be fitted with");
    EXPECT_THAT(large[0].hint.english(), HasSubstr("correct the column"));
    EXPECT_EQ(large[0].place.line, 7);
    ASSERT_EQ(small.size(), 1u);
    EXPECT_EQ(small[0].message, "experiment 'warm-up': 'i' is at most 3e-303 in size, too small to be fitted with");
    EXPECT_THAT(small[0].hint.english(), HasSubstr("write 0"));
    for (const Outcome<RunResult>& run : {runFit(read(), {}), runDiscover(read(), {})}) {
        ASSERT_FALSE(run);
        EXPECT_EQ(run.diagnostics().front().message, small[0].message);
    }
}

TEST_F(Validate, TwoOutputsOfOneColumnAreRemarked) {
    putHeater();
    change("\"i\": \"current\"", "\"i\": \"current\", \"T_out\": {\"column\": \"current\", \"unit\": \"K\"}");
    EXPECT_THAT(messages(),
                ElementsAre("experiment 'warm-up': the outputs 'T_out' and 'i' are both compared with the column "
                            "'current'"));
    EXPECT_TRUE(validated(read(), Purpose::Fit));
}

TEST_F(Validate, AUnitThatIsNotKnownIsNeverAnsweredWithTheModels) {
    putHeater();
    change("\"u\": \"u_heater\"", "\"u\": {\"column\": \"u_heater\", \"unit\": \"blorb\"}");
    const Diagnostics faults = said();
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_THAT(faults[0].hint.english(), Not(HasSubstr("'V'")));
    EXPECT_EQ(faults[0].place.line, 6);
    change("blorb", "mVv");
    EXPECT_EQ(said().at(0).hint, "Did you mean 'mV'?");
}

TEST_F(Validate, ManyFaultsAreToldAtOnceBeforeWhatIsOnlyRemarked) {
    putHeater();
    change("\"min\": 0.1, \"max\": 20.0", "\"min\": -5, \"max\": 20.0");
    change("{\"i\": \"current\"}", "{\"j\": \"current\"}");
    const Diagnostics all = said();
    ASSERT_EQ(all.size(), 2u);
    EXPECT_EQ(all[0].severity, Severity::Error);
    EXPECT_EQ(all[1].severity, Severity::Warning);
}

}  // namespace
}  // namespace analogon
