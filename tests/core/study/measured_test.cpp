#include "core/study/measured.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/measure/text/text_recording.hpp"

namespace analogon {
namespace {

std::shared_ptr<const Table> tableOf(const char* text) {
    const Outcome<Table> table = textTables(text, "run.csv");
    EXPECT_TRUE(table) << format(table.diagnostics());
    return std::make_shared<const Table>(*table);
}

TEST(MeasuredExperiments, AreWhatTheFilesHoldInTheirOwnUnits) {
    Study study;
    study.tables["run.csv"] =
        tableOf("t [ms];u [V];T [degC];w [rpm]\n0;1;20;100\n1000;2;21;\n2000;3;22;300\n3000;4;23;400\n");
    StudyExperiment run;
    run.name = "run";
    run.role = Role::Validate;
    run.file = "run.csv";
    run.timeColumn = "t";
    run.range = {1, 2};
    run.inputs["u"].column = "u";
    run.outputs["speed"].column = "w";
    run.outputs["T"].column = "T";
    run.outputs["T"].scale = 2;
    run.outputs["lost"].column = "none";
    study.experiments = {run, run};
    study.experiments[1].file = "missing.csv";
    const std::vector<ExperimentState> measured = measuredExperiments(study);
    ASSERT_EQ(measured.size(), 1u) << "a recording that is not there is left out";
    EXPECT_EQ(measured[0].role, Role::Validate);
    EXPECT_EQ(measured[0].time, (std::vector<double>{1, 2}));
    ASSERT_EQ(measured[0].outputs.size(), 2u) << "and so is a column";
    const OutputState &T = measured[0].outputs[0], &w = measured[0].outputs[1];
    EXPECT_EQ(T.unit, "degC");
    EXPECT_EQ(T.measured, Eigen::Vector2d(42, 44));
    EXPECT_EQ(T.simulated.size(), 0);
    EXPECT_EQ(w.unit, "rpm");
    EXPECT_TRUE(std::isnan(w.measured[0]));
    EXPECT_EQ(w.measured[1], 300);
}

}  // namespace
}  // namespace analogon
