#include "app/analogon-cli/command_line.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "app/analogon-cli/progress_view.hpp"
#include "tests/app/command_process.hpp"

namespace analogon::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST_F(CommandLine, TakesNoOtherLibraryForTheOneThatIsTold) {
    setenv("ANALOGON_LIBRARY", "/no/such/folder", 1);
    const Result checked = run({"check", study(lag).string()});
    unsetenv("ANALOGON_LIBRARY");
    EXPECT_NE(checked.status, done);
    EXPECT_THAT(checked.err, HasSubstr("there is no block library at /no/such/folder/Analogon"));
}

TEST_F(CommandLine, SaysItsVersionAndItsCommands) {
    EXPECT_THAT(run({"--version"}).out, HasSubstr("analogon-cli "));
    const Result help = run({"--help"});
    EXPECT_EQ(help.status, done);
    for (const char* command : {"check", "simulate", "fit", "discover", "generate", "export", "pack", "unpack"})
        EXPECT_THAT(help.out, HasSubstr(command));
}

TEST_F(CommandLine, RefusesWhatItDoesNotKnow) {
    EXPECT_EQ(run({}).status, inputAtFault);
    EXPECT_EQ(run({"dance"}).status, inputAtFault);
    EXPECT_EQ(run({"fit", study(lag).string()}).status, inputAtFault) << "--out is missing";
    EXPECT_EQ(run({"fit", study(lag).string(), "--out", "x", "--method", "guess"}).status, inputAtFault);
    EXPECT_EQ(run({"pack", "a", "b"}).status, inputAtFault);
    EXPECT_EQ(run({"export", "nowhere", "--fmu", "b"}).status, inputAtFault);
}

TEST_F(CommandLine, ChecksAStudyAndAModel) {
    const fs::path directory = study(lag);
    const Result checked = run({"check", directory.string()});
    EXPECT_EQ(checked.status, done) << checked.err;
    EXPECT_THAT(checked.out, HasSubstr("as many equations as unknowns"));
    EXPECT_THAT(checked.out, HasSubstr("states      1  y"));
    EXPECT_EQ(run({"check", (directory / "model.mo").string()}).status, done);
    EXPECT_THAT(run({"check", directory.string(), "--print", "flat"}).out, HasSubstr("der(y)"));
    EXPECT_FALSE(run({"check", directory.string(), "--print", "structure"}).out.empty());
    EXPECT_FALSE(run({"check", directory.string(), "--print", "program"}).out.empty());
}

TEST_F(CommandLine, ChecksCountOnlyTheInputsThatAModelDeclares) {
    const fs::path file = scratch / "counter.mo";
    std::ofstream(file) << "model Counter\n  input Real u;\n  discrete Real n(start = 0, fixed = true);\n"
                           "  output Real y;\nequation\n  when {initial(), sample(0, 0.1)} then\n"
                           "    n = pre(n) + u;\n  end when;\n  y = n;\nend Counter;\n";
    const Result checked = run({"check", file.string()});
    EXPECT_EQ(checked.status, done) << checked.err;
    EXPECT_THAT(checked.out, HasSubstr("  inputs      1  u\n")) << "not pre(n), and not when it is sampled";
}

TEST_F(CommandLine, ChecksPrintTheAlgebraicLoops) {
    const fs::path file = scratch / "loop.mo";
    std::ofstream(file) << "model Loop\n  Real x(start = 1), y;\nequation\n  x^2 + y^2 = 2;\n  y = x^3;\nend Loop;\n";
    const Result checked = run({"check", file.string()});
    EXPECT_EQ(checked.status, done) << checked.err;
    EXPECT_THAT(checked.out, HasSubstr("  loop        nonlinear, 2 unknowns, solved for "));
}

