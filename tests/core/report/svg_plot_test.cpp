#include "core/report/svg_plot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace analogon {
namespace {

using ::testing::ElementsAre;
using ::testing::Not;

std::vector<double> times(int count) {
    std::vector<double> time;
    for (int i = 0; i < count; ++i) time.push_back(0.1 * i);
    return time;
}

TEST(Thinning, KeepsShortTracesWhole) {
    EXPECT_THAT(thinned(times(3), Eigen::Vector3d(1, 2, 3), 100), ElementsAre(0, 1, 2));
}

TEST(Thinning, KeepsTheExtremesOfEveryColumn) {
    Eigen::VectorXd values = Eigen::VectorXd::Zero(10000);
    values[1234] = 5;
    values[7777] = -3;
    const auto kept = thinned(times(10000), values, 50);
    EXPECT_LE(kept.size(), 102u);
    EXPECT_THAT(kept, ::testing::Contains(1234u));
    EXPECT_THAT(kept, ::testing::Contains(7777u));
    EXPECT_EQ(kept.front(), 0u);
    EXPECT_EQ(kept.back(), 9999u);
    EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
}

TEST(Thinning, KeepsGapsOpen) {
    Eigen::VectorXd values = Eigen::VectorXd::LinSpaced(10000, 0, 1);
    for (int i = 4000; i < 4010; ++i) values[i] = std::nan("");
    const auto kept = thinned(times(10000), values, 50);
    EXPECT_THAT(kept, ::testing::Contains(4000u));
    EXPECT_THAT(kept, ::testing::Contains(4010u));
}

TEST(Ticks, AreRoundAndInside) {
    EXPECT_THAT(ticks(0, 10, 5), ElementsAre(0, 2, 4, 6, 8, 10));
    EXPECT_THAT(ticks(0.03, 0.31, 3), ElementsAre(::testing::DoubleNear(0.1, 1e-12), ::testing::DoubleNear(0.2, 1e-12),
                                                  ::testing::DoubleNear(0.3, 1e-12)));
    EXPECT_TRUE(ticks(1, 1, 5).empty());
    EXPECT_TRUE(ticks(0, std::nan(""), 5).empty());
    EXPECT_TRUE(ticks(273.15, 273.15 + 6e-14, 5).empty()) << "no number lies between";
}

TEST(Plot, HasNoNumberThatIsNone) {
    SignalPlot plot;
    plot.id = "p1";
    plot.label = "i [A]";
    plot.time = times(100);
    Eigen::VectorXd values = Eigen::VectorXd::Constant(100, 2);
    Eigen::VectorXd broken = values;
    for (int i = 50; i < 100; ++i) broken[i] = i % 2 ? std::nan("") : 1e300;
    plot.signals = {{"measured", values}, {"after", broken}};
    plot.residuals = {{"after", values - broken}};
    const std::string svg = svgPlot(plot);
    EXPECT_THAT(svg, Not(::testing::HasSubstr("nan")));
    EXPECT_THAT(svg, Not(::testing::HasSubstr("inf")));
}

TEST(Plot, BreaksTheLineAtAGap) {
    SignalPlot plot;
    plot.id = "p1";
    plot.time = times(5);
    Eigen::VectorXd values(5);
    values << 1, 2, std::nan(""), 3, 4;
    plot.signals = {{"measured", values}};
    const std::string svg = svgPlot(plot);
    const std::string path = svg.substr(svg.find("class=\"trace measured\""));
    EXPECT_EQ(std::count(path.begin(), path.end(), 'M'), 2);
}

TEST(Plot, ShadesABandBehindTheTraces) {
    SignalPlot plot;
    plot.id = "p1";
    plot.time = times(5);
    const Eigen::VectorXd values = Eigen::VectorXd::LinSpaced(5, 1.0, 2.0);
    plot.signals = {{"measured", values}};
    plot.bands = {{"parameters", values.array() - 0.1, values.array() + 0.1}};
    const std::string svg = svgPlot(plot);
    const std::size_t at = svg.find("class=\"band parameters\"");
    ASSERT_NE(at, std::string::npos);
    EXPECT_LT(at, svg.find("class=\"trace measured\""));
    const std::string path = svg.substr(at, svg.find("/>", at) - at);
    EXPECT_EQ(std::count(path.begin(), path.end(), 'M'), 1);
    EXPECT_EQ(std::count(path.begin(), path.end(), 'L'), 9);  // along five samples, and back
    EXPECT_EQ(std::count(path.begin(), path.end(), 'Z'), 1);
    plot.bands = {{"parameters", values * std::nan(""), values * std::nan("")}};
    EXPECT_EQ(svgPlot(plot).find("class=\"band"), std::string::npos);
}

ProfilePlot profileOf(std::vector<double> values, std::vector<double> rises) {
    ProfilePlot plot;
    plot.title = "R <1>";
    plot.label = "R [Ohm]";
    plot.estimate = values.front();
    plot.lower = values.front();
    plot.upper = values.back();
    plot.values = std::move(values);
    plot.rises = std::move(rises);
    return plot;
}

TEST(ProfilePlot, DrawsEveryPointThatIsANumber) {
    const std::string svg = svgProfile(profileOf({1.0, 2.0, 3.0, 4.0}, {4.0, 0.0, std::nan(""), 4.2}));
    EXPECT_THAT(svg, ::testing::HasSubstr("R &lt;1&gt;"));
    EXPECT_THAT(svg, ::testing::HasSubstr(">R [Ohm]</text>"));
    EXPECT_THAT(svg, ::testing::HasSubstr(">95 %</text>"));
    const std::string points = svg.substr(svg.find("points="));
    EXPECT_EQ(std::count(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(points.find("/>")), ','), 3);
    EXPECT_THAT(svg, Not(::testing::HasSubstr("nan")));
    EXPECT_TRUE(svgProfile(profileOf({1.0}, {0.0})).empty());
}

TEST(ProfilePlot, MarksTheIntervalAndSaysWhichSideIsOpen) {
    const auto limits = [](const std::string& svg) {
        std::size_t count = 0;
        for (std::size_t at = svg.find("class=\"limit\""); at != std::string::npos;
             at = svg.find("class=\"limit\"", at + 1))
            ++count;
        return count;
    };
    ProfilePlot plot = profileOf({1.0, 2.0, 3.0}, {4.0, 0.0, 4.0});
    EXPECT_EQ(limits(svgProfile(plot)), 2u);
    EXPECT_THAT(svgProfile(plot), Not(::testing::HasSubstr("open")));
    plot.isOpenAbove = true;
    EXPECT_EQ(limits(svgProfile(plot)), 1u);
    EXPECT_THAT(svgProfile(plot), ::testing::HasSubstr("open →"));
}

TEST(Html, IsEscaped) { EXPECT_EQ(escapeHtml("a<b>&\"'\x01"), "a&lt;b&gt;&amp;&quot;&#39;\\u{1}"); }

}  // namespace
}  // namespace analogon
