#include "core/fit/known_product.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/unit.hpp"
#include "core/base/unit_factors.hpp"
#include "core/fit/uncertainty.hpp"

namespace analogon {
namespace {

constexpr double nearWhole = 0.02;  // of an exponent
constexpr int mostExponent = 3;
constexpr double nearlyAsWell = 1.5;  // of the sum of the squared relative errors

/// Powers of two parameters, p^own q^other.
struct Powers {
    int own{}, other{};
};

/// The powers in which a change by these relative amounts cancels: own*a + other*b = 0. Nothing: no small whole ones
/// do.
std::optional<Powers> cancelling(double a, double b) {
    for (int own = 1; own <= mostExponent; ++own) {
        const double other = -own * a / b;
        const int whole = static_cast<int>(std::lround(other));
        if (whole != 0 && std::abs(whole) <= mostExponent && std::abs(other - whole) < nearWhole)
            return Powers{own, whole};
    }
    return std::nullopt;
}

std::string powerText(const std::string& name, int power) {
    return power == 1 ? name : fmt::format("{}^{}", name, power);
}

std::string nameOf(const std::string& own, const std::string& other, Powers powers) {
    return powerText(own, powers.own) + (powers.other < 0 ? "/" : "*") + powerText(other, std::abs(powers.other));
}

/// Of the product of powers: the shorter of "J/W" and "s".
std::string unitOf(const std::string& own, const std::string& other, Powers powers) {
    const auto factors = [](const std::string& unit) {
        return unit.empty() || unit == "1" ? std::optional(UnitFactors()) : UnitFactors::of(unit);
    };
    const auto a = factors(own), b = factors(other);
    if (!a || !b) return {};
    std::string product = UnitFactors().times(*a, powers.own).times(*b, powers.other).text();
    const std::optional<Dimension> dimension = dimensionOf(product);
    if (!dimension) return product;
    std::string basic = text(*dimension);
    const Outcome<UnitConversion> toBasic = convertUnit(product, basic);
    const bool isSame = toBasic && toBasic->factor == 1 && toBasic->offset == 0;
    return isSame && basic.size() < product.size() ? basic : product;
}

/// All products with one of the parameters; empty: not all of them are known.
std::vector<KnownProduct> relatedTo(Eigen::Index reference, const std::vector<Eigen::Index>& involved,
                                    const std::vector<FittedValue>& parameters, const Eigen::VectorXd& direction,
                                    const Eigen::MatrixXd& covariance) {
    const auto at = [&](Eigen::Index i) -> const FittedValue& { return parameters[static_cast<std::size_t>(i)]; };
    const FittedValue& other = at(reference);
    std::vector<KnownProduct> products;
    for (const Eigen::Index i : involved) {
        if (i == reference) continue;
        const FittedValue& own = at(i);
        const auto powers = cancelling(direction[i] / own.value, direction[reference] / other.value);
        if (!powers) return {};
        Eigen::VectorXd slope = Eigen::VectorXd::Zero(covariance.rows());  // of the logarithm of the product
        slope[i] = powers->own / own.value;
        slope[reference] = powers->other / other.value;
        const double value = std::pow(own.value, powers->own) * std::pow(other.value, powers->other);
        products.push_back({nameOf(own.name, other.name, *powers), value,
                            value * std::sqrt(std::max(0.0, slope.dot(covariance * slope))),
                            unitOf(own.unit, other.unit, *powers)});
    }
    return products;
}

double relativeSquares(const std::vector<KnownProduct>& products) {
    double sum = 0;
    for (const KnownProduct& p : products) sum += std::pow(p.standardError / p.value, 2);
    return sum;
}

std::size_t unitLength(const std::vector<KnownProduct>& products) {
    std::size_t length = 0;
    for (const KnownProduct& p : products) length += p.unit.size();
    return length;
}

/// Of one direction: those that are known best, or nearly as well in simpler units.
std::vector<KnownProduct> bestRelated(const std::vector<FittedValue>& parameters, const Eigen::VectorXd& direction,
                                      const Eigen::MatrixXd& covariance) {
    std::vector<Eigen::Index> involved;
    for (Eigen::Index i = 0; i < direction.size(); ++i) {
        if (direction[i] == 0) continue;
        if (!(parameters[static_cast<std::size_t>(i)].value > 0)) return {};
        involved.push_back(i);
    }
    std::vector<std::vector<KnownProduct>> all;
    double least = std::numeric_limits<double>::infinity();
    for (const Eigen::Index reference : involved) {
        all.push_back(relatedTo(reference, involved, parameters, direction, covariance));
        if (!all.back().empty()) least = std::min(least, relativeSquares(all.back()));
    }
    std::erase_if(all, [&](const auto& p) { return p.empty() || relativeSquares(p) > nearlyAsWell * least; });
    const auto best = std::min_element(all.begin(), all.end(),
                                       [](const auto& a, const auto& b) { return unitLength(a) < unitLength(b); });
    return best == all.end() ? std::vector<KnownProduct>() : *best;
}

bool shareParameters(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    return (a.array() != 0 && b.array() != 0).any();
}

}  // namespace

std::vector<KnownProduct> knownProducts(const std::vector<FittedValue>& parameters,
                                        const std::vector<Eigen::VectorXd>& directions,
                                        const Eigen::MatrixXd& covariance) {
    std::vector<KnownProduct> known;
    for (const Eigen::VectorXd& direction : directions) {
        const bool isAlone = std::none_of(directions.begin(), directions.end(), [&](const Eigen::VectorXd& other) {
            return &other != &direction && shareParameters(direction, other);
        });
        if (!isAlone) continue;
        for (KnownProduct& p : bestRelated(parameters, direction, covariance)) known.push_back(std::move(p));
    }
    return known;
}

namespace {

/// value = f(a, b) with the slopes of f.
KnownProduct combined(std::string name, double value, const Eigen::Vector2d& slope, const Eigen::Matrix2d& covariance,
                      std::string unit) {
    return {std::move(name), value, std::sqrt(std::max(0.0, slope.dot(covariance * slope))), std::move(unit)};
}

double relativeError(const KnownProduct& p) { return p.standardError / std::abs(p.value); }

std::vector<KnownProduct> combinationsOf(const FittedValue& a, const FittedValue& b,
                                         const Eigen::Matrix2d& covariance) {
    std::vector<KnownProduct> all;
    const double x = a.value, y = b.value;
    if (a.unit == b.unit) {
        all.push_back(combined(a.name + " + " + b.name, x + y, {1, 1}, covariance, a.unit));
        all.push_back(combined(a.name + " - " + b.name, x - y, {1, -1}, covariance, a.unit));
    }
    if (x > 0 && y > 0) {
        all.push_back(combined(a.name + "*" + b.name, x * y, {y, x}, covariance, unitOf(a.unit, b.unit, {1, 1})));
        all.push_back(
            combined(a.name + "/" + b.name, x / y, {1 / y, -x / (y * y)}, covariance, unitOf(a.unit, b.unit, {1, -1})));
    }
    return all;
}

}  // namespace

std::vector<KnownProduct> knownOfPairs(const std::vector<FittedValue>& parameters, const Eigen::MatrixXd& covariance) {
    constexpr double uncertain = 0.1, farBetter = 0.1;
    std::vector<KnownProduct> known;
    for (Eigen::Index i = 0; i < covariance.rows(); ++i)
        for (Eigen::Index j = i + 1; j < covariance.rows(); ++j) {
            const FittedValue &a = parameters[static_cast<std::size_t>(i)],
                              &b = parameters[static_cast<std::size_t>(j)];
            const Eigen::Matrix2d both{{covariance(i, i), covariance(i, j)}, {covariance(j, i), covariance(j, j)}};
            if (!both.allFinite() || a.value == 0 || b.value == 0) continue;
            const double least =
                std::min(std::sqrt(both(0, 0)) / std::abs(a.value), std::sqrt(both(1, 1)) / std::abs(b.value));
            const double correlation = both(0, 1) / std::sqrt(both(0, 0) * both(1, 1));
            if (!(least > uncertain) && !(std::abs(correlation) > hardlyToldApart)) continue;
            const std::vector<KnownProduct> all = combinationsOf(a, b, both);
            const auto best = std::min_element(
                all.begin(), all.end(),
                [](const KnownProduct& p, const KnownProduct& q) { return relativeError(p) < relativeError(q); });
            if (best != all.end() && relativeError(*best) < farBetter * least) known.push_back(*best);
        }
    return known;
}

}  // namespace analogon