TEST_F(CommandLine, ChecksAFileOfAPackageAndAWholePackage) {
    const fs::path package = scratch / "Shop";
    fs::create_directories(package / "Motion");
    const auto put = [&](const char* name, const char* text) { std::ofstream(package / name) << text; };
    put("package.mo", "package Shop\nend Shop;\n");
    put("package.order", "Base\nRotor\nMotion\n");
    put("Base.mo", "within Shop;\npartial model Base\n  parameter Real J = 1;\n  Real w;\nend Base;\n");
    put("Rotor.mo", "within Shop;\nmodel Rotor\n  extends Base;\nequation\n  J*der(w) = -w;\nend Rotor;\n");
    put("Motion/package.mo", "within Shop;\npackage Motion\nend Motion;\n");
    put("Motion/Pair.mo", "within Shop.Motion;\nmodel Pair\n  Rotor a, b;\nend Pair;\n");
    for (const char* name : {"Rotor.mo", "Motion/Pair.mo"}) {
        const Result checked = run({"check", (package / name).string()});
        EXPECT_EQ(checked.status, done) << name << checked.err;
    }
    const Result all = run({"check", package.string() + "/"});
    EXPECT_EQ(all.status, done) << all.err;
    EXPECT_THAT(all.out, HasSubstr("model Shop.Rotor"));
    EXPECT_THAT(all.out, HasSubstr("model Shop.Motion.Pair"));
    EXPECT_THAT(all.out, Not(HasSubstr("Base")));

    put("Rotor.mo", "within Shop;\nmodel Rotor\n  extends Base;\nequation\n  J*der(v) = -w;\nend Rotor;\n");
    const Result faulty = run({"check", package.string()});
    EXPECT_EQ(faulty.status, inputAtFault);
    EXPECT_THAT(faulty.err, HasSubstr("Rotor.mo:5:9: error: 'v' is not declared"));
    const Result unknown = run({"check", (package / "Rotor.mo").string(), "--class", "Shop.Rotr"});
    EXPECT_THAT(unknown.err, HasSubstr("did you mean \"Shop.Rotor\"?"));
}

TEST_F(CommandLine, FitsAndLeavesAllResults) {
    const Result fitted = run({"fit", study(lag).string(), "--out", (scratch / "out").string(), "--progress", "json"});
    EXPECT_EQ(fitted.status, done) << fitted.err;
    for (const char* file : {"report.json", "report.html", "traces.csv", "study/study.json", "study/model.mo"})
        EXPECT_TRUE(fs::exists(scratch / "out" / file)) << file;
    const auto report = nlohmann::json::parse(contentOf(scratch / "out" / "report.json"));
    EXPECT_NEAR(report["final"]["parameters"]["T"]["value"].get<double>(), 1.5, 0.01);
    EXPECT_NEAR(report["final"]["parameters"]["k"]["value"].get<double>(), 2.0, 0.01);
    EXPECT_THAT(fitted.out, HasSubstr("report.html"));
    std::istringstream lines(fitted.err);
    int reports = 0;
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("{")) {
            EXPECT_TRUE(nlohmann::json::parse(line).contains("stage")) << line;
            ++reports;
        }
    EXPECT_GT(reports, 0);
}

TEST_F(CommandLine, SimulatesAndFitsByNelderMeadWithoutProgress) {
    const std::string directory = study(lag).string();
    const Result simulated = run({"simulate", directory, "--out", (scratch / "s").string(), "--progress", "none"});
    EXPECT_EQ(simulated.status, done) << simulated.err;
    const Result fitted = run({"fit", directory, "--out", (scratch / "f").string(), "--method", "nelder-mead"});
    EXPECT_EQ(fitted.status, done) << fitted.err;
    EXPECT_THAT(fitted.err, Not(HasSubstr("\r"))) << "no bar where there is no terminal";
}

TEST_F(CommandLine, GivesTheProfilesThatAreAskedFor) {
    const std::string directory = study(lag).string();
    const fs::path out = scratch / "out";
    const Result fitted = run({"fit", directory, "--out", out.string(), "--profile", "T"});
    ASSERT_EQ(fitted.status, done) << fitted.err;
    EXPECT_THAT(fitted.out, HasSubstr("95 % interval"));
    const auto parameters = nlohmann::json::parse(contentOf(out / "report.json"))["final"]["parameters"];
    const auto& interval = parameters["T"]["interval"];
    EXPECT_LT(interval["lower"], parameters["T"]["value"]);
    EXPECT_GT(interval["upper"], parameters["T"]["value"]);
    EXPECT_EQ(interval["profile"]["values"].size(), interval["profile"]["rises"].size());
    EXPECT_GT(parameters["T"]["std_robust"], 0.0);
    EXPECT_FALSE(parameters["k"].contains("interval"));
    EXPECT_THAT(contentOf(out / "report.html"), HasSubstr("profile of T"));

    const Result unknown = run({"fit", directory, "--out", out.string(), "--profile", "TT"});
    EXPECT_EQ(unknown.status, inputAtFault);
    EXPECT_THAT(unknown.err, HasSubstr("TT is not fitted: it has no profile"));
    EXPECT_THAT(unknown.err, HasSubstr("fitted: T, k"));
}

