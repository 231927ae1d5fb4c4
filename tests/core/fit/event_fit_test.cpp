/// Fits of models with events to noisy recordings, made and searched by equations of their own.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <random>

#include "core/fit/fit.hpp"
#include "tests/core/effect/text_task.hpp"

namespace analogon {
namespace {

using Point = std::vector<double>;

/// The least value that the simplex method of Nelder and Mead (1965) finds, begun anew until it falls no more.
double leastOf(const std::function<double(const Point&)>& f, Point best) {
    const std::size_t n = best.size();
    double least = f(best);
    for (int again = 0; again < 6; ++again) {
        std::vector<std::pair<double, Point>> simplex{{least, best}};
        for (std::size_t i = 0; i < n; ++i) {
            Point p = best;
            p[i] *= 1.02;
            simplex.emplace_back(f(p), p);
        }
        for (int k = 0; k < 150 * static_cast<int>(n); ++k) {
            std::sort(simplex.begin(), simplex.end());
            const auto along = [&](double by) {  // from the worst through the middle of the others
                Point p(n);
                for (std::size_t i = 0; i < n; ++i) {
                    double middle = 0;
                    for (std::size_t j = 0; j < n; ++j) middle += simplex[j].second[i] / static_cast<double>(n);
                    p[i] = middle + by * (simplex[n].second[i] - middle);
                }
                return std::pair(f(p), p);
            };
            auto next = along(-1);
            if (next.first < simplex[0].first)
                next = std::min(next, along(-2));
            else if (next.first >= simplex[n - 1].first)
                next = along(0.5);
            if (next.first < simplex[n].first) {
                simplex[n] = next;
                continue;
            }
            for (std::size_t j = 1; j <= n; ++j) {
                for (std::size_t i = 0; i < n; ++i)
                    simplex[j].second[i] = (simplex[j].second[i] + simplex[0].second[i]) / 2;
                simplex[j].first = f(simplex[j].second);
            }
        }
        std::sort(simplex.begin(), simplex.end());
        least = simplex[0].first;
        best = simplex[0].second;
    }
    return least;
}

/// A model with one output, what it shows by a formula or an integration of its own, and its parameters.
struct Case {
    EstimationTask task;
    std::vector<double> time, input;
    Point truth;
    double noise{};
    std::function<std::vector<double>(const Point&)> shown;
    bool goesOnAtKinks{true};

