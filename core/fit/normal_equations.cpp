#include "core/fit/normal_equations.hpp"

#include <algorithm>
#include <cmath>

#include "core/eval/vector_code.hpp"
#include "core/simulate/all_finite.hpp"

namespace analogon {

namespace {

/// Slopes of one output at samples in a row, with the residuals there. Of both the weight is still missing in the
/// slopes.
struct Samples {
    const double* slopes;
    const double* residuals;
    int count, stride, lanes;
    double weight;
};

/// Adds the block [i, i + W) x [j, j + W) of the sum of sᵀs over the slopes s, and with i == j the part of sᵀr.
template <int W>
[[gnu::always_inline]] inline void addProducts(const Samples& of, int i, int j, double* hessian, double* gradient) {
    typedef double Vector __attribute__((vector_size(W * 8), aligned(8), may_alias));
    Vector sums[W] = {}, slope = {};
    const double* row = of.slopes;
    for (int k = 0; k < of.count; ++k, row += of.stride) {
        const Vector right = *reinterpret_cast<const Vector*>(row + j);
        for (int a = 0; a < W; ++a) sums[a] += row[i + a] * right;
        slope += of.residuals[k] * right;
    }
    const double square = of.weight * of.weight;
    for (int a = 0; a < W; ++a) *reinterpret_cast<Vector*>(hessian + (i + a) * of.lanes + j) += square * sums[a];
    if (i == j) *reinterpret_cast<Vector*>(gradient + j) += of.weight * slope;
}

template <int W>
[[gnu::always_inline]] inline void addAll(const Samples& of, double* hessian, double* gradient) {
    for (int i = 0; i < of.lanes; i += W)
        for (int j = i; j < of.lanes; j += W) addProducts<W>(of, i, j, hessian, gradient);
}

#if defined(__x86_64__)
[[gnu::target("avx512f,avx512dq,avx512vl,avx2,fma")]] void addWide(const Samples& of, double* hessian,
                                                                   double* gradient) {
    addAll<8>(of, hessian, gradient);
}
[[gnu::target("avx2,fma")]] void addNarrow(const Samples& of, double* hessian, double* gradient) {
    addAll<4>(of, hessian, gradient);
}
#endif
void addPlain(const Samples& of, double* hessian, double* gradient) { addAll<4>(of, hessian, gradient); }

}  // namespace

NormalEquations::NormalEquations(const FitExperiment& experiment, std::vector<Eigen::Index> columns)
    : experiment_(experiment), columns_(std::move(columns)) {
    lanes_ = (static_cast<int>(columns_.size()) + 3) / 4 * 4;
    slopes_.assign(static_cast<std::size_t>(lanes_), 0.0);
    for (Eigen::Index o = 0; o < experiment.measured.rows(); ++o)
        if (experiment.isFitted(o)) fitted_.push_back(static_cast<int>(o));
    restart();
}

void NormalEquations::restart() {
    const auto lanes = static_cast<std::size_t>(lanes_);
    squares_ = 0.0;
    hessian_.assign(lanes * lanes, 0.0);
    gradient_.assign(lanes, 0.0);
}

void NormalEquations::take(int sample, const double* y, const double* dy) {
    for (const int o : fitted_) {
        if (dy) std::copy_n(dy + static_cast<std::ptrdiff_t>(o) * columns_.size(), columns_.size(), slopes_.begin());
        add(o, sample, 1, y + o, slopes_.data(), 1, lanes_);
    }
}

void NormalEquations::takeRows(int first, int count, const double* rows, const RowLayout& layout, int) {
    for (const int o : fitted_)
        add(o, first, count, rows + layout.value(o), rows + layout.tangent(o), layout.resultSize(), layout.lanes);
}

void NormalEquations::add(int output, int first, int count, const double* values, const double* slopes, int stride,
                          int lanes) {
    residuals_.resize(static_cast<std::size_t>(count));
    const double weight = experiment_.weights[output];
    const Eigen::Index step = experiment_.measured.rows();
    const double* const measured = experiment_.measured.data() + first * step + output;
    double squares = 0.0;
    bool isComplete = true;
    for (int k = 0; k < count; ++k) {
        const double value = values[static_cast<std::ptrdiff_t>(k) * stride], there = measured[k * step];
        const bool isMeasured = !std::isnan(there);
        const double residual = isMeasured ? weight * (value - there) : 0.0 * value;
        isComplete = isComplete && isMeasured;
        residuals_[static_cast<std::size_t>(k)] = residual;
        squares += residual * residual;
    }
    squares_ += squares;
    if (lanes == 0) return;
    if (!isComplete) {
        blanked_.resize(static_cast<std::size_t>(count) * static_cast<std::size_t>(lanes));
        double* to = blanked_.data();
        for (int k = 0; k < count; ++k, slopes += stride) {
            const double counts = std::isnan(measured[k * step]) ? 0.0 : 1.0;
            for (int i = 0; i < lanes; ++i) *to++ = counts * slopes[i];
        }
        slopes = blanked_.data();
        stride = lanes;
    }
    auto kernel = addPlain;
#if defined(__x86_64__)
    const VectorTarget fastest = VectorCode::fastest();
    if (fastest != VectorTarget::Interpreter)
        kernel = fastest == VectorTarget::Avx512 && lanes % 8 == 0 ? addWide : addNarrow;
#endif
    kernel({slopes, residuals_.data(), count, stride, lanes, weight}, hessian_.data(), gradient_.data());
}

bool NormalEquations::isFinite() const {
    return std::isfinite(squares_) && allFinite(hessian_.data(), static_cast<Eigen::Index>(hessian_.size())) &&
           allFinite(gradient_.data(), static_cast<Eigen::Index>(gradient_.size()));
}

void NormalEquations::addTo(Eigen::MatrixXd& hessian, Eigen::VectorXd& gradient) const {
    const auto lanes = static_cast<std::size_t>(lanes_);
    for (std::size_t a = 0; a < columns_.size(); ++a) {
        gradient[columns_[a]] += gradient_[a];
        for (std::size_t b = a; b < columns_.size(); ++b) {
            hessian(columns_[a], columns_[b]) += hessian_[a * lanes + b];
            if (a != b) hessian(columns_[b], columns_[a]) += hessian_[a * lanes + b];
        }
    }
}

std::optional<ReducedMisfit> reduce(const Eigen::MatrixXd& hessian, const Eigen::VectorXd& gradient, double squares) {
    constexpr double least = 1e-9;  // squared distance of a column from those before it, both of length 1
    const Eigen::Index K = gradient.size();
    const Eigen::VectorXd lengths = hessian.diagonal().cwiseSqrt();
    ReducedMisfit result;
    result.jacobian = Eigen::MatrixXd::Zero(K + 1, K);
    result.residuals = Eigen::VectorXd::Zero(K + 1);
    Eigen::MatrixXd& R = result.jacobian;  // of columns of length 1 at first
    for (Eigen::Index j = 0; j < K; ++j) {
        if (lengths[j] == 0.0) continue;  // without any influence
        double rest = 1.0, right = gradient[j] / lengths[j];
        for (Eigen::Index i = 0; i < j; ++i) {
            if (lengths[i] == 0.0) continue;
            double sum = hessian(i, j) / (lengths[i] * lengths[j]);
            for (Eigen::Index k = 0; k < i; ++k) sum -= R(k, i) * R(k, j);
            R(i, j) = sum / R(i, i);
            rest -= R(i, j) * R(i, j);
            right -= R(i, j) * result.residuals[i];
        }
        if (!(rest > least)) return std::nullopt;
        R(j, j) = std::sqrt(rest);
        result.residuals[j] = right / R(j, j);
    }
    for (Eigen::Index j = 0; j < K; ++j) R.col(j) *= lengths[j];
    result.residuals[K] = std::sqrt(std::max(0.0, squares - result.residuals.squaredNorm()));
    result.ok = R.allFinite() && result.residuals.allFinite();
    return result;
}

}  // namespace analogon