TEST_F(CommandLine, NamesTheFaultOfTheInputOnceAndWritesNothing) {
    const fs::path out = scratch / "out";
    const auto faulty = [&](const std::string& model, const std::string& data, const std::string& message) {
        const Result result = run({"fit", study(model, data).string(), "--out", out.string()});
        EXPECT_EQ(result.status, inputAtFault) << result.err;
        EXPECT_THAT(result.err, HasSubstr(message));
        std::size_t count = 0;
        for (auto at = result.err.find("error:"); at != std::string::npos; at = result.err.find("error:", at + 1))
            ++count;
        EXPECT_EQ(count, 1u) << result.err;
        EXPECT_FALSE(fs::exists(out)) << "nothing is half-written";
    };
    std::string broken = lag;
    broken.replace(broken.find("k*u"), 3, "q*u");
    faulty(broken, {}, "model.mo:7:");
    faulty(lag, "t [s],u,z\n0,1,0\n1,1,1\n2,1,1\n", "\"y\"");
    faulty(lag, "t [s],u,y [parsec per moon]\n0,1,0\n1,1,1\n2,1,1\n", "parsec per moon");
    faulty(lag, "t [s],u,y\n0,1,0\n1,NaN,1\n2,1,1\n", "step.csv:3");
    EXPECT_EQ(run({"fit", "/no/such/study", "--out", out.string()}).status, inputAtFault);
    EXPECT_FALSE(fs::exists(out));
}

TEST_F(CommandLine, TellsFailedNumericsFromFaultyInput) {
    const std::string exploding = R"(model Lag
  parameter Real T(unit="s") = 1;
  parameter Real k = 1;
  Analogon.Interfaces.RealInput u;
  Analogon.Interfaces.RealOutput y(start=1, fixed=true);
equation
  T*der(y) = k*y*y*u;
end Lag;
)";
    const Result result = run({"simulate", study(exploding).string(), "--out", (scratch / "out").string()});
    EXPECT_EQ(result.status, numericsFailed) << result.err;
    EXPECT_THAT(result.err, HasSubstr("step"));
    EXPECT_THAT(result.err, HasSubstr("t = "));
    EXPECT_FALSE(fs::exists(scratch / "out"));
}

TEST_F(CommandLine, SaysWhereASwitchHoldsTheModelAndWhichUnitsDiffer) {
    const std::string held = R"(model Lag
  parameter Real T(unit="s") = 1;
  parameter Real k = 1;
  Analogon.Interfaces.RealInput u;
  Analogon.Interfaces.RealOutput y(unit="K", start=0, fixed=true);
  Real level(unit="m");
equation
  T*der(y) = if y < 1 then k*u else -k*u;
  level = y;
end Lag;
)";
    const Result result = run({"simulate", study(held).string(), "--out", (scratch / "out").string()});
    EXPECT_EQ(result.status, done) << result.err;
    EXPECT_THAT(result.err, HasSubstr("note: experiment 'step': from t = "));
    EXPECT_THAT(result.err, HasSubstr("a relation of y holds the model between its two sides"));
    EXPECT_THAT(result.err, HasSubstr("warning: "));
    EXPECT_THAT(result.err, HasSubstr("level = y"));
    EXPECT_THAT(contentOf(scratch / "out" / "report.json"), HasSubstr("holds the model between its two sides"));
}

TEST_F(CommandLine, TakesALibraryOfTheUserInEveryCommand) {
    fs::create_directories(scratch / "Own");
    std::ofstream(scratch / "Own" / "package.mo") << "package Own\nend Own;\n";
    std::ofstream(scratch / "Own" / "package.order") << "First\n";
    std::ofstream(scratch / "Own" / "First.mo") << R"(within Own;
model First
  parameter Real T(unit="s") = 1;
  Analogon.Interfaces.RealInput u;
  Analogon.Interfaces.RealOutput y(unit="K", start=0, fixed=true);
equation
  T*der(y) = u - y;
end First;
)";
    const std::string directory = study(R"(model Lag
  parameter Real k = 1;
  parameter Real T(unit="s") = 1;
  Analogon.Interfaces.RealInput u;
  Analogon.Interfaces.RealOutput y(unit="K");
  Own.First first(T=T, u=k*u);
equation
  y = first.y;
end Lag;
)")
                                      .string();
    const std::string library = (scratch / "Own").string();
    EXPECT_EQ(run({"check", directory}).status, inputAtFault);
    for (const char* stage : {"flat", "structure", "program"}) {
        const Result printed = run({"check", directory, "--library", library, "--print", stage});
        EXPECT_EQ(printed.status, done) << printed.err;
        EXPECT_THAT(printed.out, HasSubstr("y")) << stage;
    }
    for (const char* command : {"simulate", "fit", "discover"}) {
        const fs::path out = scratch / command;
        const Result result = run({command, directory, "--library", library, "--out", out.string()});
        EXPECT_EQ(result.status, done) << result.err;
        EXPECT_TRUE(fs::exists(out / "report.json")) << command;
    }
    // The same when the study itself names it.
    const std::string text = contentOf(fs::path(directory) / "study.json");
    std::ofstream(fs::path(directory) / "study.json")
        << R"({"library": ["../Own"],)" << text.substr(text.find('{') + 1);
    const Result checked = run({"check", directory});
    EXPECT_EQ(checked.status, done) << checked.err;
}

