#include "core/effect/trial.hpp"

#include <algorithm>
#include <cmath>

namespace analogon {
namespace {

constexpr double leastEvidence = 10;  // fall in BIC that an effect must bring
constexpr double leastHeldOut = 0.5;
constexpr int heldOutBlocks = 10;  // fewer leave out more of the excitation than the rest can make up for

double smallestSecant(const Screened& s) {
    double smallest = 0;
    for (const Probe& p : s.probes)
        if (p.secant > 0 && (smallest == 0 || p.secant < smallest)) smallest = p.secant;
    return smallest;
}

FitParameter strengthParameter(const Screened& s, const Probe& probe) {
    const EffectClass& effect = s.candidate.effect;
    FitParameter p;
    p.name = effect.strength;
    p.start = probe.strength();
    if (probe.secant != 0) {
        // a trace taken at one strength speaks for its neighbourhood
        const double low = std::abs(probe.secant) / 4, high = std::abs(probe.secant) * 4;
        const double size = std::clamp(std::abs(p.start), low, high);
        p.start = p.start < 0 || (p.start == 0 && probe.secant < 0) ? -size : size;
    }
    if (effect.oneSided) {
        // some effects have no model at exactly 0 (a lag of no time): those were probed by secants alone
        p.min = smallestSecant(s) / 50;
        if (probe.secant != 0) p.scale = ParameterScale::Logarithmic;
    }
    return p;
}

FitParameter shapeParameter(const Screened& s, const std::string& name, double start) {
    FitParameter p;
    p.name = name;
    p.start = start;
    double low = start, high = start;
    for (const Probe& probe : s.probes) {
        const auto value = probe.values.find(name);
        if (value == probe.values.end()) continue;
        low = std::min(low, value->second);
        high = std::max(high, value->second);
    }
    if (low > 0) {
        p.min = low / 100;
        p.max = high * 100;
        p.scale = ParameterScale::Logarithmic;
    }
    return p;
}

std::vector<FitParameter> freedParameters(const Screened& s, const Probe& probe) {
    std::vector<FitParameter> freed{strengthParameter(s, probe)};
    const std::vector<double> linear = probe.linear();
    for (std::size_t i = 0; i < s.candidate.effect.linear.size(); ++i) {
        FitParameter p;
        p.name = s.candidate.effect.linear[i];
        p.start = i < linear.size() ? linear[i] : 0;
        freed.push_back(std::move(p));
    }
    for (const auto& [name, value] : probe.values) freed.push_back(shapeParameter(s, name, value));
    const PlacedEffect& placed = s.wired.effects.back();
    for (FitParameter& p : freed) {
        const auto unit = placed.effect.units.find(p.name);
        if (unit != placed.effect.units.end()) p.unit = unit->second;
        p.name = placed.instance + "." + p.name;
    }
    return freed;
}

}  // namespace

Trial refit(const NullModel& null, const Screened& screened, const FitOptions& options, int starts,
            const Progress& progress) {
    Trial best;
    best.screened = screened;
    best.variant = screened.wired;
    int tried = 0;
    for (const Probe& probe : screened.probes) {
        if (tried == starts || progress.stopRequested()) break;
        if (probe.strength() == 0) continue;
        ++tried;
        Variant variant = screened.wired;
        variant.effects.back().freed = freedParameters(screened, probe);
        for (const FitParameter& p : variant.effects.back().freed) variant.task.parameters.push_back(p);
        Outcome<PreparedTask> prepared = prepareAt(variant, null.noise);
        if (!prepared) {
            best.failure = prepared.diagnostics().front().message;
            continue;
        }
        for (FitParameter& p : prepared->problem.parameters) p.start = std::clamp(p.start, p.min, p.max);
        FitResult result = fit(prepared->problem, options, progress);
        if (!result.optimum.ok) {
            best.failure = result.message;
            continue;
        }
        if (best.ok && result.cost >= best.fit.cost) continue;
        variant.values = valuesOf(result);
        best.variant = std::move(variant);
        best.fit = std::move(result);
        best.ok = true;
    }
    return best;
}

void proceed(const NullModel& null, Trial& trial, const FitOptions& options, const Progress& progress) {
    Outcome<PreparedTask> prepared = prepareAt(trial.variant, null.noise);
    if (!prepared) return;
    FitResult result = fit(prepared->problem, options, progress);
    if (!result.optimum.ok || result.cost > trial.fit.cost) return;
    trial.variant.values = valuesOf(result);
    trial.fit = std::move(result);
}

void rank(const NullModel& null, std::vector<Trial>& trials) {
    const auto best = std::min_element(trials.begin(), trials.end(), [](const Trial& a, const Trial& b) {
        return (a.ok ? a.sumOfSquares() : 1e300) < (b.ok ? b.sumOfSquares() : 1e300);
    });
    if (best == trials.end() || !best->ok) return;
    const double rows = static_cast<double>(null.fit.optimum.residuals.size());
    const double variance =
        best->sumOfSquares() / std::max(1.0, rows - static_cast<double>(best->fit.estimates.size()));
    const double logCount = std::log(effectiveCount(null.channels, best->fit.optimum.residuals));
    for (Trial& t : trials)
        t.evidence = t.ok ? (null.sumOfSquares() - t.sumOfSquares()) / variance - t.freed() * logCount : -1e300;
    std::stable_sort(trials.begin(), trials.end(),
                     [](const Trial& a, const Trial& b) { return a.evidence > b.evidence; });
}

Acceptance examine(const NullModel& null, const Trial& trial, double threshold) {
    const Whitener whiten(null.channels, trial.fit.optimum.residuals);
    const auto whiteSum = [&](const Linearisation& l) {
        return Complement(whiten(l.jacobian))(whiten(l.residuals)).squaredNorm();
    };
    Acceptance a;
    a.explained = whiteSum(null.fit.optimum) - whiteSum(trial.fit.optimum);
    a.evidence = a.explained - trial.freed() * std::log(static_cast<double>(null.fit.optimum.residuals.size()));
    // An autoregressive model of a residual that still holds other slow effects takes their slow part for noise. What
    // counts the same residual as noise of its own correlation time is the more patient judge of slow effects.
    const double rows = static_cast<double>(null.fit.optimum.residuals.size());
    const double count = effectiveCount(null.channels, trial.fit.optimum.residuals);
    const double variance =
        trial.sumOfSquares() / std::max(1.0, rows - static_cast<double>(trial.fit.estimates.size()));
    a.effective =
        (null.sumOfSquares() - trial.sumOfSquares()) / variance * count / rows - trial.freed() * std::log(count);
    a.heldOut = heldOutGain(null.channels, null.fit.optimum, trial.fit.optimum, heldOutBlocks);
    a.isSignificant = std::max(a.evidence, a.effective) > std::max(leastEvidence, threshold);
    a.holdsOut = a.heldOut > leastHeldOut;
    return a;
}

}  // namespace analogon
