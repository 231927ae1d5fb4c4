#include <algorithm>
#include <cmath>

#include "core/simulate/step_method.hpp"

namespace analogon {

namespace {

constexpr double kRoundingOfStep = 1e-13;  // of what a Newton step changes

}  // namespace

const Esdirk::Tableau& Esdirk::tableau() {
    static const Tableau table = [] {
        // L-stability of a stiffly accurate method of this shape fixes g; Newton from nearby.
        double g = 0.43;
        for (int i = 0; i < 50; ++i) {
            g -= (((6.0 * g - 18.0) * g + 9.0) * g - 1.0) / ((18.0 * g - 36.0) * g + 9.0);
        }
        Tableau t;
        t.c[1] = 2.0 * g;
        t.c[2] = 0.6;
        t.c[3] = 1.0;
        for (int i = 1; i < stages; ++i) t.a[i][i] = g;
        t.a[1][0] = g;
        t.a[2][1] = t.c[2] * (t.c[2] - 2.0 * g) / (4.0 * g);  // stage order 2: sum a c = c^2 / 2
        t.a[2][0] = t.c[2] - g - t.a[2][1];
        // sum b c = 1/2 and sum b c^2 = 1/3 for the weights of the two inner stages
        const double first = 0.5 - g, second = 1.0 / 3.0 - g;
        t.a[3][2] = (second - first * t.c[1]) / (t.c[2] * (t.c[2] - t.c[1]));
        t.a[3][1] = (first - t.a[3][2] * t.c[2]) / t.c[1];
        t.a[3][0] = 1.0 - g - t.a[3][1] - t.a[3][2];
        return t;
    }();
    return table;
}

Esdirk::Esdirk(Dynamics& dynamics, InputSlots& slots, const SimulationOptions& options)
    : dynamics_(dynamics), slots_(slots), jacobian_(dynamics) {
    const Dynamics::Shape& shape = dynamics.shape();
    n_ = shape.states;
    K_ = shape.directions;
    // Far below the discretisation error: a misfit must be smooth in the parameters.
    tolerance_ = std::clamp(1e-4 * options.relativeTolerance, 1e-13, 1e-8);
    const auto n = static_cast<std::size_t>(n_), K = static_cast<std::size_t>(K_);
    u_.resize(static_cast<std::size_t>(shape.slots));
    if (slots.hasTangents()) du_.resize(static_cast<std::size_t>(shape.slots) * K);
    for (std::vector<double>* v : {&base_, &stage_, &slope_, &delta_, &trial_, &trialSlope_, &trialDelta_, &savedX_}) {
        v->resize(n);
    }
    scale_.resize(n);
    forgetScale();
    slopes_.resize(stages * n);
    for (std::vector<double>* v : {&tangentBase_, &endTangents_, &savedDx_}) v->resize(n * K);
    tangentSlopes_.resize(stages * n * K);
}

/// A state that has not moved yet is judged against a small part of its nominal value, else the rounding of its
/// neighbours would keep its stages from converging.
void Esdirk::forgetScale() {
    const std::vector<double>& nominal = dynamics_.shape().stateNominal;
    std::transform(nominal.begin(), nominal.end(), scale_.begin(), [](double x) { return 1e-6 * x; });
}

bool Esdirk::step(int interval, double t, double h, double* x, double* dx) {
    if (interval != interval_ && interval_ >= 0 && slots_.gaps().has(interval_)) forgetScale();
    interval_ = interval;
    // Halve on failure: the pieces of the step still to do, depth counted in halvings.
    double done = 0.0;
    int depth = 0;
    while (done < 1.0) {
        const double piece = std::ldexp(1.0, -depth);
        if (attempt(interval, t + done * h, piece * h, x, dx)) {
            std::copy(stage_.begin(), stage_.end(), x);
            if (K_ > 0) std::copy(endTangents_.begin(), endTangents_.end(), dx);
            done += piece;
            // Back to a longer piece once it fits on its own boundary.
            while (depth > 0 && std::fmod(done, std::ldexp(1.0, 1 - depth)) == 0.0) --depth;
        } else if (++depth > maxDepth_) {
            return false;
        }
    }
    return true;
}

bool Esdirk::attempt(int interval, double t, double h, const double* x, const double* dx) {
    const Tableau& table = tableau();
    const auto n = static_cast<std::size_t>(n_);
    const std::size_t block = n * static_cast<std::size_t>(K_);
    const double hg = h * table.a[1][1];
    culprit_ = -1;
    double* const du = du_.empty() ? nullptr : du_.data();

    slots_.at(interval, t, u_.data(), du);
    const bool ok = K_ > 0 ? dynamics_.derivatives(t, x, dx, u_.data(), du, slopes_.data(), tangentSlopes_.data())
                           : dynamics_.derivatives(t, x, u_.data(), slopes_.data());
    if (!ok) {
        reason_ = "not finite";
        return false;
    }
    for (std::size_t i = 0; i < n; ++i) {
        scale_[i] = std::max({scale_[i], std::abs(x[i]), 1e-3 * h * std::abs(slopes_[i])});
    }
    for (int s = 1; s < stages; ++s) {
        const double time = t + table.c[s] * h;
        slots_.at(interval, time, u_.data(), du);
        std::copy(x, x + n, base_.begin());
        for (int j = 0; j < s; ++j) {
            const double factor = h * table.a[s][j];
            const double* slope = slopes_.data() + static_cast<std::size_t>(j) * n;
            for (std::size_t i = 0; i < n; ++i) base_[i] += factor * slope[i];
        }
        const double* previous = slopes_.data() + static_cast<std::size_t>(s - 1) * n;
        for (std::size_t i = 0; i < n; ++i) stage_[i] = base_[i] + hg * previous[i];
        if (!solveStage(time, hg)) return false;
        double* slope = slopes_.data() + static_cast<std::size_t>(s) * n;
        for (std::size_t i = 0; i < n; ++i) slope[i] = (stage_[i] - base_[i]) / hg;
        if (K_ == 0) continue;

        std::copy(dx, dx + block, tangentBase_.begin());
        for (int j = 0; j < s; ++j) {
            const double factor = h * table.a[s][j];
            const double* tangents = tangentSlopes_.data() + static_cast<std::size_t>(j) * block;
            for (std::size_t i = 0; i < block; ++i) tangentBase_[i] += factor * tangents[i];
        }
        if (!stageTangents(s, time, hg)) return false;
    }
    return true;
}

/// (I - hg J) dX = dBase + hg F, with F the derivative of f at held states; then dSlope = (dX - dBase) / hg.
bool Esdirk::stageTangents(int stage, double t, double hg) {
    const auto n = static_cast<std::size_t>(n_), K = static_cast<std::size_t>(K_);
    if (!jacobian_.linearise(t, stage_.data(), u_.data(), du_.empty() ? nullptr : du_.data(), slope_.data())) {
        reason_ = "not finite";
        return false;
    }
    if (!factorise(hg)) return false;
    for (std::size_t i = 0; i < n; ++i) {
        const double* const held = jacobian_.held(static_cast<int>(i));
        for (std::size_t k = 0; k < K; ++k) endTangents_[i * K + k] = tangentBase_[i * K + k] + hg * held[k];
    }
    jacobian_.solve(endTangents_.data(), K_);
    double* slopes = tangentSlopes_.data() + static_cast<std::size_t>(stage) * n * K;
    for (std::size_t i = 0; i < n * K; ++i) slopes[i] = (endTangents_[i] - tangentBase_[i]) / hg;
    return true;
}

bool Esdirk::factorise(double hg) {
    if (jacobian_.factorise(hg)) return true;
    reason_ = "singular Jacobian";
    return false;
}

double Esdirk::scaledNorm(const double* v) const {
    double norm = 0.0;
    for (std::size_t i = 0; i < scale_.size(); ++i) {
        const double size = std::abs(v[i]), whole = std::max(scale_[i], std::abs(stage_[i]));
        if (!std::isfinite(size)) return size;
        if (size > norm * whole) norm = size / whole;
    }
    return norm;
}

/// The state whose equation is farthest from being met, where an iteration has given up.
int Esdirk::largestDefect() const {
    int worst = -1;
    double largest = -1.0;
    for (int i = 0; i < n_; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const double size = std::abs(delta_[at]) / std::max(scale_[at], std::abs(stage_[at]));
        if (!std::isfinite(size)) return i;
        if (size > largest) worst = i;
        largest = std::max(largest, size);
    }
    return worst;
}

/// out = M^-1 (base + hg f - X): the Newton step, whose size is also the measure of the defect (natural
/// monotonicity: Deuflhard 2004, section 3.1).
double Esdirk::defect(double hg, const double* stage, const double* slope, double* out) const {
    for (std::size_t i = 0; i < scale_.size(); ++i) out[i] = base_[i] + hg * slope[i] - stage[i];
    jacobian_.solve(out, 1);
    return scaledNorm(out);
}

bool Esdirk::solveStage(double t, double hg) {
    if (n_ == 0) return true;
    std::copy(stage_.begin(), stage_.end(), savedX_.begin());
    if (jacobian_.hasFactors(hg) && simplifiedNewton(t, hg)) return true;
    std::copy(savedX_.begin(), savedX_.end(), stage_.begin());
    return dampedNewton(t, hg);
}

/// Newton with the factors at hand, as long as it contracts well.
bool Esdirk::simplifiedNewton(double t, double hg) {
    double last = 0.0;
    for (int iteration = 0; iteration < 8; ++iteration) {
        if (!dynamics_.derivatives(t, stage_.data(), u_.data(), slope_.data())) return false;
        const double size = defect(hg, stage_.data(), slope_.data(), delta_.data());
        if (!std::isfinite(size) || (iteration > 0 && size > 0.25 * last && size > tolerance_)) return false;
        for (std::size_t i = 0; i < delta_.size(); ++i) stage_[i] += delta_[i];
        // One step solves what is linear, but for the rounding of its length.
        if (jacobian_.isConstant() && kRoundingOfStep * size <= tolerance_) return true;
        // The error left is about size * rate / (1 - rate).
        const double rate = iteration > 0 && last > 0.0 ? size / last : 1.0;
        if (size <= tolerance_ || rate * size <= 0.5 * tolerance_) return true;
        last = size;
    }
    return false;
}

bool Esdirk::dampedNewton(double t, double hg) {
    reason_ = "no convergence of an implicit step";
    if (!jacobian_.evaluate(t, stage_.data(), u_.data(), slope_.data())) {
        reason_ = "not finite";
        return false;
    }
    for (int iteration = 0; iteration < 60; ++iteration) {
        if (!factorise(hg)) return false;
        const double size = defect(hg, stage_.data(), slope_.data(), delta_.data());
        culprit_ = largestDefect();
        if (!std::isfinite(size)) return false;
        if (size <= tolerance_) {
            for (std::size_t i = 0; i < delta_.size(); ++i) stage_[i] += delta_[i];
            return true;
        }
        bool isAccepted = false;
        for (double damping = 1.0; damping > 1e-9; damping *= 0.5) {
            for (std::size_t i = 0; i < delta_.size(); ++i) trial_[i] = stage_[i] + damping * delta_[i];
            if (!dynamics_.derivatives(t, trial_.data(), u_.data(), trialSlope_.data())) continue;
            const double trialSize = defect(hg, trial_.data(), trialSlope_.data(), trialDelta_.data());
            if (trialSize <= (1.0 - 0.25 * damping) * size || trialSize <= tolerance_) {
                isAccepted = true;
                break;
            }
        }
        // At the limit of rounding nothing gets better: close enough is converged.
        if (!isAccepted) return size <= 1e3 * tolerance_;
        stage_ = trial_;
        if (!jacobian_.evaluate(t, stage_.data(), u_.data(), slope_.data())) {
            reason_ = "not finite";
            return false;
        }
    }
    return false;
}

}  // namespace analogon
