#include "core/fit/profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/parallel.hpp"
#include "core/fit/coordinates.hpp"
#include "core/fit/held_value.hpp"

namespace analogon {

namespace {

constexpr double threshold = profileThreshold;
constexpr int mostPoints = 40;  // of one side

/// The problem without one of its parameters, which is held at a value.
FitProblem held(const FitProblem& problem, int parameter, double value, const Eigen::VectorXd& others, double scatter) {
    FitProblem rest = problem;
    rest.scatter = scatter;
    const FitParameter p = problem.parameters[static_cast<std::size_t>(parameter)];
    rest.parameters.erase(rest.parameters.begin() + parameter);
    for (std::size_t i = 0; i < rest.parameters.size(); ++i) {
        FitParameter& other = rest.parameters[i];
        other.start = std::clamp(others[static_cast<Eigen::Index>(i)], other.min, other.max);
    }
    for (std::size_t e = 0; e < rest.experiments.size(); ++e) {
        if (p.experiment >= 0 && p.experiment != static_cast<int>(e)) continue;
        hold(rest.experiments[e], p.name, value);
    }
    return rest;
}

struct Point {
    double q{};     // the parameter, or its logarithm
    double rise{};  // of the cost, in units of half the variance
};

/// One side of a profile.
struct Side {
    std::vector<Point> points;  // outwards, without the optimum
    bool isCrossed{}, isFailed{};
    double end{};  // q where it crosses, or how far it was followed
};

class Walk {
public:
    Walk(const FitProblem& problem, const FitResult& best, int parameter, const FitOptions& options,
         const Progress& progress, double direction)
        : problem_(problem),
          best_(best),
          parameter_(parameter),
          options_(options),
          progress_(progress),
          direction_(direction),
          isLogarithmic_(Coordinates(atOptimum(problem, best)).isLogarithmic(parameter)) {
        options_.starts = options_.threads = 1;
        options_.keepsOptimum = false;
        const FitParameter& p = problem.parameters[static_cast<std::size_t>(parameter)];
        origin_ = toQ(best.values[parameter]);
        const double bound = direction < 0 ? p.min : p.max;
        const double size = std::abs(best.values[parameter]), error = best.estimates[index()].standardError;
        // Without a bound: a factor of a million, or a thousand times the size.
        limit_ = isLogarithmic_ ? std::log(1e6) : 1e3 * std::max({size, error > 0.0 ? error : 0.0, 1e-300});
        if (!Coordinates::isOpen(bound) && !(isLogarithmic_ && bound <= 0.0)) limit_ = std::abs(toQ(bound) - origin_);
        step_ = isLogarithmic_ ? 0.1 : 0.1 * (size > 0.0 ? size : limit_);
        if (error > 0.0) step_ = 0.5 * (isLogarithmic_ ? error / size : error);
        step_ = std::min(step_, limit_);
    }

    double value(double q) const { return isLogarithmic_ ? std::exp(q) : q; }

    /// Outwards until the threshold is crossed; each step aims at a fifth of it.
    Side follow() {
        Side side;
        others_ = without(best_.values);
        Point last{origin_, 0.0};
        while (static_cast<int>(side.points.size()) < mostPoints && !progress_.stopRequested()) {
            const double walked = std::min(std::abs(last.q - origin_) + step_, limit_);
            if (walked <= std::abs(last.q - origin_)) break;
            const Point point = at(origin_ + direction_ * walked);
            if (std::isnan(point.rise)) {
                side.isFailed = true;
                break;
            }
            side.points.push_back(point);
            if (point.rise >= threshold) {
                side.isCrossed = true;
                side.end = crossing(last, point, side.points);
                return side;
            }
            const double gained =
                std::max(std::sqrt(std::max(point.rise, 0.0)) - std::sqrt(std::max(last.rise, 0.0)), 0.0);
            step_ *= std::clamp(0.2 * std::sqrt(threshold) / std::max(gained, 1e-12), 0.5, 2.0);
            last = point;
        }
        side.end = last.q;
        return side;
    }

private:
    static std::vector<FitParameter> atOptimum(const FitProblem& problem, const FitResult& best) {
        std::vector<FitParameter> parameters = problem.parameters;
        for (std::size_t i = 0; i < parameters.size(); ++i)
            parameters[i].start = best.values[static_cast<Eigen::Index>(i)];
        return parameters;
    }
    std::size_t index() const { return static_cast<std::size_t>(parameter_); }
    double toQ(double v) const { return isLogarithmic_ ? std::log(v) : v; }

    Eigen::VectorXd without(const Eigen::VectorXd& values) const {
        Eigen::VectorXd others(values.size() - 1);
        others << values.head(parameter_), values.tail(values.size() - 1 - parameter_);
        return others;
    }

