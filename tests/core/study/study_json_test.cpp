#include "core/study/json_places.hpp"
#include "study_fixture.hpp"

namespace analogon {
namespace {

using ::testing::HasSubstr;

Outcome<Study> parse(const std::string& text) {
    return parseStudyJson(std::make_shared<const Source>("study.json", text));
}

std::string withExperiment(const std::string& members) {
    return "{\"format\": \"analogon-study-1\", \"class\": \"M\", \"experiments\": [\n{\"name\": \"a\", \"role\": "
           "\"fit\", "
           "\"file\": \"a.csv\", \"time\": \"t\"" +
           members + "}]}";
}

Diagnostic faultOf(const std::string& text) {
    const Outcome<Study> study = parse(text);
    EXPECT_FALSE(study.hasValue()) << text;
    return study ? Diagnostic{} : study.diagnostics().front();
}

TEST(StudyJson, ReadsEveryMember) {
    const Outcome<Study> study = parse(R"({"format": "analogon-study-1", "class": "M", "library": ["../blocks"],
      "experiments": [{"name": "a", "role": "validate", "file": "a.csv", "time": "t", "range": [1, 2.5],
        "inputs": {"u": {"column": "U", "unit": "mV", "scale": 2, "offset": -1}},
        "outputs": {"y": {"column": "Y", "weight": 0.5}},
        "initial": {"b.T": "fit", "b.w": 3, "b.x": "T_air"}}],
      "parameters": {"b.R": {"fit": false, "value": 2}, "b.k": {"min": 0, "max": 1, "scale": "lin"}}})");
    ASSERT_TRUE(study.hasValue()) << format(study.diagnostics());
    EXPECT_TRUE(study.diagnostics().empty());
    const StudyExperiment& experiment = study->experiments.at(0);
    EXPECT_EQ(experiment.role, Role::Validate);
    EXPECT_EQ(experiment.range->second, 2.5);
    EXPECT_EQ(experiment.inputs.at("u").unit, "mV");
    EXPECT_EQ(experiment.inputs.at("u").scale, 2);
    EXPECT_EQ(experiment.inputs.at("u").offset, -1);
    EXPECT_EQ(experiment.outputs.at("y").weight, 0.5);
    EXPECT_TRUE(std::holds_alternative<FittedStart>(experiment.initial.at("b.T")));
    EXPECT_EQ(std::get<double>(experiment.initial.at("b.w")), 3);
    EXPECT_EQ(std::get<ColumnStart>(experiment.initial.at("b.x")).column, "T_air");
    EXPECT_FALSE(study->parameters.at("b.R").fit);
    EXPECT_EQ(*study->parameters.at("b.R").value, 2);
    EXPECT_TRUE(study->parameters.at("b.k").fit);
    EXPECT_EQ(study->parameters.at("b.k").scale, ParameterScale::Linear);
    EXPECT_EQ(study->libraryPaths.at(0), "../blocks");
}

TEST(StudyJson, WritesWhatItReads) {
    const std::string text = R"({"format": "analogon-study-1", "class": "M", "note": {"by": "x"},
      "experiments": [{"name": "a", "role": "fit", "file": "a.csv", "time": "t", "range": [1, 2], "rig": 4,
        "inputs": {"u": {"column": "U", "unit": "mV", "scale": 0.1}}, "outputs": {"y": "Y"},
        "initial": {"b.T": "fit", "b.w": 3.25, "b.x": "T"}}],
      "parameters": {"b.R": {"fit": true, "min": 1e-12, "max": 20, "scale": "log", "why": "data sheet",
        "prior": {"mean": 3.2, "std": 0.1}}}})";
    const Outcome<Study> first = parse(text);
    ASSERT_TRUE(first.hasValue()) << format(first.diagnostics());
    const std::string written = studyJson(*first);
    const Outcome<Study> second = parse(written);
    ASSERT_TRUE(second.hasValue()) << format(second.diagnostics());
    EXPECT_EQ(studyJson(*second), written);
    EXPECT_EQ(second->experiments[0].inputs.at("u").scale, 0.1);
    EXPECT_EQ(*second->parameters.at("b.R").min, 1e-12);
    EXPECT_EQ(second->parameters.at("b.R").prior, (NormalPrior{3.2, 0.1}));
    for (const char* kept : {"\"note\"", "\"rig\": 4", "\"data sheet\"", "\"y\": \"Y\""})
        EXPECT_THAT(written, HasSubstr(kept));
}

