#include "core/residual/quantisation.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/median.hpp"

namespace analogon {

double quantisationStep(const Eigen::Ref<const Eigen::VectorXd>& measured) {
    std::vector<double> values;
    for (const double x : measured)
        if (!std::isnan(x)) values.push_back(x);
    const std::size_t count = values.size();
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    // a fine channel hardly ever takes the same value twice
    if (values.size() < 3 || values.size() * 4 > count) return 0;
    std::vector<double> gaps;
    for (std::size_t i = 1; i < values.size(); ++i) gaps.push_back(values[i] - values[i - 1]);
    return median(std::move(gaps));
}

double quantisationNoise(const Eigen::Ref<const Eigen::VectorXd>& measured) {
    return quantisationStep(measured) / std::sqrt(12.0);
}

}  // namespace analogon
