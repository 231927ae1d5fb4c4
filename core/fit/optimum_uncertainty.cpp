#include "core/fit/optimum_uncertainty.hpp"

#include <algorithm>

#include "core/base/number_text.hpp"
#include "core/base/unit.hpp"
#include "core/fit/known_product.hpp"
#include "core/fit/rounding.hpp"

namespace analogon {

namespace {

/// What no parameter moves says nothing of the scatter of what is fitted: it may be off by any amount, or be at rest.
struct Unmoved {
    double squares{};
    Eigen::Index count{};
};

Unmoved unmovedChannels(const FitProblem& problem, const Linearisation& optimum) {
    Unmoved unmoved;
    Eigen::Index row = 0;
    for (const FitExperiment& e : problem.experiments)
        for (Eigen::Index o = 0; o < e.measured.rows(); ++o) {
            if (!e.isFitted(o)) continue;
            const Eigen::Index count = e.measured.cols() - e.measured.row(o).array().isNaN().count();
            if (optimum.jacobian.middleRows(row, count).isZero(0.0)) {
                unmoved.squares += optimum.residuals.segment(row, count).squaredNorm();
                unmoved.count += count;
            }
            row += count;
        }
    return unmoved;
}

/// What is known of parameters that cannot be told apart.
void addKnownProducts(const FitProblem& problem, const std::vector<std::string>& names, const Eigen::VectorXd& values,
                      Uncertainty& uncertainty) {
    std::vector<FittedValue> parameters;
    for (std::size_t i = 0; i < names.size(); ++i)
        parameters.push_back({names[i], values[static_cast<Eigen::Index>(i)], problem.parameters[i].unit});
    for (const KnownProduct& p : knownProducts(parameters, uncertainty.unseen, uncertainty.seen))
        uncertainty.remarks.push_back(phrase("of these only {} is known: {}", p.name,
                                             valueText(p.value, p.standardError) + behindNumber(p.unit)));
    for (const KnownProduct& p : knownOfPairs(parameters, uncertainty.covariance))
        uncertainty.remarks.push_back(phrase("{} is known far better than either: {}", p.name,
                                             valueText(p.value, p.standardError) + behindNumber(p.unit)));
}

}  // namespace

OptimumUncertainty uncertaintyAt(const FitProblem& problem, const std::vector<std::string>& names,
                                 const Eigen::VectorXd& values, const Linearisation& optimum,
                                 const Eigen::MatrixXd& factor, double squares, std::optional<double> ofLoss) {
    const auto K = static_cast<Eigen::Index>(problem.parameters.size());
    const bool hasSlopes = optimum.ok && optimum.jacobian.cols() == K;
    const Unmoved unmoved = hasSlopes ? unmovedChannels(problem, optimum) : Unmoved();
    const auto freedom = static_cast<double>(problem.residualCount() - K - unmoved.count);
    double variance = freedom > 0 ? std::max(0.0, squares - unmoved.squares) / freedom : 1.0;
    if (ofLoss) variance = *ofLoss;
    if (problem.weightsAreNoise) variance = std::max(variance, 1.0);
    OptimumUncertainty found{uncertaintyOf(beyondRounding(problem, values, factor), variance, names), variance};
    addKnownProducts(problem, names, values, found.uncertainty);
    return found;
}

}  // namespace analogon