TEST(StudyJson, WarnsOfMembersItDoesNotKnow) {
    const Outcome<Study> study = parse(withExperiment(", \"inital\": {}"));
    ASSERT_TRUE(study.hasValue());
    ASSERT_EQ(study.diagnostics().size(), 1u);
    EXPECT_EQ(study.diagnostics()[0].severity, Severity::Warning);
    EXPECT_EQ(study.diagnostics()[0].hint, "Did you mean \"initial\"?");
    EXPECT_EQ(study.diagnostics()[0].place.line, 2);
}

TEST(StudyJson, PointsAtBrokenJson) {
    const Diagnostic fault = faultOf("{\n  \"format\": \"analogon-study-1\",\n  \"class\" \"M\"\n}\n");
    EXPECT_EQ(fault.place.line, 3);
    EXPECT_GE(fault.place.column, 11);
    EXPECT_THAT(fault.message, HasSubstr("not valid JSON"));
    EXPECT_THAT(faultOf("").message, HasSubstr("not valid JSON"));
    EXPECT_THAT(faultOf("[]").message, HasSubstr("expected an object"));
}

TEST(StudyJson, PointsAtWhatIsNoNumber) {
    const auto withMax = [](const std::string& value) {
        return "{\"format\": \"analogon-study-1\", \"class\": \"1e999\", \"experiments\": [],\n"
               "\"parameters\": {\"R\": {\"max\": " +
               value + "}}}";
    };
    const Diagnostic large = faultOf(withMax("1e999"));
    EXPECT_EQ(large.message, "the number 1e999 is too large");
    EXPECT_EQ(large.place.line, 2) << "not in the text of the line before";
    EXPECT_EQ(large.place.column, 29);
    for (const char* word : {"NaN", "nan", "-Infinity", "Infinity", "True"}) {
        const Diagnostic fault = faultOf(withMax(word));
        EXPECT_EQ(fault.message.english(), "this is not valid JSON: " + std::string(word) + " is no value");
        EXPECT_EQ(fault.place.line, 2) << word;
        EXPECT_EQ(fault.place.column, 29) << word;
    }
}

/// At every level, in the same words, with the name that is near.
TEST(StudyJson, TellsUnknownMembersWhereverTheyStandAndKeepsThem) {
    const std::string text = R"({"format": "analogon-study-1", "class": "M", "paramters": {"x": 1},
      "experiments": [{"name": "a", "role": "fit", "file": "a.csv", "time": "t", "rang": [1, 2],
        "inputs": {"u": {"column": "U", "wieght": 2}},
        "outputs": {"y": {"column": "Y", "by": "hand", "weight": 2}}}],
      "parameters": {"R": {"mim": 0, "prior": {"mean": 1, "std": 2, "sdt": 3}}}})";
    const Outcome<Study> study = parse(text);
    ASSERT_TRUE(study.hasValue()) << format(study.diagnostics());
    const std::vector<std::tuple<std::string, std::string, int>> wanted{
        {"wieght", "weight", 3}, {"by", "", 4},     {"rang", "range", 2},
        {"sdt", "std", 5},       {"mim", "min", 5}, {"paramters", "parameters", 1}};
    ASSERT_EQ(study.diagnostics().size(), wanted.size()) << format(study.diagnostics());
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const auto& [name, meant, line] = wanted[i];
        const Diagnostic& d = study.diagnostics()[i];
        EXPECT_THAT(d.message, HasSubstr("\"" + name + "\" is no member of"));
        EXPECT_EQ(d.hint.english(), meant.empty() ? std::string() : "Did you mean \"" + meant + "\"?");
        EXPECT_EQ(d.place.line, line) << name;
        EXPECT_GT(d.place.column, 0);
    }
    const std::string written = studyJson(*study);
    for (const auto& [name, meant, line] : wanted) EXPECT_THAT(written, HasSubstr("\"" + name + "\"")) << name;
    const Outcome<Study> again = parse(written);
    ASSERT_TRUE(again.hasValue()) << format(again.diagnostics());
    EXPECT_EQ(studyJson(*again), written);
    EXPECT_EQ(again->experiments[0].outputs.at("y").weight, 2);
    // members of what is gone go with it
    Study less = *study;
    less.experiments[0].inputs.clear();
    less.parameters.at("R").prior.reset();
    const std::string rest = studyJson(less);
    EXPECT_EQ(rest.find("wieght"), std::string::npos);
    EXPECT_EQ(rest.find("sdt"), std::string::npos);
}