    /// The others are fitted from where they were at the point before. NaN: no fit.
    Point at(double q) {
        const FitParameter& p = problem_.parameters[index()];
        const double here = std::clamp(value(q), p.min, p.max);
        const FitResult fitted = fit(held(problem_, parameter_, here, others_, best_.scatter), options_, progress_);
        const bool isFit = fitted.status == FitStatus::Converged || fitted.status == FitStatus::IterationLimit;
        if (!isFit || !std::isfinite(fitted.cost)) return {q, std::nan("")};
        if (fitted.values.size() > 0) others_ = fitted.values;
        const double known = p.prior ? best_.scatter * p.prior->distance(here) : 0.0;
        return {q, (2.0 * (fitted.cost - best_.cost) + known * known) / best_.variance};
    }

    /// The root of the rise is nearly straight: a secant step, and one more where it is not.
    double crossing(Point inside, Point outside, std::vector<Point>& points) {
        const auto root = [](const Point& p) { return std::sqrt(std::max(p.rise, 0.0)); };
        const auto secant = [&] {
            const double fraction = (std::sqrt(threshold) - root(inside)) / (root(outside) - root(inside));
            return inside.q + fraction * (outside.q - inside.q);
        };
        for (int round = 0; round < 3; ++round) {
            const Point between = at(secant());
            if (std::isnan(between.rise)) break;
            points.push_back(between);
            (between.rise < threshold ? inside : outside) = between;
            if (std::abs(between.rise - threshold) < 2e-3 * threshold) break;
        }
        return secant();
    }

    const FitProblem& problem_;
    const FitResult& best_;
    int parameter_{};
    FitOptions options_;
    const Progress& progress_;
    double direction_{};
    bool isLogarithmic_{};
    double origin_{}, limit_{}, step_{};
    Eigen::VectorXd others_;
};

std::string openWords(const std::string& name, const Side& side, double end, const char* which, const char* way) {
    if (side.isFailed)
        return fmt::format("the {} limit of {} could not be followed beyond {:.6g}: the fits fail there", which, name,
                           end);
    if (side.points.empty()) return fmt::format("{} rests at its {} bound {:.6g}", name, which, end);
    const double rise = side.points.back().rise;
    return fmt::format("these data set no {} limit to {}: {} to {:.6g} the misfit {}", which, name, way, end,
                       rise < 0.1 * threshold ? "hardly rises (a flat valley)" : "rises too little");
}

}  // namespace

ConfidenceInterval profile(const FitProblem& problem, const FitResult& best, int parameter, const FitOptions& options,
                           const Progress& progress) {
    ConfidenceInterval interval;
    interval.lower = interval.upper = best.values[parameter];
    if (!std::isfinite(best.cost) || !(best.variance > 0.0)) {
        interval.isOpenBelow = interval.isOpenAbove = true;
        interval.remark = "there is no fit to start from";
        return interval;
    }
    Walk down(problem, best, parameter, options, progress, -1.0), up(problem, best, parameter, options, progress, 1.0);
    Side below, above;
    parallelFor(2, std::max(1, options.threads), [&](int side) {
        if (side == 0) {
            below = down.follow();
        } else {
            above = up.follow();
        }
    });
    interval.lower = down.value(below.end);
    interval.upper = up.value(above.end);
    interval.isOpenBelow = !below.isCrossed;
    interval.isOpenAbove = !above.isCrossed;

    for (Point& point : below.points) point.q = down.value(point.q);
    for (Point& point : above.points) point.q = up.value(point.q);
    std::vector<Point> points{{best.values[parameter], 0.0}};
    points.insert(points.end(), below.points.begin(), below.points.end());
    points.insert(points.end(), above.points.begin(), above.points.end());
    std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) { return a.q < b.q; });
    double least = 0.0;
    for (const Point& point : points) {
        interval.values.push_back(point.q);
        interval.rises.push_back(point.rise);
        least = std::min(least, point.rise);
    }
    const std::string& name = problem.parameters[static_cast<std::size_t>(parameter)].name;
    const auto add = [&](const std::string& words) {
        interval.remark += (interval.remark.empty() ? "" : "; ") + words;
    };
    if (progress.stopRequested()) {
        add("cancelled");
    } else {
        if (interval.isOpenBelow) add(openWords(name, below, interval.lower, "lower", "down"));
        if (interval.isOpenAbove) add(openWords(name, above, interval.upper, "upper", "up"));
    }
    if (least < -0.1 * threshold) add("the fit was not at its optimum: the misfit falls along the way");
    return interval;
}

}  // namespace analogon