TEST_F(CommandLine, ExportsAnFmu) {
    const fs::path file = scratch / "lag.fmu";
    const Result exported = run({"export", study(lag).string(), "--fmu", file.string()});
    EXPECT_EQ(exported.status, done) << exported.err;
    EXPECT_THAT(exported.out, HasSubstr("Co-Simulation and Model Exchange"));
    EXPECT_EQ(contentOf(file).substr(0, 2), "PK");
    EXPECT_EQ(run({"export", study(lag).string(), "--fmu", (scratch / "no" / "lag.fmu").string()}).status,
              inputAtFault);
}

/// study.json with one piece of text replaced.
void change(const fs::path& directory, const std::string& from, const std::string& to) {
    std::string json = contentOf(directory / "study.json");
    const std::size_t at = json.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    std::ofstream(directory / "study.json") << json.replace(at, from.size(), to);
}

std::size_t countOf(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

TEST_F(CommandLine, EveryCommandSaysTheSameOfAStudyOnce) {
    const fs::path directory = study(lag);
    const std::string path = directory.string();
    const std::string remark = "study.json:4:49: warning: \"mxa\" is no member of a parameter";
    change(directory, "\"max\": 10}, \"k\"", "\"mxa\": 10}, \"k\"");
    const std::vector<std::vector<std::string>> commands{
        {"check", path},
        {"simulate", path, "--out", (scratch / "s").string()},
        {"fit", path, "--out", (scratch / "f").string()},
        {"discover", "--kinds", "sensor.lag,sensor.offset", path, "--out", (scratch / "d").string()},
        {"export", path, "--csv", (scratch / "e.csv").string(), "--modelica", (scratch / "e.mo").string()},
        {"pack", path, (scratch / "p.analogon").string()}};
    for (const auto& command : commands) {
        const Result sound = run(command);
        EXPECT_EQ(sound.status, done) << command.front() << sound.err;
        EXPECT_EQ(countOf(sound.err, remark), 1u) << command.front() << "\n" << sound.err;
        EXPECT_EQ(countOf(sound.err, "hint: Did you mean \"max\"?"), 1u) << command.front() << "\n" << sound.err;
    }
    change(directory, "\"outputs\": {\"y\"", "\"outputs\": {\"yy\"");
    const std::string fault = "study.json:3:60: error: experiment 'step': the model 'Lag' has no output 'yy'";
    for (const auto& command : commands) {
        const Result faulty = run(command);
        EXPECT_EQ(faulty.status, command.front() == "pack" ? done : inputAtFault) << "an archive keeps what there is";
        EXPECT_EQ(countOf(faulty.err, fault), 1u) << command.front() << "\n" << faulty.err;
        EXPECT_EQ(countOf(faulty.err, remark), 1u) << command.front() << "\n" << faulty.err;
        EXPECT_EQ(countOf(faulty.err, "error:"), 1u) << command.front() << "\n" << faulty.err;
    }
}

TEST_F(CommandLine, ChecksAStartOfAVariableAndAClockAsAFitTakesThem) {
    for (const char* start : {"0.1", "\"fit\"", "\"y\""}) {
        const fs::path directory = study(lag);
        change(directory, "\"outputs\": {\"y\": \"y\"}",
               std::string("\"initial\": {\"y\": ") + start +
                   "}, \"outputs\": {\"y\": {\"column\": \"y\", \"clock\": \"fit\"}}");
        const Result checked = run({"check", directory.string()});
        EXPECT_EQ(checked.status, done) << start << checked.err;
        const Result fitted = run({"fit", directory.string(), "--out", (scratch / "out").string()});
        EXPECT_EQ(fitted.status, done) << start << fitted.err;
    }
}

TEST_F(CommandLine, RefusesAFitOfNothing) {
    const fs::path directory = study(lag);
    const std::string json = contentOf(directory / "study.json");
    std::ofstream(directory / "study.json") << json.substr(0, json.find("\"parameters\"")) << "\"parameters\": {}}";
    const Result checked = run({"check", directory.string()});
    EXPECT_EQ(checked.status, done);
    EXPECT_THAT(checked.err, HasSubstr("warning: there is nothing to fit"));
    const Result fitted = run({"fit", directory.string(), "--out", (scratch / "out").string()});
    EXPECT_EQ(fitted.status, inputAtFault);
    EXPECT_THAT(fitted.err, HasSubstr("error: there is nothing to fit"));
    EXPECT_EQ(run({"simulate", directory.string(), "--out", (scratch / "out").string()}).status, done);
}

constexpr const char* drive = R"(model Drive
  Analogon.ElectricMechanical.BasicElectricMechanical m;
  Analogon.Mechanics.Inertia rotor;
  Analogon.Mechanics.ViscousLoad load;
  Analogon.Sensors.SpeedSensor sensor;
  Analogon.Interfaces.RealInput u;
  Analogon.Interfaces.RealOutput w;
  Analogon.Interfaces.RealOutput i;
equation
  connect(u, m.v);
  connect(m.flange, rotor.flange_a);
  connect(rotor.flange_b, load.flange);
  connect(rotor.flange_b, sensor.flange);
  connect(sensor.w, w);
  connect(m.i, i);
end Drive;
)";