TEST(StudyJson, SaysWhatAMisspeltRoleOrScaleMayMean) {
    const Diagnostic role = faultOf(
        "{\"format\": \"analogon-study-1\", \"class\": \"M\", \"experiments\": "
        "[{\"name\": \"a\", \"role\": \"Fit\", \"file\": \"a.csv\", \"time\": \"t\"}]}");
    EXPECT_THAT(role.message, HasSubstr("expected \"fit\" or \"validate\", found the text \"Fit\""));
    EXPECT_EQ(role.hint, "Did you mean \"fit\"?");
    const Diagnostic scale = faultOf(
        "{\"format\": \"analogon-study-1\", \"class\": \"M\", \"experiments\": [], "
        "\"parameters\": {\"R\": {\"scale\": \"Log\"}}}");
    EXPECT_EQ(scale.hint, "Did you mean \"log\"?");
}

TEST(StudyJson, NamesMissingMembersAndWrongTypes) {
    EXPECT_THAT(faultOf("{\"format\": \"analogon-study-1\", \"experiments\": []}").message,
                HasSubstr("\"class\" is missing"));
    const Diagnostic type = faultOf(withExperiment(", \"range\": \"all\""));
    EXPECT_EQ(type.message, "experiments/0/range: expected two times [from, to] in seconds, found the text \"all\"");
    EXPECT_EQ(type.place.line, 2);
    EXPECT_THAT(faultOf(withExperiment(", \"inputs\": {\"u\": 3}")).message, HasSubstr("found the number 3"));
    EXPECT_THAT(faultOf(withExperiment(", \"role\": \"fit\"")).message, HasSubstr("given twice"));
    EXPECT_THAT(faultOf(withExperiment(", \"range\": [3, 1]")).message, HasSubstr("before it begins"));
}

/// There has been one version so far: it is what a study without a version is, and every file from now on says it.
TEST(StudyJson, RefusesANewerFormatInWordsAndReadsOneThatDoesNotSay) {
    const auto withFormat = [](const std::string& format) {
        return "{" + format + "\n\"class\": \"M\", \"experiments\": [], \"parameters\": {}}";
    };
    // a newer one may mean something else by everything that follows: one sentence, and no faults of the rest
    const Outcome<Study> newer =
        parse("{\"format\": \"analogon-study-12\",\n\"models\": [\"M\"], \"experiments\": {}}");
    ASSERT_FALSE(newer.hasValue());
    ASSERT_EQ(newer.diagnostics().size(), 1u) << format(newer.diagnostics());
    const Diagnostic& fault = newer.diagnostics().front();
    EXPECT_THAT(fault.message, HasSubstr("newer version of Analogon"));
    EXPECT_THAT(fault.message, HasSubstr("\"analogon-study-12\""));
    EXPECT_THAT(fault.hint, HasSubstr("\"analogon-study-1\""));
    EXPECT_EQ(fault.place.line, 1);
    for (const char* other : {"analogon-study-", "analogon-study-0", "analogon-study-1b", "other-1"})
        EXPECT_THAT(faultOf(withFormat("\"format\": \"" + std::string(other) + "\",")).message,
                    HasSubstr("\"" + std::string(other) + "\" is not known"));
    EXPECT_THAT(faultOf(withFormat("\"format\": 1,")).message, HasSubstr("format: expected a text"));

    const Outcome<Study> first = parse(withFormat("\"format\": \"analogon-study-1\","));
    ASSERT_TRUE(first.hasValue()) << format(first.diagnostics());
    EXPECT_TRUE(first.diagnostics().empty());
    const Outcome<Study> silent = parse(withFormat(""));
    ASSERT_TRUE(silent.hasValue()) << format(silent.diagnostics());
    ASSERT_EQ(silent.diagnostics().size(), 1u);
    EXPECT_EQ(silent.diagnostics().front().severity, Severity::Warning);
    EXPECT_THAT(silent.diagnostics().front().message, HasSubstr("does not say its format"));
    EXPECT_EQ(studyJson(*silent), studyJson(*first));
    EXPECT_THAT(studyJson(*silent), HasSubstr("\"format\": \"analogon-study-1\""));
}