    std::vector<double> recorded(unsigned seed) const {
        std::mt19937 random(seed);
        std::normal_distribution<double> normal(0, noise);
        std::vector<double> y = shown(truth);
        for (double& value : y) value += normal(random);
        return y;
    }
    /// The program's fit to a recording.
    FitResult fitted(const std::vector<double>& y) const {
        EstimationTask with = task;
        const int samples = static_cast<int>(y.size());
        Recording r = blankRecording("run", input.empty() ? std::vector<std::string>{} : std::vector<std::string>{"u"},
                                     {"y"}, samples);
        r.time = time;
        for (int k = 0; k < samples; ++k) {
            r.outputs(0, k) = y[static_cast<std::size_t>(k)];
            if (!input.empty()) r.inputs(0, k) = input[static_cast<std::size_t>(k)];
        }
        with.recordings = {std::move(r)};
        const Outcome<PreparedTask> ready = prepare(with);
        EXPECT_TRUE(ready) << format(ready.diagnostics());
        if (!ready) return {};
        FitOptions options;
        options.goesOnAtKinks = goesOnAtKinks;
        return fit(ready->problem, options);
    }
    double misfit(const std::vector<double>& y, const Point& at) const {
        const std::vector<double> own = shown(at);
        double sum = 0;
        for (std::size_t k = 0; k < y.size(); ++k) sum += std::pow(y[k] - own[k], 2);
        return sum;
    }
};

/// By how much the misfit of the program's optimum lies over the least that is found without it.
double excessOf(const Case& c, unsigned seed = 1) {
    const std::vector<double> y = c.recorded(seed);
    const FitResult result = c.fitted(y);
    EXPECT_EQ(result.status, FitStatus::Converged) << result.message.english();
    Point at;
    for (const FitEstimate& e : result.estimates) at.push_back(e.value);
    const double least = leastOf([&](const Point& p) { return c.misfit(y, p); }, c.truth);
    return c.misfit(y, at) / least - 1;
}

/// Of each parameter, over what the theory of linear fits says: the standard errors that are told, and how the
/// estimates of many recordings scatter. A linear fit to the same noise stands in the place of its formula, which so
/// many recordings would meet to a tenth only.
struct ErrorRatios {
    double told{}, found{};
};

std::vector<ErrorRatios> errorRatios(const Case& c, int recordings) {
    const auto n = static_cast<Eigen::Index>(c.truth.size());
    const auto samples = static_cast<Eigen::Index>(c.time.size());
    const std::vector<double> clean = c.shown(c.truth);
    Eigen::MatrixXd slopes(samples, n);
    for (Eigen::Index i = 0; i < n; ++i) {
        Point up = c.truth, down = c.truth;
        const double step = 1e-6 * c.truth[static_cast<std::size_t>(i)];
        up[static_cast<std::size_t>(i)] += step;
        down[static_cast<std::size_t>(i)] -= step;
        const std::vector<double> above = c.shown(up), below = c.shown(down);
        for (Eigen::Index k = 0; k < samples; ++k)
            slopes(k, i) = (above[static_cast<std::size_t>(k)] - below[static_cast<std::size_t>(k)]) / (2 * step);
    }
    const Eigen::MatrixXd inverse = (slopes.transpose() * slopes).inverse();
    Eigen::MatrixXd offs(recordings, n), linear(recordings, n);
    Eigen::VectorXd told = Eigen::VectorXd::Zero(n);
    for (int r = 0; r < recordings; ++r) {
        const std::vector<double> y = c.recorded(100 + static_cast<unsigned>(r));
        const FitResult result = c.fitted(y);
        Eigen::VectorXd noise(samples);
        for (Eigen::Index k = 0; k < samples; ++k)
            noise[k] = y[static_cast<std::size_t>(k)] - clean[static_cast<std::size_t>(k)];
        linear.row(r) = (inverse * (slopes.transpose() * noise)).transpose();
        for (Eigen::Index i = 0; i < n; ++i) {
            const FitEstimate& e = result.estimates.at(static_cast<std::size_t>(i));
            offs(r, i) = e.value - c.truth[static_cast<std::size_t>(i)];
            told[i] += e.standardError / recordings;
        }
    }
    std::vector<ErrorRatios> ratios;
    for (Eigen::Index i = 0; i < n; ++i)
        ratios.push_back({told[i] / (c.noise * std::sqrt(inverse(i, i))), offs.col(i).norm() / linear.col(i).norm()});
    return ratios;
}

void expectRight(const std::vector<ErrorRatios>& ratios) {
    for (const ErrorRatios& ratio : ratios) {
        EXPECT_NEAR(ratio.told, 1, 0.05);
        EXPECT_NEAR(ratio.found, 1, 0.05);
    }
}

Case ball() {
    Case c;
    c.task = taskOf(R"(model Ball
  parameter Real g = 9;
  parameter Real e = 0.75;
  Real h(start = 1, fixed = true);
  Real v(start = 0, fixed = true);
  output Real y = h;
equation
  der(h) = v;
  der(v) = -g;
  when h <= 0 then
    reinit(v, -e*pre(v));
  end when;
end Ball;
)",
                    "Ball");
    c.task.parameters = {{"g", "m/s2", 9.5, 5, 15}, {"e", "", 0.78, 0.3, 0.99}};
    for (int k = 0; k < 150; ++k) c.time.push_back(0.01 * k);
    c.truth = {9.81, 0.8};
    c.noise = 0.01;
    c.shown = [time = c.time](const Point& p) {
        std::vector<double> y;
        for (const double t : time) {
            double since = 0, v = 0, h = 1, until = std::sqrt(2 / p[0]);
            while (t > since + until) {  // the next bounce
                v = p[1] * (h > 0 ? p[0] * until : v);
                h = 0;
                since += until;
                until = 2 * v / p[0];
            }
            y.push_back(h + v * (t - since) - p[0] * (t - since) * (t - since) / 2);
        }
        return y;
    };
    return c;
}

/// The command of a shaft with dry friction, and what its speed is: from rest to rest, by parts of straight lines of
/// the command. J, friction at rest, friction at 20 rad/s.
Case shaft(EstimationTask task) {
    Case c;
    c.task = std::move(task);
    for (int k = 0; k < 200; ++k) {
        c.time.push_back(0.01 * k);
        c.input.push_back(1.5 * std::sin(0.07 * k) + 0.6 * std::sin(0.021 * k));
    }
    c.truth = {0.05, 0.4, 0.7};
    c.noise = 0.05;
    c.shown = [input = c.input](const Point& p) {
        constexpr int within = 50;
        constexpr double h = 0.01 / within, knee = 20;
        std::vector<double> y;
        double w = 0;
        for (std::size_t k = 0; k < input.size(); ++k) {
            y.push_back(w);
            if (k + 1 == input.size()) break;
            const double slope = (input[k + 1] - input[k]) / within;
            for (int j = 0; j < within; ++j) {
                const double u = input[k] + slope * (j + 0.5);  // mean of the part
                const double side = w > 0 ? 1 : w < 0 ? -1 : u > p[1] ? 1 : u < -p[1] ? -1 : 0;
                if (side == 0) continue;  // it sticks
                const double b = (p[2] - p[1]) / knee;
                // exact for a torque that keeps still over the part
                const double end = (u - side * p[1]) / b, decay = std::exp(-b * h / p[0]);
                const double next = end + (w - end) * decay;
                if (side * next >= 0) {
                    w = next;
                    continue;
                }
                // it comes to rest in the part, and may go on to the other side
                const double rest = h + p[0] / b * std::log(end / (end - w));  // what is left of the part
                const double other = u > p[1] ? 1 : u < -p[1] ? -1 : 0;
                w = other == 0 ? 0 : (u - other * p[1]) / b * (1 - std::exp(-b * rest / p[0]));
            }
        }
        return y;
    };
    return c;
}

EstimationTask ownShaft() {
    EstimationTask task = taskOf(R"(model Shaft
  parameter Real J = 0.06;
  parameter Real c = 0.5;
  parameter Real k = 0.6;
  input Real u;
  output Real y = w;
  Real w(start = 0, fixed = true);
  Real f;
  Integer mode(start = 0, fixed = true);
equation
  J*der(w) = u - f;
  f = if mode == 0 then u else mode*c + (k - c)*w/20;
  when mode == 1 and w < 0 or mode == -1 and w > 0 then
    reinit(w, 0);
  end when;
algorithm
  when mode == 0 and u > c then
    mode := 1;
  elsewhen mode == 0 and u < -c then
    mode := -1;
  elsewhen mode == 1 and w < 0 or mode == -1 and w > 0 then
    mode := 0;
  end when;
end Shaft;
)",
                                 "Shaft");
    task.parameters = {{"J", "kg.m2", 0.06, 0.01, 0.5}, {"c", "N.m", 0.5, 0.05, 1}, {"k", "N.m", 0.6, 0.05, 3}};
    return task;
}

