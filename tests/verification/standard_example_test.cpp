#include <cmath>
#include <cstdio>
#include <filesystem>
#include <sstream>

#include "tests/verification/model_runs.hpp"

/// Examples of the Modelica Standard Library rebuilt from blocks, against traces of its reference results.
namespace analogon {
namespace {

using test::compiled;
using test::modelLibrary;
using test::run;

constexpr double tube = 2e-3;  // of a trace's range

struct Reference {
    std::vector<std::string> names;
    std::vector<double> time;
    std::vector<std::vector<double>> values;  // by name
};

/// A trace; of the two rows at an event the later one. Discrete variables of other tools are left out.
Reference readReference(const std::string& file) {
    Reference reference;
    std::ifstream stream(file);
    std::string line, cell;
    std::getline(stream, line);
    std::stringstream header(line);
    while (std::getline(header, cell, ',')) reference.names.push_back(cell.substr(1, cell.size() - 2));
    reference.names.erase(reference.names.begin());
    reference.values.resize(reference.names.size());
    while (std::getline(stream, line)) {
        std::stringstream row(line);
        std::getline(row, cell, ',');
        const double time = std::stod(cell);
        const bool isAgain = !reference.time.empty() && time <= reference.time.back();
        if (!isAgain) reference.time.push_back(time);
        for (std::vector<double>& column : reference.values) {
            std::getline(row, cell, ',');
            if (isAgain) column.pop_back();
            column.push_back(std::stod(cell));
        }
    }
    return reference;
}

bool isDiscrete(const std::string& name) {
    return name.ends_with(".mode") || name.ends_with(".startForward") || name.ends_with(".startBackward");
}

void expectInsideTheTube(const std::string& model, const std::string& file) {
    const std::string path = std::string(ANALOGON_ROOT) + "/../shared/verification/msl/" + file + ".csv";
    if (!std::filesystem::exists(path)) GTEST_SKIP() << "no reference traces";
    const Reference reference = readReference(path);
    const SystemPtr system = compiled(modelLibrary("StandardExamples.mo"), "StandardExamples." + model);
    ASSERT_TRUE(system);
    const Trajectory trajectory = run(*system, reference.time, {}, reference.names);
    ASSERT_FALSE(trajectory.failure.failed) << trajectory.failure.reason << " at " << trajectory.failure.time;
    double largest = 0;
    for (std::size_t i = 0; i < reference.names.size(); ++i) {
        if (isDiscrete(reference.names[i])) continue;
        const auto& y = reference.values[i];
        const auto [low, high] = std::minmax_element(y.begin(), y.end());
        double worst = 0;
        std::size_t worstAt = 0;
        for (std::size_t k = 0; k < y.size(); ++k) {
            const double difference =
                std::fabs(trajectory.observed(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) - y[k]);
            if (difference <= worst) continue;
            worst = difference;
            worstAt = k;
        }
        worst /= *high - *low;
        largest = std::max(largest, worst);
        EXPECT_LT(worst, tube) << reference.names[i] << " at " << reference.time[worstAt];
    }
    std::printf("%-20s %.1e of the range\n", model.c_str(), largest);
}

TEST(StandardExample, TwoMasses) { expectInsideTheTube("TwoMasses", "TwoMasses"); }
TEST(StandardExample, First) { expectInsideTheTube("First", "First"); }
TEST(StandardExample, Damper) { expectInsideTheTube("Damper", "Damper"); }
TEST(StandardExample, Backlash) { expectInsideTheTube("Backlash", "Backlash"); }
TEST(StandardExample, CoupledClutches) { expectInsideTheTube("CoupledClutches", "CoupledClutches"); }
TEST(StandardExample, CauerLowPassAnalog) { expectInsideTheTube("CauerLowPassAnalog", "CauerLowPassAnalog"); }

/// A parameter with fixed = false follows from its initial equation.
TEST(StandardExample, AFreeParameterIsFoundAtTheStart) {
    const SystemPtr system = compiled(modelLibrary("StandardExamples.mo"), "StandardExamples.TwoMasses");
    ASSERT_TRUE(system);
    const Trajectory trajectory = run(*system, {0, 1}, {}, {"T_final"});
    ASSERT_FALSE(trajectory.failure.failed);
    EXPECT_NEAR(trajectory.observed(0, 0), 323.15, 1e-9);
    EXPECT_NEAR(trajectory.observed(0, 1), 323.15, 1e-9);
}

}  // namespace
}  // namespace analogon
