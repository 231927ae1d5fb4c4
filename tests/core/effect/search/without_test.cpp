#include "core/effect/search/without.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/effect/search/context.hpp"
#include "tests/core/effect/text_task.hpp"

namespace analogon {
namespace {

constexpr char waveText[] =
    "model Wave Analogon.Interfaces.RealOutput y; parameter Real w = 1.1; equation y = sin(w*time); end Wave;";
constexpr double truth = 1.0;

/// The frequency of a recorded wave, which has a valley of the misfit at each number of turns.
EstimationTask wave() {
    EstimationTask task = taskOf(waveText, "Wave");
    task.parameters = {{"w", "1", 1.1, 0.1, 10}};
    Recording r;
    r.name = "wave";
    r.role = Role::Fit;
    r.outputNames = {"y"};
    r.outputs.resize(1, 400);
    r.inputs.resize(0, 400);
    for (int k = 0; k < 400; ++k) {
        r.time.push_back(0.05 * k);
        r.outputs(0, k) = std::sin(truth * 0.05 * k) + 1e-3 * std::sin(37.0 * k);
    }
    task.recordings = {r};
    return task;
}

NullModel fittedFrom(const SearchContext& search, double w) {
    Variant start = search.readings.searched;
    start.values = {{"w", -1, w}};
    Outcome<NullModel> fitted = fitNull(start, {}, NoiseLevel::Estimate, search.fit, search.progress);
    EXPECT_TRUE(fitted) << format(fitted.diagnostics());
    return fitted ? std::move(*fitted) : NullModel{};
}

TEST(SeekFromTheStart, LeavesAValleyThatTheStudyDoesNotBeginIn) {
    const SearchContext search(wave(), {}, {});
    NullModel model = fittedFrom(search, 3.0);
    ASSERT_GT(std::abs(model.fit.estimates.front().value - truth), 0.5) << "a poorer optimum";
    const double before = model.sumOfSquares();
    seekFromTheStart(search, search.readings.searched, model);
    EXPECT_LT(model.sumOfSquares(), 0.1 * before);
    EXPECT_NEAR(model.fit.estimates.front().value, truth, 1e-3);
}

TEST(SeekFromTheStart, KeepsTheBetterOptimum) {
    EstimationTask task = wave();
    task.parameters.front().start = 3.0;
    const SearchContext search(task, {}, {});
    NullModel model = fittedFrom(search, 1.1);
    const double before = model.sumOfSquares();
    seekFromTheStart(search, search.readings.searched, model);
    EXPECT_EQ(model.sumOfSquares(), before);
    EXPECT_NEAR(model.fit.estimates.front().value, truth, 1e-3);
}

}  // namespace
}  // namespace analogon
