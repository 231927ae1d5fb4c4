#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <vector>

#include "effects.hpp"
#include "excite.hpp"

/// How much of an effect a refit of the base model leaves over, and which other effects would leave the same.
namespace bench {

inline double dot(const Series& a, const Series& b) { return std::inner_product(a.begin(), a.end(), b.begin(), 0.0); }
inline double rms(const Series& a) { return a.empty() ? 0.0 : std::sqrt(dot(a, a) / static_cast<double>(a.size())); }
inline Series minus(const Series& a, const Series& b) {
    Series out(a.size());
    for (std::size_t k = 0; k < a.size(); ++k) out[k] = a[k] - b[k];
    return out;
}

/// Orthonormal columns (modified Gram-Schmidt).
class Basis {
public:
    void add(Series column) {
        const double before = std::sqrt(dot(column, column));
        column = reject(std::move(column));
        const double after = std::sqrt(dot(column, column));
        if (after <= 1e-9 * before || after == 0.0) return;
        for (double& v : column) v /= after;
        columns_.push_back(std::move(column));
    }
    /// What no combination of the columns makes.
    Series reject(Series v) const {
        for (const auto& q : columns_) {
            const double along = dot(q, v);
            for (std::size_t k = 0; k < v.size(); ++k) v[k] -= along * q[k];
        }
        return v;
    }

private:
    std::vector<Series> columns_;
};

using Response = std::function<std::optional<Series>(const std::vector<double>&)>;

struct Optimum {
    std::vector<double> z;
    Series residual;               // target - response
    std::vector<Series> jacobian;  // columns, at z or just before
    double rho() const { return rms(residual); }
};

/// Least squares by Levenberg and Marquardt with one-sided differences; z is scaled so that 1 is a large change.
inline std::optional<Optimum> leastSquares(const Response& response, const Series& target, std::vector<double> z,
                                           int passes) {
    auto y = response(z);
    if (!y) return std::nullopt;
    Optimum best{z, minus(target, *y), {}};
    double damping = 1e-6;
    const std::size_t n = z.size();
    for (int pass = 0; pass < passes; ++pass) {
        std::vector<Series> J;
        const Series here = minus(target, best.residual);
        for (std::size_t j = 0; j < n; ++j) {
            auto moved = best.z;
            constexpr double step = 1e-4;
            moved[j] += step;
            auto there = response(moved);
            if (!there) return std::nullopt;
            Series column = minus(*there, here);
            for (double& v : column) v /= step;
            J.push_back(std::move(column));
        }
        const double before = dot(best.residual, best.residual);
        bool better = false;
        for (int attempt = 0; attempt < 5 && !better; ++attempt, damping *= 30.0) {
            std::vector<std::vector<double>> A(n, std::vector<double>(n + 1));
            for (std::size_t r = 0; r < n; ++r) {
                for (std::size_t c = 0; c < n; ++c) A[r][c] = dot(J[r], J[c]);
                A[r][n] = dot(J[r], best.residual);
                A[r][r] *= 1.0 + damping;
                A[r][r] += 1e-12;
            }
            for (std::size_t r = 0; r < n; ++r)  // Gauss and Jordan; A is positive definite
                for (std::size_t q = 0; q < n; ++q) {
                    if (q == r) continue;
                    const double f = A[q][r] / A[r][r];
                    for (std::size_t c = r; c <= n; ++c) A[q][c] -= f * A[r][c];
                }
            auto moved = best.z;
            for (std::size_t r = 0; r < n; ++r) moved[r] += std::clamp(A[r][n] / A[r][r], -0.7, 0.7);
            if (auto there = response(moved)) {
                Series residual = minus(target, *there);
                if (dot(residual, residual) < before) {
                    better = true;
                    best.z = moved;
                    best.residual = std::move(residual);
                    damping = std::max(1e-9, damping / 900.0);
                }
            }
        }
        best.jacobian = std::move(J);
        const double after = dot(best.residual, best.residual);
        if (!better || before - after < 3e-3 * before || after / static_cast<double>(target.size()) < 1e-8) break;
    }
    return best;
}

/// One recording of a design and everything that is refitted on it.
class Refit {
public:
    Refit(const Design& design, const Experiment& experiment, std::vector<double> sigma, double startT)
        : design_(design), experiment_(experiment), sigma_(std::move(sigma)), startT_(startT) {}

