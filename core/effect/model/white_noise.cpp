#include "core/effect/model/white_noise.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/median.hpp"
#include "core/effect/thresholds.hpp"

namespace analogon {

using namespace threshold::noise;

namespace {

constexpr Eigen::Index fewest = 50;  // samples

}  // namespace

double whiteNoise(const Eigen::VectorXd& signal) {
    const Eigen::Index count = signal.size() - 2;
    if (count < fewest || !signal.allFinite()) return 0;
    const Eigen::VectorXd second = signal.tail(count) - 2 * signal.segment(1, count) + signal.head(count);
    std::vector<double> sizes;
    for (const double d : second) sizes.push_back(std::abs(d));
    const double spread = median(std::move(sizes)) / 0.6745;
    if (!(spread > 1e-9 * signal.cwiseAbs().maxCoeff())) return 0;
    double products = 0, squares = 0;
    for (Eigen::Index k = 0; k + 1 < count; ++k) {
        if (std::max(std::abs(second[k]), std::abs(second[k + 1])) > outlier * spread) continue;
        products += second[k] * second[k + 1];
        squares += 0.5 * (second[k] * second[k] + second[k + 1] * second[k + 1]);
    }
    return -products > leastAlternation * squares ? spread / std::sqrt(6.0) : 0;
}

}  // namespace analogon