/// Of a motor without an inductance: R = 0.4, k = 0.12, J = 0.01, b = 0.003.
std::string driveData() {
    constexpr double step = 1e-4;
    constexpr int rows = 300, stepsOfRow = 100;
    const auto voltage = [](double t) { return 6 - 6 * std::cos(3 * t) + 2 * std::sin(11 * t); };
    std::ostringstream csv;
    csv << "t [s],u [V],i [A],w [rad/s]\n";
    double speed = 0;
    for (int row = 0; row < rows; ++row) {
        const double t = 0.01 * row;
        const auto current = [&](double at) { return (voltage(at) - 0.12 * speed) / 0.4; };
        csv << t << ',' << voltage(t) << ',' << current(t) + 0.01 * ((row * 7919) % 13 - 6) / 6 << ','
            << speed + 0.05 * ((row * 104729) % 11 - 5) / 5 << '\n';
        for (int k = 0; k < stepsOfRow; ++k) speed += step * (0.12 * current(t + k * step) - 0.003 * speed) / 0.01;
    }
    return csv.str();
}

std::string driveStudy(const std::string& parameters) {
    return R"({"format": "analogon-study-1", "class": "Drive", "experiments": [{"name": "drive", "role": "fit",
  "file": "step.csv", "time": "t", "inputs": {"u": "u"}, "outputs": {"w": "w", "i": "i"}}], "parameters": {)" +
           parameters + "}}";
}

/// From the values of the library, without a bound: the inductance went to 0, where the model has no solution.
TEST_F(CommandLine, FitsPositiveQuantitiesWithoutBoundsAsTheWindowDoes) {
    const fs::path directory = study(drive, driveData());
    std::ofstream(directory / "study.json") << driveStudy(R"("m.R": {"fit": true}, "m.L": {"fit": true},
        "m.k": {"fit": true}, "rotor.J": {"fit": true}, "load.b": {"fit": true})");
    const Result fitted = run({"fit", directory.string(), "--out", (scratch / "out").string()});
    ASSERT_EQ(fitted.status, done) << fitted.err;
    const char* const remark =
        "no bounds are given for load.b, m.L, m.R, m.k and rotor.J; what is positive is looked for within a factor of "
        "1000 of its start value";
    EXPECT_EQ(countOf(fitted.out + fitted.err, remark), 1u) << fitted.out << fitted.err;
    EXPECT_THAT(run({"check", directory.string()}).err, HasSubstr(remark));
    const std::string text = contentOf(scratch / "out" / "report.json");
    EXPECT_THAT(text, HasSubstr(remark));
    const nlohmann::json report = nlohmann::json::parse(text);
    const auto valueOf = [&](const char* name) { return report["final"]["parameters"][name]["value"].get<double>(); };
    EXPECT_NEAR(valueOf("m.R"), 0.4, 0.01);
    EXPECT_NEAR(valueOf("m.k"), 0.12, 0.01);
    EXPECT_NEAR(valueOf("load.b") / valueOf("rotor.J"), 0.3, 0.01);
    EXPECT_GE(valueOf("m.L"), 1e-6);
    std::ofstream(directory / "study.json") << driveStudy(R"("m.R": {"fit": true, "min": 0.1, "max": 10})");
    EXPECT_THAT(run({"check", directory.string()}).err, Not(HasSubstr("no bounds are given")));
}

TEST_F(CommandLine, HoldsTheRangeOfAParameterInEveryCommand) {
    std::string text = lag;
    text.replace(text.find("T(unit=\"s\") = 1"), 15, "T(unit=\"s\", min=0) = -1");
    const fs::path directory = study(text);
    const std::string out = (scratch / "out").string();
    for (const auto& command : std::vector<std::vector<std::string>>{
             {"check", directory.string()},
             {"check", (directory / "model.mo").string()},
             {"simulate", directory.string(), "--out", out},
             {"fit", directory.string(), "--out", out},
             {"export", directory.string(), "--modelica", (scratch / "e.mo").string()}}) {
        const Result result = run(command);
        EXPECT_EQ(result.status, inputAtFault) << command.front();
        EXPECT_EQ(countOf(result.err, "model.mo:2:39: error: the parameter 'T' is -1, below its min 0"), 1u)
            << command.front() << "\n"
            << result.err;
    }
}