    Plant plant(const std::vector<double>& logFactors) const {
        Model m = design_.model;
        for (std::size_t k = 0; k < design_.fitted.size(); ++k)
            m.set(design_.fitted[k].path,
                  design_.fitted[k].truth * std::exp(k < logFactors.size() ? logFactors[k] : 0.0));
        Plant p = assemble(m);
        for (auto& n : p.nodes) n.start = startT_;
        return p;
    }
    Recording record(const std::vector<double>& logFactors, const std::vector<Effect>& effects) const {
        Plant p = plant(logFactors);
        for (const auto& e : effects) apply(p, e);
        ++runs;
        return simulate(p, experiment_);
    }
    std::optional<Series> weighted(const std::vector<double>& logFactors, const std::vector<Effect>& effects) const {
        const Recording r = record(logFactors, effects);
        if (!r.ok) return std::nullopt;
        Series out;
        for (std::size_t c = 0; c < r.outputs.size(); ++c)
            for (double v : r.outputs[c]) out.push_back(v / sigma_[c]);
        return out;
    }
    std::size_t parameters() const { return design_.fitted.size(); }
    const Design& design() const { return design_; }

    mutable int runs{};

private:
    const Design& design_;
    const Experiment& experiment_;
    std::vector<double> sigma_;
    double startT_;
};

/// A proposal with values: what a fit of this effect adjusts.
struct Choice {
    Proposal proposal;
    Parameters shape;
    double strength{};

    Effect effect() const { return {proposal.place, proposal.parameters(strength, shape)}; }
    double& shapeValue(const std::string& name) {
        for (auto& [key, v] : shape)
            if (key == name) return v;
        throw std::runtime_error("no shape parameter " + name);
    }
};

/// Unknowns of a fit with effects: log of the base parameters, then for each effect its strength over its present value
/// and its freed shape parameters (angles shifted, others as log of a factor).
class EffectFit {
public:
    EffectFit(const Refit& refit, std::vector<Choice> choices) : refit_(refit), choices_(std::move(choices)) {}

    std::vector<double> start(const std::vector<double>& logFactors) const {
        std::vector<double> z = logFactors;
        for (const auto& c : choices_) {
            z.push_back(1.0);
            z.insert(z.end(), c.proposal.freed.size(), 0.0);
        }
        return z;
    }
    std::vector<Choice> choices(const std::vector<double>& z) const {
        auto out = choices_;
        std::size_t at = refit_.parameters();
        for (auto& c : out) {
            c.strength *= z[at++];
            for (const auto& name : c.proposal.freed) {
                double& v = c.shapeValue(name);
                v = name.starts_with("phi_") ? v + z[at++] : v * std::exp(z[at++]);
            }
        }
        return out;
    }
    Response response() const {
        return [this](const std::vector<double>& z) -> std::optional<Series> {
            std::vector<Effect> effects;
            for (const auto& c : choices(z)) {
                if (!c.proposal.bothSigns && c.strength < 0.0) return std::nullopt;
                if (std::abs(c.strength) > 4.0 * c.proposal.most) return std::nullopt;
                effects.push_back(c.effect());
            }
            const std::vector<double> base(z.begin(), z.begin() + static_cast<std::ptrdiff_t>(refit_.parameters()));
            return refit_.weighted(base, effects);
        };
    }
    std::optional<Optimum> fit(const Series& target, const std::vector<double>& logFactors, int passes) const {
        return leastSquares(response(), target, start(logFactors), passes);
    }

private:
    const Refit& refit_;
    std::vector<Choice> choices_;
};

inline std::vector<Effect> effectsOf(const std::vector<Choice>& choices) {
    std::vector<Effect> out;
    for (const auto& c : choices) out.push_back(c.effect());
    return out;
}

/// What is left of choice `which` when the base parameters and the other effects are refitted.
inline std::optional<Optimum> leftOver(const Refit& refit, const std::vector<Choice>& all, std::size_t which,
                                       int passes = 8) {
    const auto target = refit.weighted({}, effectsOf(all));
    if (!target) return std::nullopt;
    auto others = all;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(which));
    return EffectFit(refit, others).fit(*target, std::vector<double>(refit.parameters(), 0.0), passes);
}

