#include "core/effect/block/law_term.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/effect/model/score.hpp"
#include "core/effect/thresholds.hpp"
#include "core/syntax/printer.hpp"

namespace analogon {

using namespace threshold::law;
using threshold::acceptance::simplerKeeps;

namespace {

constexpr double roundedSpeed = 0.01;  // of the largest: where the sign of a speed turns over

std::optional<UnitFactors> power(const std::optional<UnitFactors>& unit, int exponent) {
    if (!unit) return std::nullopt;
    return unit->toThe(exponent);
}

std::optional<UnitFactors> product(const std::optional<UnitFactors>& a, const std::optional<UnitFactors>& b) {
    if (!a || !b) return std::nullopt;
    return a->times(*b);
}

/// Smooth stand-in for the sign of a quantity.
std::string signText(const LawQuantity& q) {
    return fmt::format("{0}/sqrt({0}^2 + {1}^2)", q.name, syntax::printNumber(roundedSpeed * q.largest()));
}

/// The terms of one node against the residual: traces without what the parameters can imitate.
class TermChoice {
public:
    TermChoice(const NullModel& null, const std::vector<Term>& terms, const Eigen::MatrixXd& columns)
        : terms_(terms), residual_(null.fit.optimum.residuals), lengths_(columns.colwise().norm().transpose()) {
        columns_ = null.scores().plain(columns);
    }

    std::vector<TermSet> likeliest() const {
        std::vector<TermSet> sets;
        std::vector<Eigen::VectorXd> directions;
        const std::vector<double> gains = gainsOver(residual_, columns_);
        for (const std::size_t j : bestFirst(gains)) {
            if (sets.size() == mostSingles || !isMoreThanChance(gains[j], residual_)) break;
            const Eigen::VectorXd direction = columns_.col(static_cast<Eigen::Index>(j)).normalized();
            const bool isKnown = std::any_of(directions.begin(), directions.end(), [&](const Eigen::VectorXd& d) {
                return std::abs(d.dot(direction)) > sameTrace;
            });
            if (isKnown) continue;
            directions.push_back(direction);
            sets.push_back({{j}, gains[j]});
        }
        if (sets.empty()) return sets;
        const Eigen::VectorXd& first = directions.front();
        const Eigen::VectorXd left = residual_ - first * first.dot(residual_);
        const std::vector<double> further = gainsOver(left, columns_ - first * (first.transpose() * columns_));
        const std::size_t second = bestFirst(further).front();
        if (isMoreThanChance(further[second], left) && further[second] > formShare * sets.front().explained)
            sets.push_back({{sets.front().terms.front(), second}, sets.front().explained + further[second]});
        return sets;
    }

private:
    std::vector<double> gainsOver(const Eigen::VectorXd& residual, const Eigen::MatrixXd& columns) const {
        std::vector<double> gains(static_cast<std::size_t>(columns.cols()));
        for (Eigen::Index j = 0; j < columns.cols(); ++j) {
            const double norm = columns.col(j).norm();
            if (!std::isfinite(norm) || !(norm > leastVisible * lengths_[j])) continue;
            const double along = columns.col(j).dot(residual) / norm;
            gains[static_cast<std::size_t>(j)] = along * along;
        }
        return gains;
    }

    /// By what they explain; of those that explain nearly the same, the simpler first.
    std::vector<std::size_t> bestFirst(const std::vector<double>& gains) const {
        std::vector<std::size_t> order(gains.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        const auto worth = [&](std::size_t j) { return gains[j] * std::pow(simplerKeeps, terms_[j].complexity); };
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return worth(a) > worth(b); });
        return order;
    }

    /// Whether a term stands is decided when it is fitted; this keeps out what chance brings among so many.
    bool isMoreThanChance(double gain, const Eigen::VectorXd& residual) const {
        const double rows = static_cast<double>(residual.size());
        const double evidence = gain / ((residual.squaredNorm() - gain) / rows) - std::log(rows) -
                                2 * std::log(static_cast<double>(terms_.size()));
        return evidence > equivalenceMargin;
    }

    const std::vector<Term>& terms_;
    const Eigen::VectorXd& residual_;
    Eigen::VectorXd lengths_;
    Eigen::MatrixXd columns_;
};

}  // namespace

void addPowers(const LawQuantity& q, bool withSign, int complexity, std::vector<Term>& terms) {
    terms.push_back({q.name, q.shown, q.unit, complexity});
    terms.push_back(
        {fmt::format("{0}*abs({0})", q.name), fmt::format("{0}*abs({0})", q.shown), power(q.unit, 2), complexity});
    terms.push_back({q.name + "^2", q.shown + "^2", power(q.unit, 2), complexity});
    terms.push_back({q.name + "^3", q.shown + "^3", power(q.unit, 3), complexity});
    terms.push_back({fmt::format("abs({})", q.name), fmt::format("abs({})", q.shown), q.unit, complexity});
    if (withSign) terms.push_back({signText(q), fmt::format("sign({})", q.shown), UnitFactors(), complexity});
}

