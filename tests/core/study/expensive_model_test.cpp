#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdlib>
#include <ctime>

#include "core/base/guard.hpp"
#include "core/measure/text/text_recording.hpp"
#include "core/study/run.hpp"
#include "core/study/study.hpp"

/// Short texts that ask for much work: each ends soon, in traces or in a sentence.
namespace analogon {
namespace {

using ::testing::HasSubstr;

/// What a model costs to be read, analysed and simulated: seconds of the processor and what is said.
struct Cost {
    double seconds{};
    std::string words;
};

Study studyOf(const std::string& model, int samples) {
    Outcome<Study> study = parseStudyJson(std::make_shared<const Source>("study.json", R"({
  "format": "analogon-study-1", "class": "M", "parameters": {"a": {"fit": true, "min": 0.1, "max": 1}},
  "experiments": [{"name": "e", "role": "fit", "file": "e.csv", "time": "t", "inputs": {"u": "u"},
                   "outputs": {"y": "y"}}]})"));
    EXPECT_TRUE(study) << format(study.diagnostics());
    study->models["model.mo"] = model;
    study->modelFile = "model.mo";
    std::string rows = "t [s],u [1],y [1]\n";
    for (int k = 0; k < samples; ++k) rows += std::to_string(0.1 * k) + (k % 2 == 0 ? ",0,0\n" : ",1,0.1\n");
    Outcome<Table> table = textTables(rows, "e.csv");
    EXPECT_TRUE(table) << format(table.diagnostics());
    study->tables["e.csv"] = std::make_shared<const Table>(std::move(*table));
    return std::move(*study);
}

Cost costOf(const std::string& declarations, const std::string& equations) {
    const Study study = studyOf(
        "model M input Real u; output Real y; parameter Real a = 0.5; "
        "Real x(start = 0.1, fixed = true);" +
            declarations + " equation der(x) = -a*x + u;" + equations + " end M;",
        4);
    const std::clock_t begin = std::clock();
    Cost cost;
    try {
        const Outcome<RunResult> result = runSimulate(study, {});
        cost.words = format(result.diagnostics());
        if (result) cost.words += result->finding.final.experiments.at(0).failure.reason;
    } catch (const LimitReached& limit) {
        cost.words = format(limit.fault());
    }
    cost.seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    return cost;
}

void expectSoon(const Cost& cost, const std::string& words) {
    EXPECT_LT(cost.seconds, 10);
    if (words.empty())
        EXPECT_EQ(cost.words, "");
    else
        EXPECT_THAT(cost.words, HasSubstr(words));
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    EXPECT_LT(static_cast<double>(usage.ru_maxrss) / 1024, 1024) << "MiB";
}

/// v0 = x, and each of the others by the one before it, "#", to the output.
Cost costOfChain(int length, const std::string& next) {
    std::string declarations = " Real v0;", equations = " v0 = x;";
    for (int i = 1; i < length; ++i) {
        const std::string before = "v" + std::to_string(i - 1);
        std::string right;
        for (const char c : next) right += c == '#' ? before : std::string(1, c);
        declarations += " Real v" + std::to_string(i) + ";";
        equations += " v" + std::to_string(i) + " = " + right + ";";
    }
    return costOf(declarations, equations + " y = v" + std::to_string(length - 1) + ";");
}

/// As many unknowns v as are said, each equation with all of them.
Cost costOfLoop(int unknowns, const std::string& equation) {
    const std::string n = std::to_string(unknowns);
    return costOf(" Real v[" + n + "];", " for i in 1:" + n + " loop " + equation + "; end for; y = v[" + n + "];");
}

std::string sumOf(int unknowns, const std::string& term) {
    return "sum(" + term + " for j in 1:" + std::to_string(unknowns) + ")";
}

TEST(ExpensiveModel, OfLongExpressionsEndsSoon) {
    std::string product = " y = 1", nested = " y = ";
    for (int i = 0; i < 5000; ++i) product += "*(1 + " + std::to_string(i) + "e-9*x)";
    for (int i = 0; i < 2000; ++i) nested += "sin(a*";
    expectSoon(costOf("", product + ";"), "");
    expectSoon(costOf("", nested + "x" + std::string(2000, ')') + ";"), "nested deeper than");
    expectSoon(costOf("", " y = sum(sin(i*a*x) for i in 1:1000000);"), "take more than 4000000 expressions");
}

TEST(ExpensiveModel, OfLongChainsEndsSoon) {
    expectSoon(costOfChain(2000, "sin(a*#)"), "");
    expectSoon(costOfChain(60, "sin(#) + a*#"), "");
    expectSoon(costOfChain(60, "#*# + 10"), "not finite");
    expectSoon(costOfChain(60, "(# + 3)^300"), "not finite");
}

TEST(ExpensiveModel, OfManyScalarsEndsSoon) {
    expectSoon(costOf(" Real s[10000000];", " s = fill(x, 10000000); y = s[1];"), "larger than 1000000 scalars");
    expectSoon(costOf(" Real s[150000];", " s = fill(x, 150000); y = s[1];"), "");
    expectSoon(costOf(" Real s[100000];", " s[1] = x; for i in 2:100000 loop s[i] = s[i - 1]; end for; y = s[100000];"),
               "");
}

TEST(ExpensiveModel, OfALoopOfManyUnknownsEndsSoon) {
    expectSoon(costOfLoop(100, "v[i] + 0.001*" + sumOf(100, "sin(i*j*0.01*v[j])") + " = x"), "");
    expectSoon(costOfLoop(150, "v[i] + 0.001*" + sumOf(150, "(i + a*j)*v[j]") + " = x"), "");
    expectSoon(costOfLoop(250, "v[i] + 0.001*" + sumOf(250, "sin(i*j*0.01*v[j])") + " = x"),
               "250 equations for v[1], v[2] and 248 more must be solved at once, in more than 200");
    expectSoon(costOfLoop(550, "v[i] + 0.001*" + sumOf(550, "(i + a*j)*v[j]") + " = x"),
               "550 equations for v[1], v[2] and 548 more must be solved at once, in more than 500");
    expectSoon(costOfLoop(50000, "v[i]*v[i] + sum(v) = x"), "arrays of the model are too large");
}

/// A mass matrix that is full.
TEST(ExpensiveModel, OfManyCoupledDerivativesEndsSoon) {
    expectSoon(costOf(" Real v[80](each start = 0, each fixed = true);", " for i in 1:80 loop der(v[i]) + 0.001*" +
                                                                             sumOf(80, "(i + a*j)*der(v[j])") +
                                                                             " = x - v[i]; end for; y = v[80];"),
               "");
}

}  // namespace
}  // namespace analogon
