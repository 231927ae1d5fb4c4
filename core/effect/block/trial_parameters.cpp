#include "core/effect/block/trial_parameters.hpp"

#include <algorithm>
#include <cmath>

#include "core/effect/block/probe_score.hpp"
#include "core/effect/thresholds.hpp"

namespace analogon {
namespace {

double smallestSecant(const Screened& s) {
    double smallest = 0;
    for (const Probe& p : s.probes)
        if (p.secant > 0 && (smallest == 0 || p.secant < smallest)) smallest = p.secant;
    return smallest;
}

FitParameter strengthParameter(const Screened& s, const Probe& probe) {
    const EffectClass& effect = s.candidate.effect;
    FitParameter p;
    p.name = effect.parameters.strength;
    p.start = probe.strength();
    if (probe.secant != 0) {
        // a trace taken at one strength speaks for its neighbourhood
        const double low = std::abs(probe.secant) / 4, high = std::abs(probe.secant) * 4;
        const double size = std::clamp(std::abs(p.start), low, high);
        p.start = p.start < 0 || (p.start == 0 && probe.secant < 0) ? -size : size;
    }
    if (effect.parameters.oneSided) {
        // some effects have no model at exactly 0 (a lag of no time): those were probed by secants alone
        const auto reach = effect.trial.reach.find(effect.parameters.strength);
        p.min = smallestSecant(s) / (reach == effect.trial.reach.end() ? 50 : reach->second);
        if (probe.secant != 0) p.scale = ParameterScale::Logarithmic;
    }
    return p;
}

FitParameter shapeParameter(const Screened& s, const std::string& name, double start) {
    FitParameter p;
    p.name = name;
    p.start = start;
    if (name == s.candidate.effect.wave.phase) return p;
    double low = start, high = start;
    for (const Probe& probe : s.probes) {
        const auto value = probe.values.find(name);
        if (value == probe.values.end()) continue;
        low = std::min(low, value->second);
        high = std::max(high, value->second);
    }
    if (low > 0) {
        const double factor = reachOf(s.candidate.effect, name);
        p.min = low / factor;
        p.max = high * factor;
        p.scale = ParameterScale::Logarithmic;
    }
    return p;
}

/// Length of the longest recording that is fitted [s].
double longestOf(const EstimationTask& task) {
    double longest = 0;
    for (const int i : recordingsOf(task, Role::Fit)) {
        const std::vector<double>& time = task.recordings[static_cast<std::size_t>(i)].time;
        longest = std::max(longest, time.back() - time.front());
    }
    return longest;
}

}  // namespace

double reachOf(const EffectClass& effect, const std::string& shape) {
    const auto reach = effect.trial.reach.find(shape);
    return reach == effect.trial.reach.end() ? 100 : reach->second;
}

std::vector<FitParameter> freedParameters(const Screened& s, const Probe& probe, const Variant& wired) {
    std::vector<FitParameter> freed{strengthParameter(s, probe)};
    const std::vector<double> linear = probe.linear();
    for (std::size_t i = 0; i < s.candidate.effect.parameters.linear.size(); ++i) {
        FitParameter p;
        p.name = s.candidate.effect.parameters.linear[i];
        p.start = i < linear.size() ? linear[i] : 0;
        freed.push_back(std::move(p));
    }
    for (const auto& [name, value] : probe.values) freed.push_back(shapeParameter(s, name, value));
    const PlacedEffect& placed = wired.effects.back();
    for (FitParameter& p : freed) {
        const auto unit = placed.effect.parameters.units.find(p.name);
        if (unit != placed.effect.parameters.units.end()) p.unit = unit->second;
        p.name = placed.instance + "." + p.name;
    }
    // what takes longer than every recording is not told by them: a signal that stands still is no slow one
    FitParameter& strength = freed.front();
    if (strength.unit == "s") {
        strength.max = std::min(strength.max, longestOf(wired.task));
        strength.start = std::min(strength.start, strength.max);
    }
    return freed;
}

std::vector<std::pair<const Probe*, double>> startsOf(const Screened& screened) {
    std::vector<std::pair<const Probe*, double>> starts;
    for (const Probe& probe : screened.probes) {
        if (probe.strength() != 0) starts.emplace_back(&probe, 0);
        if (probe.secant != 0) starts.emplace_back(&probe, probe.secant);
    }
    // beside parameters that have taken its part a slope may have the wrong sign: the size is a guess all the same
    if (starts.empty())
        for (const Probe& probe : screened.probes)
            if (probe.plain.strengths.size() > 0 && probe.plain.strengths[0] != 0)
                starts.emplace_back(&probe, std::abs(probe.plain.strengths[0]));
    return starts;
}

std::vector<ParameterValue> offeredByWhitened(const Trial& trial) {
    const std::vector<Probe>& probes = trial.screened.probes;
    const auto best = std::max_element(probes.begin(), probes.end(), [](const Probe& a, const Probe& b) {
        return scoreOf(a.whitened) < scoreOf(b.whitened);
    });
    if (best == probes.end() || !(scoreOf(best->whitened) > 0)) return {};
    Probe whitened = *best;
    whitened.plain = best->whitened;
    std::vector<ParameterValue> offered;
    for (const FitParameter& p : freedParameters(trial.screened, whitened, trial.variant))
        offered.push_back({p.name, -1, std::clamp(p.start, p.min, p.max)});
    return offered;
}

}  // namespace analogon