Term productOf(const LawQuantity& a, const LawQuantity& b, int complexity) {
    return {a.name + "*" + b.name, a.shown + "*" + b.shown, product(a.unit, b.unit), complexity};
}

void addProducts(const LawQuantity& a, const LawQuantity& b, bool withSign, int complexity, std::vector<Term>& terms) {
    terms.push_back(productOf(a, b, complexity));
    const std::optional<UnitFactors> both = terms.back().unit;
    terms.push_back(
        {fmt::format("{}*abs({})", a.name, b.name), fmt::format("{}*abs({})", a.shown, b.shown), both, complexity});
    terms.push_back({fmt::format("{}*{}^2", a.name, b.name), fmt::format("{}*{}^2", a.shown, b.shown),
                     product(both, b.unit), complexity});
    if (withSign)
        terms.push_back({fmt::format("({})*abs({})", signText(a), b.name),
                         fmt::format("sign({})*abs({})", a.shown, b.shown), b.unit, complexity});
}

void addHinges(const LawQuantity& q, const Range& range, std::vector<Term>& terms) {
    for (const double part : {0.3, 0.5, 0.65, 0.8, 0.9}) {
        const std::string high = fmt::format("{:.4g}", range.low + part * range.width()),
                          low = fmt::format("{:.4g}", range.high - part * range.width());
        terms.push_back({fmt::format("max(0, {} - ({}))", q.name, high),
                         fmt::format("max(0, {} - ({}))", q.shown, high), q.unit, 2});
        terms.push_back(
            {fmt::format("min(0, {} - ({}))", q.name, low), fmt::format("min(0, {} - ({}))", q.shown, low), q.unit, 2});
    }
}

void addWaves(const LawQuantity& q, std::vector<Term>& terms) {
    for (int n = 1; n <= mostWaves; ++n)
        for (const char* wave : {"sin", "cos"}) {
            const std::string times = n == 1 ? "" : std::to_string(n) + "*";
            terms.push_back({fmt::format("{}({}{})", wave, times, q.name),
                             fmt::format("{}({}{})", wave, times, q.shown), UnitFactors(), n});
        }
}

std::vector<TermSet> likeliestSets(const NullModel& null, const std::vector<Term>& terms,
                                   const Eigen::MatrixXd& columns) {
    return TermChoice(null, terms, columns).likeliest();
}

Series movingSeries(const NullModel& null, const PreparedTask& held, const std::vector<std::string>& names,
                    const SimulationOptions& simulation) {
    Series values;
    for (const Trajectory& t : observe(null, held, names, simulation)) {
        if (t.failure.failed || t.observed.rows() != static_cast<Eigen::Index>(names.size())) return {};
        for (std::size_t i = 0; i < names.size(); ++i)
            values[names[i]].push_back(t.observed.row(static_cast<Eigen::Index>(i)).transpose());
    }
    std::erase_if(values, [](const auto& each) {
        Range range;
        for (const Eigen::VectorXd& v : each.second) range.take(rangeOf(v));
        return !(range.width() > 1e-9 * std::max(std::abs(range.low), std::abs(range.high)));
    });
    return values;
}

double originOf(const Eigen::VectorXd& values) {
    if (std::abs(values[0]) < 1e-6 * values.cwiseAbs().maxCoeff()) return 0;
    const double scale = std::pow(10.0, std::floor(std::log10(std::abs(values[0]))) - 3);
    return scale * std::round(values[0] / scale);
}

NamedUnits quantitiesOf(const System& system) {
    NamedUnits names;
    const auto add = [&](const std::vector<SignalInfo>& signals) {
        for (const SignalInfo& s : signals)
            if (std::none_of(names.begin(), names.end(), [&](const auto& n) { return n.first == s.name; }))
                names.emplace_back(s.name, s.unit);
    };
    add(system.inputs());
    add(system.outputs());
    add(system.states());
    return names;
}

LawQuantity quantityOf(std::string name, std::string variable, std::string shown, const std::string& unit,
                       const std::vector<Eigen::VectorXd>& values, double origin) {
    LawQuantity q{std::move(name), std::move(variable), std::move(shown), UnitFactors::of(unit), {}, origin};
    for (const Eigen::VectorXd& v : values) q.range.take(rangeOf(v));
    q.range.low -= origin;
    q.range.high -= origin;
    // the class takes the difference to the origin
    if (origin != 0) q.shown = fmt::format("({} {} {:.6g})", q.shown, origin < 0 ? "+" : "-", std::abs(origin));
    return q;
}

}  // namespace analogon
