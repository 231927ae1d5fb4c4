#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/fit/fit.hpp"
#include "core/measure/table.hpp"
#include "core/measure/text/text_recording.hpp"
#include "tests/core/simulate/text_models.hpp"

// Fits of differential equations whose optimum is certified to many digits, in the manner of the NIST reference data.

namespace analogon {
namespace {

namespace fs = std::filesystem;

struct Certified {
    nlohmann::json facts;
    FitProblem problem;
};

double number(const nlohmann::json& text) { return std::stod(text.get<std::string>()); }

/// The problem `name` with the starts under `startKey`; `parameters`: names in the model, in the file's order.
std::optional<Certified> certified(const std::string& name, const char* model, const std::string& startKey) {
    const fs::path folder = fs::path(ANALOGON_ROOT) / "../shared/verification/dynfit";
    if (!fs::exists(folder / (name + ".json"))) return std::nullopt;
    Certified result;
    std::ifstream(folder / (name + ".json")) >> result.facts;
    const Outcome<Table> table = readTextTables(folder / (name + ".csv"), {});
    EXPECT_TRUE(table);
    if (!table) return std::nullopt;
    FitExperiment experiment;
    experiment.name = name;
    std::vector<std::string> names = result.facts["parameters"];
    experiment.system = test::compileText(model, "Certified", names);
    experiment.inputs.time = table->columns[0].values;
    const auto count = static_cast<Eigen::Index>(table->rows());
    experiment.inputs.values.resize(0, count);
    experiment.measured = Eigen::Map<const Eigen::RowVectorXd>(table->columns[1].values.data(), count);
    experiment.weights = Eigen::VectorXd::Constant(1, 1.0 / number(result.facts["sigma"][0]));
    experiment.parameters = test::ownParameters(*experiment.system);
    result.problem.experiments.push_back(experiment);
    for (std::size_t i = 0; i < names.size(); ++i) {
        FitParameter p;
        p.name = names[i];
        p.start = number(result.facts[startKey][i]);
        result.problem.parameters.push_back(p);
    }
    return result;
}

void expectCertified(const std::string& name, const char* model, Engine engine) {
    for (const char* start : {"start1", "start2"}) {
        std::optional<Certified> c = certified(name, model, start);
        if (!c) GTEST_SKIP() << "the certified fits (../shared/verification) are not here";
        FitOptions options;
        options.simulation.engine = engine;
        options.simulation.relativeTolerance = 1e-9;
        options.simulation.absoluteTolerance = 1e-12;
        options.costTolerance = 1e-14;
        const FitResult result = fit(c->problem, options);
        EXPECT_EQ(result.status, FitStatus::Converged) << result.message;
        // Certified standard errors are those of the residual's own scatter; ours never fall below the noise.
        const double scatter = std::max(1.0, 1.0 / number(c->facts["residual_sd"]));
        for (std::size_t i = 0; i < result.estimates.size(); ++i) {
            const double expected = number(c->facts["certified"][i]), sd = number(c->facts["certified_sd"][i]);
            EXPECT_NEAR(result.estimates[i].value, expected, 1e-3 * sd)
                << result.estimates[i].name << " from " << start;
            EXPECT_NEAR(result.estimates[i].standardError, sd * scatter, 1e-3 * sd) << result.estimates[i].name;
        }
        EXPECT_NEAR(2.0 * result.cost, number(c->facts["certified_wrss"]), 1e-5);
        EXPECT_NEAR(result.correlation(0, 1), number(c->facts["correlation"][0][1]), 1e-3);
    }
}

const char* const thermal = R"(
model Certified
  output Real y;
  parameter Real R = 1;
  parameter Real C = 1;
  Real T(start = 20, fixed = true);
equation
  C*der(T) = 10 - (T - 20)/R;
  y = T;
end Certified;
)";

const char* const oscillator = R"(
model Certified
  output Real y;
  parameter Real k = 1;
  parameter Real d = 1;
  parameter Real x0 = 1;
  Real x(start = x0, fixed = true);
  Real v(start = 0, fixed = true);
equation
  der(x) = v;
  0.75*der(v) = -k*x - d*v;
  y = x;
end Certified;
)";

const char* const tank = R"(
model Certified
  output Real y;
  parameter Real a = 1;
  parameter Real h0 = 1;
  Real h(start = h0, fixed = true);
equation
  der(h) = if h > 0 then -a*sqrt(max(h, 1e-30)) else 0;
  y = h;
end Certified;
)";

TEST(CertifiedFit, ThermalBody) { expectCertified("thermal1_1000", thermal, Engine::Auto); }
TEST(CertifiedFit, ThermalBodyWithTheAdaptiveEngine) { expectCertified("thermal1_1000", thermal, Engine::Adaptive); }
TEST(CertifiedFit, Oscillator) { expectCertified("msd_1002", oscillator, Engine::Auto); }
TEST(CertifiedFit, TankThatRunsEmptyWithTheAdaptiveEngine) { expectCertified("tank_1015", tank, Engine::Adaptive); }

}  // namespace
}  // namespace analogon
