#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <random>

#include "core/study/run.hpp"
#include "study_fixture.hpp"

namespace analogon::test {

/// A column that is measured, its noise, and its value where a recording stands.
struct Measured {
    const char* header;
    double noise;
    std::vector<double> values{};
};

/// One step of the classical Runge-Kutta method.
template <std::size_t N, class Rate>
void advance(std::array<double, N>& x, double t, double h, const Rate& rate) {
    const auto along = [&](const std::array<double, N>& k, double part) {
        std::array<double, N> y = x;
        for (std::size_t i = 0; i < N; ++i) y[i] += part * h * k[i];
        return y;
    };
    const auto a = rate(t, x), b = rate(t + h / 2, along(a, 0.5)), c = rate(t + h / 2, along(b, 0.5)),
               d = rate(t + h, along(c, 1));
    for (std::size_t i = 0; i < N; ++i) x[i] += h * (a[i] + 2 * b[i] + 2 * c[i] + d[i]) / 6;
}

/// The command of a recording: levels of many sizes from `low` to `high`, joined by straight lines from one sample to
/// the next.
struct Command {
    double step;  // [s] between samples
    int pause;    // samples of a level
    double low, high;
    int first{};  // level with which the recording begins: each has another course

    double atSample(int k) const {
        constexpr std::array<double, 11> levels{0, 0.7, 0.3, 1, 0.5, 0.15, 0.85, 0.4, 0.95, 0.05, 0.6};
        return low + (high - low) * levels[static_cast<std::size_t>(k / pause + first) % levels.size()];
    }
    double operator()(double t) const {
        const int k = static_cast<int>(std::floor(t / step));
        return atSample(k) + (atSample(k + 1) - atSample(k)) * (t / step - k);
    }
};

inline double signOf(double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

/// Dry friction of `limit` on what `driven` moves: what it takes of the drive, at rest all that it can (where `driven`
/// holds also what stops the rest of the motion).
inline double dryFriction(double driven, double velocity, double limit, double still) {
    return std::abs(velocity) > still ? limit * signOf(velocity) : std::clamp(driven, -limit, limit);
}

class DiscoveryInStandardLibrary : public StudyTest {
protected:
    void SetUp() override {
        StudyTest::SetUp();
        const char* const path = std::getenv("MODELICAPATH");
        if (!path || !*path) GTEST_SKIP() << "MODELICAPATH names no directory with the Modelica Standard Library";
    }

    /// Writes a recording of `samples` of the command and of what `measured` says of each state.
    template <std::size_t N, class Rate, class Shown>
    void record(const std::string& file, const std::string& input, const Command& command, int samples, int within,
                std::array<double, N> x, const Rate& rate, const std::vector<Measured>& measured, const Shown& shown) {
        std::mt19937 random(static_cast<unsigned>(command.first) + 3);
        std::normal_distribution<double> normal;
        std::ofstream csv(directory_ / file);
        csv.precision(10);
        csv << "t [s]," << input;
        for (const Measured& m : measured) csv << ',' << m.header;
        csv << '\n';
        for (int k = 0; k < samples; ++k) {
            const double t = k * command.step;
            csv << t << ',' << command(t);
            const std::vector<double> values = shown(t, x);
            for (std::size_t m = 0; m < measured.size(); ++m)
                csv << ',' << values[m] + measured[m].noise * normal(random);
            csv << '\n';
            for (int j = 0; j < within; ++j) advance(x, t + j * command.step / within, command.step / within, rate);
        }
    }

    /// The study of fit.csv and check.csv; `inputs`, `outputs`, `parameters`: as in study.json.
    void putStudy(const std::string& name, const std::string& inputs, const std::string& outputs,
                  const std::string& parameters) {
        const auto experiment = [&](const std::string& file, const std::string& role) {
            return R"({"name": ")" + role + R"(", "role": ")" + role + R"(", "file": ")" + file +
                   R"(", "time": "t", "inputs": {)" + inputs + R"(}, "outputs": {)" + outputs + "}}";
        };
        put("study.json", R"({"format": "analogon-study-1", "class": ")" + name + R"(", "experiments": [)" +
                              experiment("fit.csv", "fit") + ",\n" + experiment("check.csv", "validate") +
                              R"(], "parameters": {)" + parameters + "}}");
    }

    Finding discovered() {
        if (const char* kept = std::getenv("ANALOGON_KEEP_STUDIES")) {
            const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
            std::filesystem::copy(
                directory_, std::filesystem::path(kept) / test->name(),
                std::filesystem::copy_options::overwrite_existing | std::filesystem::copy_options::recursive);
            return {};
        }
        const Outcome<RunResult> result = runDiscover(read(), {});
        EXPECT_TRUE(result) << format(result.diagnostics());
        return result ? result->finding : Finding{};
    }

    /// Expects one effect, of this kind at one of these places (which the data cannot tell apart) and of this strength,
    /// and that what was not fitted is met as well as the noise allows.
    static void expectFound(const Finding& finding, const std::string& kind, const std::string& at, double strength,
                            double tolerance, const std::vector<Measured>& measured) {
        EXPECT_EQ(finding.kind, FindingKind::Effect);
        ASSERT_EQ(finding.effects.size(), 1u);
        const AddedEffect& effect = finding.effects.front();
        EXPECT_EQ(effect.kind, kind);
        EXPECT_EQ(effect.at, at);
        EXPECT_NEAR(effect.parameters.at(0).value, strength, tolerance);
        int checked = 0;
        for (const ExperimentState& experiment : finding.final.experiments)
            for (const OutputState& output : experiment.outputs)
                for (const Measured& m : measured)
                    if (experiment.role == Role::Validate && std::string(m.header).starts_with(output.name)) {
                        EXPECT_LT(output.figures.rmse, 1.1 * m.noise) << output.name;
                        ++checked;
                    }
        EXPECT_EQ(checked, static_cast<int>(measured.size()));
    }
};

}  // namespace analogon::test