/// The same shaft with the bearing of the Modelica Standard Library; its friction stands in a table.
EstimationTask bearingShaft(const char* library) {
    EstimationTask task;
    task.model = std::make_shared<Source>("model.mo", R"(model Shaft
  Modelica.Blocks.Interfaces.RealInput u;
  Modelica.Blocks.Interfaces.RealOutput y;
  Modelica.Mechanics.Rotational.Sources.Torque drive;
  Modelica.Mechanics.Rotational.Components.Inertia rotor(J=0.06, phi(fixed=true, start=0), w(fixed=true, start=0));
  Modelica.Mechanics.Rotational.Components.BearingFriction bearing(tau_pos=[0, 0.5; 20, 0.6]);
  Modelica.Mechanics.Rotational.Sensors.SpeedSensor tacho;
equation
  connect(u, drive.tau);
  connect(drive.flange, rotor.flange_a);
  connect(rotor.flange_b, bearing.flange_a);
  connect(bearing.flange_b, tacho.flange);
  connect(tacho.w, y);
end Shaft;
)");
    task.className = "Shaft";
    Outcome<Library> with = Library().withPath(library);
    if (with) with = with->withSource(task.model);
    EXPECT_TRUE(with) << format(with.diagnostics());
    if (with) task.library = std::move(*with);
    task.parameters = {{"rotor.J", "kg.m2", 0.06, 0.01, 0.5},
                       {"bearing.tau_pos[1,2]", "N.m", 0.5, 0.05, 1},
                       {"bearing.tau_pos[2,2]", "N.m", 0.6, 0.05, 3}};
    return task;
}