/// Scales the strength of `choice` until it leaves `rho`; false if no sensible strength does.
inline bool scaleTo(const Refit& refit, Choice& choice, double rho) {
    const std::vector<double> truth(refit.parameters(), 0.0);
    const auto base = refit.weighted(truth, {});
    if (!base) return false;
    Basis tangents;
    for (std::size_t k = 0; k < truth.size(); ++k) {
        auto moved = truth;
        moved[k] = 1e-4;
        const auto there = refit.weighted(moved, {});
        if (!there) return false;
        tangents.add(minus(*there, *base));
    }
    const double side = choice.strength < 0.0 ? -1.0 : 1.0;
    double correction = 1.0;  // true over linearised rho
    for (int round = 0; round < 2; ++round) {
        double slope = 1.0, lastS = 0.0, lastRho = 0.0;
        for (int pass = 0; pass < 8; ++pass) {
            const auto there = refit.weighted(truth, {choice.effect()});
            if (!there) return false;
            const double now = correction * rms(tangents.reject(minus(*there, *base)));
            if (now <= 0.0) {
                choice.strength *= 3.0;
            } else {
                if (std::abs(now / rho - 1.0) < 0.03) break;
                const double s = std::abs(choice.strength);
                if (lastRho > 0.0 && std::abs(std::log(s / lastS)) > 1e-6)
                    slope = std::clamp(std::log(now / lastRho) / std::log(s / lastS), 0.3, 4.0);
                lastS = s, lastRho = now;
                choice.strength *= std::clamp(std::pow(rho / now, 1.0 / slope), 0.1, 6.0);
            }
            if (std::abs(choice.strength) > choice.proposal.most) {
                if (lastS >= 0.999 * choice.proposal.most) return false;
                choice.strength = side * choice.proposal.most;
            }
        }
        const auto refitted = leftOver(refit, {choice}, 0);
        if (!refitted || refitted->rho() <= 0.0) return false;
        const double real = refitted->rho();
        if (std::abs(real / rho - 1.0) < (round == 0 ? 0.1 : 0.2)) return true;
        const auto there = refit.weighted(truth, {choice.effect()});
        correction = real / rms(tangents.reject(minus(*there, *base)));
    }
    return false;
}

// ---------------------------------------------------------------- twins

struct Twin {
    Place place;
    double remaining{};  // chi-square by which it explains the data worse than the truth does
};

/// Kinds that contain another one as a special case: the richer one fits as well, but is not what is missing.
inline bool contains(const std::string& richer, const std::string& plain) {
    return (richer == "friction.stribeck" && plain == "friction.coulomb") ||
           (richer == "backlash" && plain == "compliance.shaft");
}

/// Other effects that explain choice `which` of `all` within `threshold` of chi-square (noise-free).
inline std::vector<Twin> twins(const Refit& refit, const std::vector<Choice>& all, std::size_t which,
                               const Optimum& left, const std::vector<Proposal>& catalogue, double threshold) {
    std::vector<Twin> found;
    const auto target = refit.weighted({}, effectsOf(all));
    if (!target) return found;
    auto others = all;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(which));
    const EffectFit without(refit, others);
    const auto fitted = without.choices(left.z);
    const std::vector<double> base(left.z.begin(), left.z.begin() + static_cast<std::ptrdiff_t>(refit.parameters()));
    Basis tangents;
    for (const auto& column : left.jacobian) tangents.add(column);
    const Series residual = tangents.reject(left.residual), here = minus(*target, left.residual);
    const double samples = static_cast<double>(residual.size()), whole = dot(residual, residual);
    const Place& truth = all[which].proposal.place;

    for (const auto& p : catalogue) {
        if ((p.place.kind == truth.kind && p.place.at == truth.at) || contains(p.place.kind, truth.kind)) continue;
        // Screen: the part of the residual along the effect's trace, at a strength of the right size.
        Choice best{p, {}, 0.0};
        double bestLeft = 1.0;
        for (const auto& shape : p.shapes)
            for (double side : {1.0, -1.0}) {
                if (side < 0.0 && !p.bothSigns) continue;
                Choice c{p, shape, side * p.typical};
                for (int pass = 0; pass < 2; ++pass) {
                    auto effects = effectsOf(fitted);
                    effects.push_back(c.effect());
                    const auto there = refit.weighted(base, effects);
                    if (!there) break;
                    const Series trace = tangents.reject(minus(*there, here));
                    const double size = dot(trace, trace), along = dot(trace, residual);
                    if (size <= 1e-6 * samples) {
                        c.strength *= 10.0;
                    } else {
                        const double remaining = 1.0 - (along > 0.0 ? along * along / (size * whole) : 0.0);
                        const double step = std::clamp(along / size, 0.1, 10.0);
                        if (remaining < bestLeft) {
                            bestLeft = remaining, best = c;
                            best.strength *= step;
                        }
                        if (along <= 0.0 || (pass == 0 && remaining > 0.5)) break;
                        c.strength *= step;
                    }
                    if (std::abs(c.strength) > p.most) c.strength = side * p.most;
                }
                if (p.bothSigns && bestLeft < 0.5) break;
            }
        if (bestLeft * whole > std::max(15.0 * threshold, 0.15 * whole) || best.strength == 0.0) continue;
        auto choices = fitted;
        choices.push_back(best);
        const auto optimum = EffectFit(refit, choices).fit(*target, base, 6);
        if (!optimum) continue;
        const double remaining = dot(optimum->residual, optimum->residual);
        if (remaining < threshold) found.push_back({p.place, remaining});
    }
    return found;
}

}  // namespace bench
