#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/fit/fit.hpp"

namespace analogon {
namespace {

using Row = Eigen::RowVectorXd;

TEST(ErrorFigures, OfAChannelThatStandsStillAreInPercentOfItsMagnitude) {
    const ErrorFigures off = errorFigures(Row::Constant(50, 12.6), Row::Constant(50, 12.0));
    EXPECT_NEAR(off.rmse, 0.6, 1e-12);
    EXPECT_NEAR(off.errorPercent, 5.0, 1e-9);
    EXPECT_TRUE(std::isnan(off.fitPercent)) << "there is no mean that the model could be better than";
    EXPECT_NEAR(errorFigures(Row::Zero(50), Row::Constant(50, -12.0)).errorPercent, 100.0, 1e-9);
    EXPECT_EQ(errorFigures(Row::Constant(50, 12.0), Row::Constant(50, 12.0)).errorPercent, 0.0);
    EXPECT_TRUE(off.hasScale());
}

TEST(ErrorFigures, OfHugeAndOfTinyValuesAreThoseInAnotherUnit) {
    const Row measured = Row::LinSpaced(50, 1, 3), simulated = Row::LinSpaced(50, 1.1, 2.8);
    const ErrorFigures common = errorFigures(simulated, measured);
    for (const double unit : {1e297, 1e-297}) {
        const ErrorFigures figures = errorFigures(unit * simulated, unit * measured);
        EXPECT_NEAR(figures.errorPercent, common.errorPercent, 1e-9) << unit;
        EXPECT_NEAR(figures.fitPercent, common.fitPercent, 1e-9) << unit;
        EXPECT_NEAR(figures.relativeRmsPercent, common.relativeRmsPercent, 1e-9) << unit;
        EXPECT_NEAR(figures.rmse / unit, common.rmse, 1e-9) << unit;
        EXPECT_NEAR(figures.maxAbs / unit, common.maxAbs, 1e-9) << unit;
    }
}

TEST(ErrorFigures, OfAChannelThatIsZeroThroughoutAreItsRootMeanSquareAlone) {
    const ErrorFigures figures = errorFigures(Row::Constant(50, 0.3), Row::Zero(50));
    EXPECT_NEAR(figures.rmse, 0.3, 1e-12);
    EXPECT_TRUE(std::isnan(figures.errorPercent)) << "neither 0 nor infinite";
    EXPECT_FALSE(figures.hasScale());
}

TEST(ErrorFigures, OfASimulationThatFailedShow) {
    Row failed = Row::Zero(50);
    failed.tail(10).setConstant(std::nan(""));
    const ErrorFigures figures = errorFigures(failed, Row::LinSpaced(50, 0, 1));
    EXPECT_TRUE(std::isnan(figures.errorPercent));
    EXPECT_TRUE(figures.hasScale()) << "it is not the channel that has none";
}

TEST(MeanError, LeavesOutWhatHasNoErrorInPercent) {
    struct Part {
        double error{};
        bool counts{};
    };
    const auto mean = [](const auto& parts) { return meanError(parts, &Part::error, &Part::counts); };
    EXPECT_NEAR(mean(std::array{Part{3, true}, Part{std::nan(""), false}, Part{4, true}}), std::sqrt(12.5), 1e-12);
    EXPECT_TRUE(std::isnan(mean(std::array{Part{std::nan(""), false}}))) << "no error is not an error of 0";
    EXPECT_EQ(mean(std::array<Part, 0>{}), 0.0);
}

}  // namespace
}  // namespace analogon