TEST_F(CommandLine, EndsNamesAtTheirCommasAndFindsTheStudyWhereverItStands) {
    const std::string directory = study(lag).string(), out = (scratch / "out").string();
    const Result discovered = run({"discover", "--kinds", "sensor.lag,sensor.offset", directory, "--out", out});
    EXPECT_EQ(discovered.status, done) << discovered.err;
    const Result fitted = run({"fit", "--profile", "T,k", directory, "--out", out});
    EXPECT_EQ(fitted.status, done) << fitted.err;
    const Result twice = run({"fit", "--profile", "T", "--profile", "k", directory, "--out", out});
    EXPECT_EQ(twice.status, done) << twice.err;
    for (const char* name : {"profile of T", "profile of k"})
        EXPECT_THAT(contentOf(fs::path(out) / "report.html"), HasSubstr(name));
    std::ofstream(scratch / "own.mo") << "model Own\nend Own;\n";
    const Result checked = run({"check", "--library", (scratch / "own.mo").string(), directory});
    EXPECT_EQ(checked.status, done) << checked.err;
}

TEST_F(CommandLine, RefusesListsThatLackAName) {
    const std::string directory = study(lag).string();
    const std::vector<std::vector<std::string>> commands{{"discover", directory, "--kinds"},
                                                         {"fit", directory, "--profile"},
                                                         {"generate", "--data", directory + "/step.csv", "--domains"}};
    for (const std::vector<std::string>& command : commands)
        for (const char* list : {",", "", "a,", ",a", "a,,b", " ", "a, ,b"}) {
            std::vector<std::string> arguments = command;
            arguments.insert(arguments.end(), {list, "--out", (scratch / "out").string()});
            const Result result = run(arguments);
            EXPECT_EQ(result.status, inputAtFault) << command.front() << " \"" << list << "\"";
            EXPECT_THAT(result.err, HasSubstr(command.back() + ": a name is missing in \"" + list + "\""));
            EXPECT_FALSE(fs::exists(scratch / "out"));
        }
    const Result swallowing = run({"discover", directory, "--kinds", "--out", (scratch / "out").string()});
    EXPECT_EQ(swallowing.status, inputAtFault);
    EXPECT_THAT(swallowing.err, HasSubstr("--kinds: names are expected, and \"--out\" is another option"));
}

TEST_F(CommandLine, NamesAKindOfEffectThatIsNone) {
    const fs::path out = scratch / "out";
    const Result result = run({"discover", study(lag).string(), "--kinds", "frction.coulomb", "--out", out.string()});
    EXPECT_EQ(result.status, inputAtFault);
    EXPECT_THAT(result.err, HasSubstr("error: there is no kind of effect 'frction.coulomb'"));
    EXPECT_THAT(result.err, HasSubstr("Did you mean 'friction.coulomb'?"));
    EXPECT_FALSE(fs::exists(out));
    EXPECT_EQ(run({"check", study(lag).string(), "--class", "Lag"}).status, inputAtFault) << "it would do nothing";
}

TEST_F(CommandLine, NamesTheArchiveInWhatItRemarks) {
    std::string text = lag;
    const fs::path directory = study(text.replace(text.find("T(unit=\"s\")"), 11, "T(unit=\"s\", min=0)"));
    change(directory, "\"T\": {\"fit\": true, \"min\": 0.1", "\"T\": {\"fit\": true, \"mni\": 3, \"min\": -1");
    const std::string archive = (scratch / "p.analogon").string();
    ASSERT_EQ(run({"pack", directory.string(), archive}).status, done);
    for (const auto& command : std::vector<std::vector<std::string>>{
             {"check", archive}, {"simulate", archive, "--out", (scratch / "out").string()}}) {
        const Result said = run(command);
        EXPECT_EQ(said.status, done) << said.err;
        EXPECT_THAT(said.err, HasSubstr("lies below the min 0 of its declaration"));
        EXPECT_EQ(countOf(said.err, "warning:"), 2u) << said.err;
        EXPECT_EQ(countOf(said.err, "p.analogon"), 2u) << "never where it was unpacked to:\n" << said.err;
    }
}

