// Fits in units in which values are very large or very small.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/measure/text/text_recording.hpp"
#include "core/study/run.hpp"
#include "core/study/study.hpp"

namespace analogon {
namespace {

/// T*der(y) = k*u - y with T = 1.5 and k = 2 in units of 1; `k`: the start value.
Study lag(double unitOfInput, double unitOfOutput, double k) {
    Outcome<Study> study = parseStudyJson(std::make_shared<const Source>("study.json", R"({
  "format": "analogon-study-1", "class": "Lag",
  "parameters": {"T": {"fit": true, "min": 0.1, "max": 10}, "k": {"fit": true}},
  "experiments": [{"name": "step", "role": "fit", "file": "step.csv", "time": "t", "inputs": {"u": "u"},
                   "outputs": {"y": "y"}}]})"));
    EXPECT_TRUE(study) << format(study.diagnostics());
    study->modelFile = "model.mo";
    study->models["model.mo"] = fmt::format(
        "model Lag parameter Real T = 1; parameter Real k = {}; input Real u; "
        "output Real y(start = 0, fixed = true); equation T*der(y) = k*u - y; end Lag;",
        k);
    std::string rows = "t [s],u [1],y [1]\n";
    for (int i = 0; i < 200; ++i) {
        const double t = 0.05 * i, wiggle = 0.001 * ((i * 7919) % 13 - 6);
        rows += fmt::format("{},{},{}\n", t, unitOfInput, unitOfOutput * (2 * (1 - std::exp(-t / 1.5)) + wiggle));
    }
    Outcome<Table> table = textTables(rows, "step.csv");
    EXPECT_TRUE(table) << format(table.diagnostics());
    study->tables["step.csv"] = std::make_shared<const Table>(std::move(*table));
    return std::move(*study);
}

TEST(Scale, OfInputsAndOutputsChangesNothingInWhatIsFound) {
    const double sizes[][3] = {{1, 1, 1},         {1, 1e10, 1e10}, {1, 1e30, 1e30}, {1, 1e-30, 1},    {1, 1e49, 1},
                               {1, 1e-49, 1e-49}, {1e49, 1, 1},    {1e-49, 1, 1},   {1e49, 1e-49, 1}, {1e-49, 1e49, 1}};
    for (const auto& [input, output, start] : sizes) {
        SCOPED_TRACE(fmt::format("u in {}, y in {}", input, output));
        const Outcome<RunResult> result = runFit(lag(input, output, start), {});
        ASSERT_TRUE(result) << format(result.diagnostics());
        const ModelState& found = result->finding.final;
        EXPECT_EQ(found.status, FitStatus::Converged) << found.message.english();
        ASSERT_EQ(found.parameters.size(), 2u);
        EXPECT_NEAR(found.parameters[0].value, 1.5, 0.01);
        EXPECT_NEAR(found.parameters[1].value * input / output, 2, 0.01);
    }
}

}  // namespace
}  // namespace analogon