TEST(StudyJson, RefusesBoundsThatCannotBe) {
    const auto withParameter = [](const std::string& text) {
        return "{\"format\": \"analogon-study-1\", \"class\": \"M\", \"experiments\": [],\n\"parameters\": {\"R\": " +
               text + "}}";
    };
    EXPECT_THAT(faultOf(withParameter("{\"min\": 3, \"max\": 1}")).message, HasSubstr("not below the upper bound"));
    EXPECT_THAT(faultOf(withParameter("{\"min\": 0, \"scale\": \"log\"}")).message, HasSubstr("above 0"));
    EXPECT_THAT(faultOf(withParameter("{\"scale\": \"square\"}")).message, HasSubstr("\"lin\" or \"log\""));
    EXPECT_EQ(faultOf(withParameter("{\"fit\": 1}")).place.line, 2);
}

TEST(StudyJson, KeepsTheClockOfAChannel) {
    const std::string text = R"({"format": "analogon-study-1", "class": "M",
      "experiments": [{"name": "a", "role": "fit", "file": "a.csv", "time": "t",
        "inputs": {"u": {"column": "U", "clock": -0.25}}, "outputs": {"y": {"column": "Y", "clock": "fit"}}}],
      "parameters": {"clock y": {"fit": true, "value": 0.03}}})";
    const Outcome<Study> first = parse(text);
    ASSERT_TRUE(first.hasValue()) << format(first.diagnostics());
    const Outcome<Study> study = parse(studyJson(*first));
    ASSERT_TRUE(study.hasValue()) << format(study.diagnostics());
    EXPECT_EQ(study->experiments[0].inputs.at("u").clock, -0.25);
    EXPECT_FALSE(study->experiments[0].inputs.at("u").fitsClock);
    EXPECT_TRUE(study->experiments[0].outputs.at("y").fitsClock);
    EXPECT_EQ(*study->parameters.at("clock y").value, 0.03);
    const Diagnostic wrong = faultOf(std::string(text).replace(text.find("\"fit\"}}"), 5, "\"fi?\""));
    EXPECT_THAT(wrong.message, HasSubstr("expected a number of seconds, or \"fit\""));
    EXPECT_EQ(wrong.place.line, 3);
}

TEST(StudyJson, RefusesAPriorThatIsNone) {
    const auto withPrior = [](const std::string& text) {
        return "{\"format\": \"analogon-study-1\", \"class\": \"M\", \"experiments\": [],\n"
               "\"parameters\": {\"R\": {\"fit\": true,\n\"prior\": " +
               text + "}}}";
    };
    const Diagnostic zero = faultOf(withPrior("{\"mean\": 3, \"std\": 0}"));
    EXPECT_THAT(zero.message, HasSubstr("parameters/R/prior: a standard deviation must be above 0"));
    EXPECT_EQ(zero.place.line, 3);
    EXPECT_FALSE(zero.hint.empty());
    EXPECT_THAT(faultOf(withPrior("{\"mean\": \"3\", \"std\": 1}")).message, HasSubstr("expected a number"));
    EXPECT_THAT(faultOf(withPrior("{\"mean\": 3}")).message, HasSubstr("the member \"std\" is missing"));
    EXPECT_THAT(faultOf(withPrior("3")).message, HasSubstr("{\"mean\": 3.2, \"std\": 0.1}"));
}