TEST(FitThroughEvents, FindsTheOptimumOfTheTableOfABearing) {
    const char* const path = std::getenv("MODELICAPATH");
    if (!path || !*path) GTEST_SKIP() << "MODELICAPATH names no directory with the Modelica Standard Library";
    EXPECT_LT(std::abs(excessOf(shaft(bearingShaft(path)))), 1e-5);
}

TEST(FitThroughEvents, FindsTheOptimumOfABouncingBall) { EXPECT_LT(excessOf(ball()), 1e-5); }

TEST(FitThroughEvents, FindsTheOptimumOfDryFriction) { EXPECT_LT(std::abs(excessOf(shaft(ownShaft()))), 1e-5); }

// Where the shaft begins to slide moves across the samples. With the one recording the misfit has a kink at its least
// value, and no step along the slopes lowers it; with the other it has two least values beside a kink.
TEST(FitThroughEvents, LooksBesideKinksWhereItIsToldTo) {
    const char* const path = std::getenv("MODELICAPATH");
    if (!path || !*path) GTEST_SKIP() << "MODELICAPATH names no directory with the Modelica Standard Library";
    Case c = shaft(bearingShaft(path));
    EXPECT_LT(std::abs(excessOf(c, 40)), 3e-6);
    EXPECT_LT(std::abs(excessOf(c, 142)), 3e-6);
    c.goesOnAtKinks = false;
    EXPECT_EQ(c.fitted(c.recorded(40)).status, FitStatus::Failed);
    EXPECT_GT(excessOf(c, 142), 1e-4);
}

TEST(FitThroughEvents, SaysWhyTheEventsDoNotGoOn) {
    Case c;
    c.task = taskOf(R"(model Limited
  parameter Real k = 1;
  Real x(start = 0, fixed = true);
  output Real y = x;
equation
  der(x) = k;
  assert(x < 0.5, "too far");
  when x > 0.2 then
    reinit(x, x);
  end when;
end Limited;
)",
                    "Limited");
    c.task.parameters = {{"k", "", 1, 0.5, 2}};
    for (int k = 0; k < 100; ++k) c.time.push_back(0.01 * k);
    const std::string message = c.fitted(std::vector<double>(100, 0.0)).message.english();
    const std::size_t reason = message.find("the events do not go on");
    ASSERT_NE(reason, std::string::npos) << message;
    const std::size_t cause = message.find("too far");
    ASSERT_NE(cause, std::string::npos) << message;
    EXPECT_LT(reason, cause);
    EXPECT_EQ(message.find("too far", cause + 1), std::string::npos) << message;
}

TEST(FitThroughEvents, StandardErrorsOfABouncingBallAreThoseOfManyRecordings) { expectRight(errorRatios(ball(), 100)); }

TEST(FitThroughEvents, StandardErrorsOfDryFrictionAreThoseOfManyRecordings) {
    expectRight(errorRatios(shaft(ownShaft()), 30));
}

TEST(FitThroughEvents, StandardErrorsOfTheTableOfABearingAreThoseOfManyRecordings) {
    const char* const path = std::getenv("MODELICAPATH");
    if (!path || !*path) GTEST_SKIP() << "MODELICAPATH names no directory with the Modelica Standard Library";
    expectRight(errorRatios(shaft(bearingShaft(path)), 10));
}

}  // namespace
}  // namespace analogon
