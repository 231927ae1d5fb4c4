/// Fits of what stands in the tables of a model.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "core/fit/fit.hpp"
#include "core/fit/problem.hpp"
#include "tests/core/effect/text_task.hpp"
#include "tests/core/fit/slopes.hpp"

namespace analogon {
namespace {

using ::testing::HasSubstr;

/// The functions behind the table blocks of the Modelica Standard Library, with a table that comes from parameters.
constexpr const char* external = R"(
  class Table
    extends ExternalObject;
    function constructor
      input String tableName;
      input String fileName;
      input Real table[:, :];
      input Integer columns[:];
      input Integer smoothness;
      input Integer extrapolation;
      output Table object;
      external "C" object = ModelicaStandardTables_CombiTable1D_init3(fileName, tableName, table, size(table, 1),
        size(table, 2), columns, size(columns, 1), smoothness, extrapolation, 0, ",", 0);
    end constructor;
    function destructor
      input Table object;
      external "C" ModelicaStandardTables_CombiTable1D_close(object);
    end destructor;
  end Table;
  function valueOf
    input Table table;
    input Real u;
    output Real y;
    external "C" y = ModelicaStandardTables_CombiTable1D_getValue(table, 1, u);
  end valueOf;
  Table table = Table("NoName", "NoName", points, {2}, SMOOTHNESS, 2);
)";

/// der(x) = u - friction(x), the friction at 0, 1, 2 and 4 in a table: `value` says how it is looked up.
EstimationTask bodyWith(const std::string& declarations, const std::string& value,
                        const std::vector<std::string>& names) {
    EstimationTask task =
        taskOf("model Body\n  input Real u;\n  output Real y = x;\n  Real x(start = 0.3, fixed = true);\n" +
                   declarations + "equation\n  der(x) = u - " + value + ";\nend Body;\n",
               "Body");
    for (std::size_t i = 0; i < names.size(); ++i)
        task.parameters.push_back({names[i], "", 0.5 + 0.3 * static_cast<double>(i), 0.01, 5});
    return task;
}

constexpr double truth[] = {0.4, 0.9, 1.2, 2.1};

/// A recording that goes through the table and beyond its end, with `y` as it is there.
Recording recorded(const std::vector<double>& y) {
    Recording r = blankRecording("run", {"u"}, {"y"}, static_cast<int>(y.size()));
    for (std::size_t k = 0; k < y.size(); ++k) {
        r.time.push_back(0.02 * static_cast<double>(k));
        r.inputs(0, static_cast<Eigen::Index>(k)) = 1.7 + 1.7 * std::sin(0.013 * static_cast<double>(k));
        r.outputs(0, static_cast<Eigen::Index>(k)) = y[k];
    }
    return r;
}

constexpr std::size_t samples = 500;

PreparedTask prepared(EstimationTask task, const std::vector<double>& y) {
    task.recordings = {recorded(y)};
    Outcome<PreparedTask> ready = prepare(task);
    EXPECT_TRUE(ready) << format(ready.diagnostics());
    return ready ? std::move(*ready) : PreparedTask{};
}

Eigen::VectorXd trueValues() { return Eigen::Map<const Eigen::VectorXd>(truth, 4); }

/// What the program simulates with the true ordinates.
std::vector<double> simulated(const EstimationTask& task) {
    const PreparedTask ready = prepared(task, std::vector<double>(samples, 0.0));
    if (!ready.system) return {};
    const Linearisation line = linearise(ready.problem, trueValues(), false, {});
    EXPECT_TRUE(line.ok) << line.failure.english();
    const auto row = line.trajectories.front().outputs.row(0);
    return {row.begin(), row.end()};
}

/// The tangents with respect to the ordinates are those of differences, and a fit finds them again.
void expectFitted(const EstimationTask& task, double tolerance) {
    const std::vector<double> y = simulated(task);
    ASSERT_EQ(y.size(), samples);
    const PreparedTask ready = prepared(task, y);
    Eigen::VectorXd at = trueValues();
    at[1] *= 1.07;
    const Linearisation line = linearise(ready.problem, at, true, {});
    ASSERT_TRUE(line.ok) << line.failure.english();
    std::vector<GridPlan> plans;
    for (const Trajectory& t : line.trajectories) plans.push_back(t.plan);
    test::expectSlopesOf(ready.problem, at, plans, line, tolerance);
    const FitResult result = fit(ready.problem);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(result.estimates.at(i).value, truth[i], 1e-4) << i;
}

std::vector<std::string> entries() { return {"f[1]", "f[2]", "f[3]", "f[4]"}; }
std::vector<std::string> points() { return {"points[1,2]", "points[2,2]", "points[3,2]", "points[4,2]"}; }

std::string tableOf(int smoothness) {
    std::string text = external;
    text.replace(text.find("SMOOTHNESS"), 10, std::to_string(smoothness));
    return "  parameter Real points[:, 2] = [0, 0.5; 1, 0.8; 2, 1.1; 4, 1.4];\n" + text;
}

TEST(FitOfATable, FindsTheOrdinatesOfStraightPieces) {
    expectFitted(bodyWith("  parameter Real f[4] = {0.5, 0.8, 1.1, 1.4};\n",
                          "Analogon.Tables.linear(x, {0, 1, 2, 4}, f)", entries()),
                 1e-5);
}

TEST(FitOfATable, FindsTheOrdinatesOfAMonotoneCubic) {
    expectFitted(bodyWith("  parameter Real f[4] = {0.5, 0.8, 1.1, 1.4};\n",
                          "Analogon.Tables.monotoneCubic(x, {0, 1, 2, 4}, f)", entries()),
                 1e-5);
}

TEST(FitOfATable, FindsTheOrdinatesOfATableOfTheStandardLibrary) {
    // straight pieces, Akima, Fritsch & Butland, Steffen, modified Akima
    for (const int smoothness : {1, 2, 4, 5, 6}) {
        SCOPED_TRACE(smoothness);
        expectFitted(bodyWith(tableOf(smoothness), "valueOf(table, x)", points()), 1e-5);
    }
}

/// What is fitted may stand behind the entries.
TEST(FitOfATable, FollowsTheParametersThatTheEntriesAreBoundTo) {
    expectFitted(bodyWith("  parameter Real a = 0.5;\n  parameter Real b = 0.8;\n  parameter Real c = 1.1;\n"
                          "  parameter Real d = 1.4;\n  parameter Real f[4] = {a, b, c, d};\n",
                          "Analogon.Tables.linear(x, {0, 1, 2, 4}, f)", {"a", "b", "c", "d"}),
                 1e-5);
}

/// With symbols for ordinates the curve is the same as with numbers.
TEST(FitOfATable, LeavesTheCurveAsItIs) {
    for (const int smoothness : {1, 2, 3, 4, 5, 6}) {
        EstimationTask open = bodyWith(tableOf(smoothness), "valueOf(table, x)", points());
        std::string text = tableOf(smoothness);
        text.replace(text.find("[0, 0.5"), 31, "[0, 0.4; 1, 0.9; 2, 1.2; 4, 2.1");
        EstimationTask closed = bodyWith(text, "valueOf(table, x)", {});
        const PreparedTask ready = prepared(closed, std::vector<double>(samples, 0.0));
        ASSERT_TRUE(ready.system);
        const Linearisation line = linearise(ready.problem, Eigen::VectorXd(), false, {});
        ASSERT_TRUE(line.ok) << line.failure.english();
        const std::vector<double> y = simulated(open);
        ASSERT_EQ(y.size(), samples);
        for (std::size_t k = 0; k < samples; ++k)
            ASSERT_NEAR(y[k], line.trajectories.front().outputs(0, static_cast<Eigen::Index>(k)), 1e-6)
                << smoothness << " at " << k;
    }
}

TEST(FitOfATable, RefusesAnAbscissaByName) {
    EstimationTask task = bodyWith(tableOf(1), "valueOf(table, x)", {"points[2,1]"});
    task.recordings = {recorded(std::vector<double>(samples, 0.0))};
    const Outcome<PreparedTask> ready = prepare(task);
    ASSERT_FALSE(ready);
    EXPECT_THAT(format(ready.diagnostics()), HasSubstr("points[2,1] has shaped the equations"));
}

}  // namespace
}  // namespace analogon
