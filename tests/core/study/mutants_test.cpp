#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>
#include <cstdlib>
#include <iterator>
#include <random>

#include "core/study/study.hpp"

/// Studies that are nearly one: study.json, model and measurement with bytes and pieces changed at random. Each must
/// end in a task or in messages, soon and within bounds of memory. ANALOGON_MUTANTS sets their number for each kind of
/// file; the long runs take 10 000.
namespace analogon {
namespace {

const std::string soundJson = R"({
  "format": "analogon-study-1", "class": "Heater",
  "experiments": [
    {"name": "warm-up", "role": "fit", "file": "train.csv", "time": "t", "range": [0, 100],
     "inputs": {"u": "u_heater", "T_amb": {"column": "T_air", "unit": "degC", "scale": 1, "offset": 0}},
     "outputs": {"i": {"column": "current", "weight": 1, "clock": 0.1}}, "initial": {"T_start": "T_air"}}],
  "parameters": {"R": {"fit": true, "min": 0.1, "max": 20.0, "prior": {"mean": 3, "std": 1}},
    "C": {"fit": true, "min": 1, "max": 100, "scale": "log"}, "G[1]": {"fit": false, "value": 0.1}}
})";

const std::string soundModel = R"(model Heater "A heated body"
  input Real u(unit="V") "voltage"; input Real T_amb(unit="K"); output Real i(unit="A");
  parameter Real R(unit="Ohm", min=0) = 3; parameter Real C = 10; parameter Real G[2] = {0.1, 0.2};
  parameter Real T_start(unit="K") = 293.15; Real T(unit="K", start=T_start, fixed=true);
equation
  i = u/R; C*der(T) = u*i - sum(G[k]*(T - T_amb) for k in 1:2);
end Heater;
)";

const std::string soundTable =
    "t [ms],u_heater [mV],T_air [degC],current [mA],flow [l/min],\"a \"\"name\"\"\"\n"
    "0,0,20,0,1,1\n500,1000,20,333,2,\n1000,1000,21,333,3,2\n1500,2000,21,667,4,nan\n2e3,2000,-0.5,667,4,1e-300\n";

/// The same text for the same number, on every machine.
std::string mutated(std::string text, unsigned number) {
    static const char* const spices[] = {"[[[[[[[[[[",
                                         "{\"a\":",
                                         "}",
                                         "]",
                                         "\"",
                                         "\\",
                                         ",",
                                         ",,,,,,,",
                                         ":",
                                         "null",
                                         "-1",
                                         "1e999",
                                         "-1e-999",
                                         "0",
                                         "true",
                                         "\x1b",
                                         "\xff",
                                         "\n",
                                         "\r",
                                         ";",
                                         "\t",
                                         "NaN",
                                         "\xef\xbb\xbf",
                                         "[x]",
                                         "(degC)",
                                         "rpm",
                                         "\"\"",
                                         "der(",
                                         "1:1000000",
                                         "u^u^u",
                                         "fill(1, 10, 10)",
                                         "T.T.T",
                                         "#"};
    std::mt19937 random(number);
    const auto pick = [&](std::size_t below) {
        return static_cast<std::size_t>(random() % std::max<std::size_t>(1, below));
    };
    for (std::size_t changes = 1 + pick(3); changes > 0 && !text.empty(); --changes) {
        const std::size_t at = pick(text.size()), length = std::min(pick(20), text.size() - at);
        std::string piece = spices[pick(std::size(spices))];
        if (pick(20) == 0)
            for (int i = 0; i < 12; ++i) piece += piece;  // 4096 times
        switch (pick(5)) {
            case 0:
                text[at] = static_cast<char>(random() & 0xff);
                break;
            case 1:
                text.erase(at, length);
                break;
            case 2:
                text.insert(at, piece);
                break;
            case 3:
                text.insert(pick(text.size()), std::string(text, at, length));
                break;
            default:
                text.replace(at, length, piece);
        }
    }
    return text;
}

/// All that is done before numbers are worked out. Whether a task came of it.
bool goesThrough(const std::string& json, const std::string& model, const std::string& table) {
    Outcome<Study> study = parseStudyJson(std::make_shared<const Source>("study.json", json));
    if (!study) {
        EXPECT_FALSE(format(study.diagnostics()).empty());
        return false;
    }
    study->models["model.mo"] = model;
    Outcome<Table> read = readCsvText(table, "train.csv");
    if (!read) {
        EXPECT_LT(format(read.diagnostics()).size(), 20000u);
        return false;
    }
    const auto shared = std::make_shared<const Table>(std::move(*read));
    for (const StudyExperiment& e : study->experiments) study->tables[e.file] = shared;
    const Outcome<EstimationTask> task = estimationTask(*study);
    EXPECT_EQ(format(task.diagnostics()).find('\x1b'), std::string::npos);
    return task.hasValue();
}

unsigned mutants() {
    const char* const told = std::getenv("ANALOGON_MUTANTS");
    return told ? static_cast<unsigned>(std::strtoul(told, nullptr, 10)) : 150;
}

template <class Make>
void expectAllEnd(const Make& make) {
    ASSERT_TRUE(goesThrough(soundJson, soundModel, soundTable));
    unsigned through = 0, slowestNumber = 0;
    double slowest = 0;
    for (unsigned number = 0; number < mutants(); ++number) {
        SCOPED_TRACE(number);
        const auto begin = std::chrono::steady_clock::now();
        through += make(number);
        const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
        if (spent.count() > slowest) {
            slowest = spent.count();
            slowestNumber = number;
        }
    }
    EXPECT_LT(slowest, 10.0) << "mutant " << slowestNumber;
    EXPECT_LT(through, mutants());
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const double memory = static_cast<double>(usage.ru_maxrss) / 1024;  // [MiB]
    EXPECT_LT(memory, 1024);
    std::printf("%u mutants, %u studies; slowest %.2f s (number %u); %.0f MiB\n", mutants(), through, slowest,
                slowestNumber, memory);
}

TEST(Mutants, OfStudiesEndInATaskOrInMessages) {
    expectAllEnd([](unsigned number) { return goesThrough(mutated(soundJson, number), soundModel, soundTable); });
}

TEST(Mutants, OfModelsEndInATaskOrInMessages) {
    expectAllEnd([](unsigned number) { return goesThrough(soundJson, mutated(soundModel, number), soundTable); });
}

TEST(Mutants, OfMeasurementsEndInATaskOrInMessages) {
    expectAllEnd([](unsigned number) { return goesThrough(soundJson, soundModel, mutated(soundTable, number)); });
}

}  // namespace
}  // namespace analogon