TEST_F(CommandLine, EndsSoonWhenInterrupted) {
    const fs::path example = root / "examples" / "water-pump";
    ASSERT_TRUE(fs::exists(example / "study.json"));
    const fs::path trace = scratch / "trace.jsonl";
    Process process({"discover", example.string(), "--out", (scratch / "out").string(), "--progress", "json", "--trace",
                     trace.string()},
                    scratch);
    for (int i = 0; i < 2000 && process.err().empty(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    const auto begin = std::chrono::steady_clock::now();
    process.interrupt();
    EXPECT_EQ(process.wait(), interrupted) << process.err();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    EXPECT_LT(took.count(), 2.0) << "0.2 s on a machine that does nothing else";
    EXPECT_THAT(process.err(), HasSubstr("interrupted"));
    EXPECT_EQ(fs::exists(scratch / "out"), fs::exists(scratch / "out" / "report.json")) << "all or nothing";
    EXPECT_TRUE(fs::exists(trace)) << "what was decided so far";
    EXPECT_FALSE(fs::exists(trace.string() + ".writing"));
}

TEST_F(CommandLine, WritesTheDecisionsOfASearch) {
    const fs::path file = scratch / "new" / "trace.jsonl";
    const std::string directory = study(lag).string(), out = (scratch / "out").string();
    const Result found = run({"discover", directory, "--out", out, "--trace", file.string()});
    ASSERT_EQ(found.status, done) << found.err;
    std::ifstream stream(file);
    std::vector<nlohmann::json> decisions;
    for (std::string line; std::getline(stream, line);) decisions.push_back(nlohmann::json::parse(line));
    ASSERT_GT(decisions.size(), 2u);
    for (std::size_t i = 0; i < decisions.size(); ++i) EXPECT_EQ(decisions[i]["number"], i);
    EXPECT_EQ(decisions.front()["step"], "null fit");
    EXPECT_EQ(decisions.back()["step"], "finding");
    const auto report = nlohmann::json::parse(contentOf(scratch / "out" / "report.json"));
    EXPECT_EQ(decisions.back()["verdict"], report["finding"]);

    const Result refused = run({"discover", directory, "--out", out + "2", "--trace", scratch.string()});
    EXPECT_EQ(refused.status, inputAtFault);
    EXPECT_THAT(refused.err, HasSubstr("this is a directory; name a file"));
    EXPECT_FALSE(fs::exists(out + "2")) << "said before the search";
}

TEST_F(CommandLine, GeneratesAStudyThatChecks) {
    const fs::path data = root / "examples" / "lambda-sensor-heating" / "train.csv";
    if (!fs::exists(data)) GTEST_SKIP() << data << " is absent";
    const std::string out = (scratch / "generated").string();
    const Result generated =
        run({"generate", "--domains", "electric-thermal,thermal-fluid", "--data", data.string(), "--out", out});
    ASSERT_EQ(generated.status, done) << generated.err;
    EXPECT_THAT(generated.out, HasSubstr("assumed"));
    const Result checked = run({"check", out});
    EXPECT_EQ(checked.status, done) << checked.err;
    EXPECT_EQ(run({"generate", "--domains", "magic", "--data", data.string(), "--out", out}).status, inputAtFault);
}

TEST(ProgressView, DrawsABarOnATerminalAndNothingElsewhere) {
    std::ostringstream terminal, file;
    {
        ProgressView view(ProgressKind::Automatic, terminal, true);
        view.sink()({"fit", "iteration 3", 0.5, 2.5});
    }
    EXPECT_THAT(terminal.str(), HasSubstr("50 %"));
    EXPECT_THAT(terminal.str(), HasSubstr("fit: iteration 3  (error 2.5 %)"));
    EXPECT_THAT(terminal.str(), testing::EndsWith("\r\033[K")) << "the bar is wiped at the end";
    ProgressView silent(ProgressKind::Automatic, file, false);
    EXPECT_FALSE(silent.sink());
}

TEST(ProgressView, WritesOneJsonObjectALine) {
    EXPECT_EQ(progressJson({"trial", "a \"b\"", 0.25, -1}), R"({"stage":"trial","detail":"a \"b\"","fraction":0.25})");
    EXPECT_EQ(progressJson({"fit", "", -1, 1.5}), R"({"stage":"fit","error_percent":1.5})");
}

/// A study whose model and measurement are right, with another study.json or header.
void putStudy(const fs::path& place, const std::string& json, const std::string& csv) {
    fs::create_directories(place);
    std::ofstream(place / "study.json") << json;
    std::ofstream(place / "train.csv", std::ios::binary) << csv;
    std::ofstream(place / "model.mo")
        << "model M\n  input Real u;\n  output Real y;\n  parameter Real k = 1;\nequation\n"
           "  y = k*u;\nend M;\n";
}

TEST_F(CommandLine, RefusesDeepNestingWithASentence) {
    for (const std::size_t depth : {20'000u, 1'000'000u}) {
        putStudy(scratch / "s", std::string(depth, '['), "t,u,y\n0,1,1\n1,2,2\n");
        for (const char* command : {"check", "fit"}) {
            std::vector<std::string> arguments{command, (scratch / "s").string()};
            if (arguments.front() == "fit") arguments.insert(arguments.end(), {"--out", (scratch / "out").string()});
            const Result result = run(arguments);
            EXPECT_EQ(result.status, 2);
            EXPECT_THAT(result.err, HasSubstr("study.json:1:101: error: objects and lists stand within each other"));
        }
    }
}

TEST_F(CommandLine, EndsWithASentenceWhereMemoryDoes) {
    std::string csv = "t,u,y\n";
    for (int i = 0; i < 400'000; ++i) csv += std::to_string(i) + ",1.5,1.5\n";
    putStudy(scratch / "s",
             R"({"format": "analogon-study-1", "class": "M", "experiments": [{"name": "a", "role": "fit",
                 "file": "train.csv", "time": "t", "inputs": {"u": "u"}, "outputs": {"y": "y"}}],
                 "parameters": {"k": {"fit": true}}})",
             csv);
    setenv("ANALOGON_MEMORY", "70", 1);
    const Result result = run({"fit", (scratch / "s").string(), "--out", (scratch / "out").string()});
    unsetenv("ANALOGON_MEMORY");
    EXPECT_EQ(result.status, 2) << result.err;
    EXPECT_THAT(result.err, HasSubstr("memory"));
    EXPECT_THAT(result.err, HasSubstr("hint: "));
    EXPECT_FALSE(fs::exists(scratch / "out"));
}