TEST(StudyJson, RefusesTwoExperimentsOfOneName) {
    const std::string one = "{\"name\": \"a\", \"role\": \"fit\", \"file\": \"a.csv\", \"time\": \"t\"}";
    EXPECT_THAT(
        faultOf("{\"format\": \"analogon-study-1\", \"class\": \"M\", \"experiments\": [" + one + ",\n" + one + "]}")
            .message,
        HasSubstr("two experiments named 'a'"));
}

TEST(JsonPlaces, FindsValuesAndNames) {
    const auto source =
        std::make_shared<const Source>("x", "{\"a\": [1, {\"b/c\": \"x,]}\\\"\"}, []], \"d\": {}, \"e\": -1.5e3}");
    const JsonPlaces places(source);
    EXPECT_EQ(places.value("/a/0").text(), "1");
    EXPECT_EQ(places.value("/a/1/b~1c").text(), "\"x,]}\\\"\"");
    EXPECT_EQ(places.name("/a/1/b~1c").text(), "\"b/c\"");
    EXPECT_EQ(places.value("/a/2").text(), "[]");
    EXPECT_EQ(places.value("/d").text(), "{}");
    EXPECT_EQ(places.value("/e").text(), "-1.5e3");
    EXPECT_EQ(places.value("/d/missing").text(), "{}");
    EXPECT_EQ(places.value("").text(), source->text());
    EXPECT_FALSE(places.name("/a/0").valid());
}

/// Programs in C take it for the end of a text: a name that holds one is two names.
TEST(StudyJson, RefusesANulInEveryTextAndName) {
    const std::string sound = R"({"format": "analogon-study-1", "class": "M!", "library": ["lib!.mo"],
  "experiments": [{"name": "a!", "role": "fit", "file": "a.csv!", "time": "t!", "initial": {"b.x!": "T!"},
    "inputs": {"u!": {"column": "U!", "unit": "V"}}, "outputs": {"y!": "Y!"}, "rig": {"own!": "kept!"}}],
  "parameters": {"b.R!": {"fit": true}}})";
    const auto with = [&](std::size_t which) {
        std::string text;
        std::size_t count = 0;
        for (const char c : sound) c != '!' ? text += c : count++ == which ? text += "\\u0000.x" : text;
        return text;
    };
    const auto places = static_cast<std::size_t>(std::count(sound.begin(), sound.end(), '!'));
    ASSERT_TRUE(parse(with(places))) << "without one it is read";
    ASSERT_GE(places, 14u);
    for (std::size_t i = 0; i < places; ++i) {
        const Outcome<Study> study = parse(with(i));
        ASSERT_FALSE(study) << with(i);
        ASSERT_EQ(study.diagnostics().size(), 1u) << format(study.diagnostics());
        const Diagnostic& fault = study.diagnostics().front();
        EXPECT_THAT(fault.message.english(), HasSubstr("a text holds the character U+0000"));
        EXPECT_GT(fault.place.line, 0);
        EXPECT_THAT(fault.place.lineText.substr(static_cast<std::size_t>(fault.place.column - 1),
                                                static_cast<std::size_t>(fault.place.length)),
                    HasSubstr("\\u0000"));
    }
}

TEST(StudyJson, RefusesDeepNestingBeforeParsing) {
    for (const std::size_t depth : {20'000u, 1'000'000u}) {
        const Diagnostic fault = faultOf(std::string(depth, '['));
        EXPECT_THAT(fault.message.english(), HasSubstr("more than 100 deep"));
        EXPECT_EQ(fault.place.column, 101);
        EXPECT_THAT(faultOf("{\"note\": " + std::string(depth, '[') + std::string(depth, ']') + "}").message.english(),
                    HasSubstr("more than 100 deep"));
    }
}

TEST(StudyJson, TellsTheFirstFaultsOfMany) {
    std::string experiments;
    for (int i = 0; i < 1000; ++i) experiments += "{\"name\": 5},";
    const Outcome<Study> study = parse("{\"class\": \"M\", \"experiments\": [" + experiments + "{}]}");
    EXPECT_FALSE(study);
    EXPECT_EQ(study.diagnostics().size(), 50u);
    const std::string text(100'000, 'x');
    EXPECT_LT(format(faultOf("{\"class\": \"M\", \"experiments\": \"" + text + "\"}")).size(), 1500u);
}

}  // namespace
}  // namespace analogon
