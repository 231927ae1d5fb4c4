// How time and memory grow with the size of the work: the exponents of size, against those of a table.
//   growth TABLE           fails where an exponent is more than 0.15 above that of the table
//   growth --write TABLE   writes the table
#include <fmt/format.h>

#include <Eigen/Core>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/base/memory.hpp"
#include "core/fit/fit.hpp"
#include "tests/bench/speed/growing.hpp"
#include "tests/bench/speed/measuring.hpp"

namespace analogon::speed {
namespace {

constexpr double mostAbove = 0.15;  // the exponent of the table
constexpr double leastMemory = 2;   // [MB]: less is not what the work takes

struct Series {
    std::string name, unit;
    std::vector<int> sizes;
    std::function<FitProblem(int size)> make;
    std::function<void(const FitProblem&)> work;
    bool makesToo;  // what makes the problem is part of the work: from the text of the model to its system
};

struct Growth {
    double time{}, memory{};  // exponents of size
};

void simulateAll(const FitProblem& problem) {
    for (const FitExperiment& experiment : problem.experiments) simulate(taskOf(experiment));
}

std::vector<Series> allSeries() {
    const auto fitAll = [](const FitProblem& problem) {
        FitOptions lean;
        lean.keepsOptimum = false;
        const FitResult result = fit(problem, lean);
        if (result.status != FitStatus::Failed) return;
        fmt::print(stderr, "  the fit failed: {}\n", result.message);
        std::exit(3);
    };
    constexpr int samples = 2001;
    return {
        {"thermal chain, to its first traces",
         "masses",
         {10, 50, 200, 2000},
         [](int n) { return thermalChain(n, false, samples, 0); },
         simulateAll,
         true},
        {"thermal chain, fit of 4 parameters",
         "masses",
         {10, 50, 200, 1000},
         [](int n) { return thermalChain(n, false, samples, 4); },
         fitAll,
         false},
        {"rod in slices, simulate",
         "slices",
         {50, 200, 1000},
         [](int n) { return thermalChain(n, true, samples, 0); },
         simulateAll,
         false},
        {"rod in slices, fit of 4 parameters",
         "slices",
         {50, 200, 1000},
         [](int n) { return thermalChain(n, true, samples, 4); },
         fitAll,
         false},
        {"thermal net without masses, fit of 2 parameters",
         "a side",
         {4, 8, 16},
         [](int n) { return thermalNet(n, samples, 2); },
         fitAll,
         false},
        {"pump, fit", "samples", {10'001, 100'001, 1'000'001}, [](int n) { return pump(n, false); }, fitAll, false},
        {"pump with friction, fit",
         "samples",
         {10'001, 100'001, 300'001},
         [](int n) { return pump(n, true); },
         fitAll,
         false},
        {"pump, fit of several recordings",
         "recordings",
         {1, 10, 50},
         [](int n) { return pumpRecordings(n, samples); },
         fitAll,
         false},
    };
}

/// The slope of a line through the logarithms.
double exponentOf(const std::vector<int>& sizes, const std::vector<double>& figures) {
    const auto count = static_cast<Eigen::Index>(sizes.size());
    Eigen::VectorXd x(count), y(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        x[i] = std::log(sizes[static_cast<std::size_t>(i)]);
        y[i] = std::log(figures[static_cast<std::size_t>(i)]);
    }
    x.array() -= x.mean();
    return x.dot(y) / x.squaredNorm();
}

Growth measure(const Series& series) {
    constexpr double budget = 0.3;  // [s] of repeats
    fmt::print("{}\n", series.name);
    std::vector<double> times, memories;
    for (const int size : series.sizes) {
        const FitProblem problem = series.make(size);
        const auto work = [&] { series.makesToo ? series.work(series.make(size)) : series.work(problem); };
        memories.push_back(std::max(leastMemory, peakMemory(work)));
        times.push_back(timed(budget, work));
        fmt::print("  {:>8} {:<11} {:10.1f} ms {:8.1f} MB\n", size, series.unit, 1e3 * times.back(), memories.back());
        std::fflush(stdout);
    }
    return {exponentOf(series.sizes, times), exponentOf(series.sizes, memories)};
}

/// Lines "time memory name".
std::map<std::string, Growth> readTable(const char* file) {
    std::map<std::string, Growth> table;
    std::ifstream in(file);
    Growth growth;
    for (std::string name; in >> growth.time >> growth.memory && std::getline(in >> std::ws, name);)
        table[name] = growth;
    return table;
}

int run(const char* file, bool writes) {
    const std::map<std::string, Growth> table = readTable(file);
    std::string text;
    int failures = 0;
    for (const Series& series : allSeries()) {
        const Growth growth = measure(series);
        fmt::print("  grows with exponent {:.2f} of the size, memory with {:.2f}", growth.time, growth.memory);
        text += fmt::format("{:.2f} {:.2f} {}\n", growth.time, growth.memory, series.name);
        const auto stored = table.find(series.name);
        if (writes || stored == table.end()) {
            fmt::print("{}\n\n", writes ? "" : "; the table has no such series");
            failures += writes ? 0 : 1;
            continue;
        }
        const bool isSlower = growth.time > stored->second.time + mostAbove;
        const bool isLarger = growth.memory > stored->second.memory + mostAbove;
        fmt::print("; in the table {:.2f} and {:.2f}{}\n\n", stored->second.time, stored->second.memory,
                   isSlower || isLarger ? ": FAILED" : "");
        failures += isSlower || isLarger ? 1 : 0;
    }
    if (writes) std::ofstream(file) << text;
    return failures > 0 ? 1 : 0;
}

}  // namespace
}  // namespace analogon::speed

int main(int count, char** arguments) {
    const bool writes = count == 3 && std::strcmp(arguments[1], "--write") == 0;
    if (count != 2 && !writes) {
        fmt::print(stderr, "growth [--write] TABLE\n");
        return 2;
    }
    analogon::growHeap();
    return analogon::speed::run(arguments[count - 1], writes);
}