TEST_F(CommandLine, WritesNothingThatATerminalObeys) {
    putStudy(scratch / "s",
             R"({"format": "analogon-study-1", "class": "M", "experiments": [{"name": "a\u001b[2Jb", "role": "fit",
                 "file": "train.csv", "time": "t", "inputs": {"u": "u\u001b]0;x\u0007"}, "outputs": {"y": "y"}}]})",
             "t,u\x1b]0;z\x07,y\xc2\x9b"
             "2J\n0,1,1\n1,\x1b[31mx,2\n");
    const auto isPlain = [](const std::string& text) {
        return text.find('\x1b') == std::string::npos && text.find('\x07') == std::string::npos &&
               text.find("\xc2\x9b") == std::string::npos;
    };
    Result result = run({"check", (scratch / "s").string()});
    EXPECT_EQ(result.status, 2);
    EXPECT_TRUE(isPlain(result.err)) << result.err;
    EXPECT_THAT(result.err, HasSubstr("\\u{1b}[31mx"));
    std::ofstream(scratch / "s" / "train.csv", std::ios::binary) << "t,u\x1b]0;z\x07,y\xc2\x9b"
                                                                    "2J\n0,1,1\n1,2,2\n";
    for (const char* command : {"check", "simulate", "fit"}) {
        std::vector<std::string> arguments{command, (scratch / "s").string()};
        if (arguments.front() != "check") arguments.insert(arguments.end(), {"--out", (scratch / "out").string()});
        result = run(arguments);
        EXPECT_TRUE(isPlain(result.out + result.err)) << result.out << result.err;
    }
    result = run({"channels", (scratch / "s" / "train.csv").string()});
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_TRUE(isPlain(result.out + result.err)) << result.out << result.err;
    EXPECT_THAT(result.out, HasSubstr("u\\u{1b}]0;z\\u{7}"));
}

/// The names of a sound study come to the table of results, the report and the lines of progress.
TEST_F(CommandLine, ShowsNamesWithControlCharactersEscapedInResults) {
    std::string csv = "t,u,y\n";
    for (int i = 0; i < 60; ++i)
        csv += std::to_string(i) + "," + std::to_string(i % 7) + "," + std::to_string(2 * (i % 7)) + "\n";
    putStudy(
        scratch / "s",
        R"({"format": "analogon-study-1", "class": "M", "experiments": [{"name": "a\u001b[2J\u202eb", "role": "fit",
                 "file": "train.csv", "time": "t", "inputs": {"u": "u"}, "outputs": {"y": "y"}}],
                 "parameters": {"k": {"fit": true}}})",
        csv);
    const Result result =
        run({"fit", (scratch / "s").string(), "--out", (scratch / "out").string(), "--progress", "json"});
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_THAT(result.out, HasSubstr("a\\u{1b}[2J\\u{202e}b"));
    for (const std::string& text : {result.out, result.err, contentOf(scratch / "out" / "report.html")}) {
        EXPECT_EQ(text.find('\x1b'), std::string::npos);
        EXPECT_EQ(text.find("\xe2\x80\xae"), std::string::npos);
    }
}

}  // namespace
}  // namespace analogon::cli
