#include "core/effect/judge/judgement.hpp"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>

#include "core/effect/thresholds.hpp"

namespace analogon {

using namespace threshold::judgement;
using threshold::acceptance::clearEvidence;
using threshold::acceptance::farMore;
using threshold::prediction::mostSamplesOfDelay;

double pValue(double explained, int dof, std::size_t tried) {
    if (!(explained > 0) || dof < 1) return 1;
    const double p = boost::math::cdf(boost::math::complement(boost::math::chi_squared(dof), explained));
    return -std::expm1(static_cast<double>(tried) * std::log1p(-p));
}

bool isProposal(const Trial& trial) { return !trial.screened.candidate.effect.proposal.empty(); }

std::string equationOf(const PlacedEffect& placed) {
    std::string equation = placed.effect.proposal;
    constexpr std::string_view channel = "channel";
    if (const auto at = equation.find(channel); at != std::string::npos && !placed.place.spare.empty())
        equation.replace(at, channel.size(), placed.place.spare);
    return equation;
}

std::vector<EffectValue> estimatesOf(const PlacedEffect& placed, const FitResult& fit) {
    std::vector<EffectValue> values;
    for (const FitParameter& p : placed.freed)
        if (const FitEstimate* e = fit.find(p.name))
            values.push_back({p.name.substr(placed.instance.size() + 1), e->value, e->standardError, e->unit});
    return values;
}

int plausibility(const EffectClass& effect) {
    if (effect.placement.way == Way::Bridge) return -1;
    return effect.placement.signalSide == "input" ? 2 : effect.placement.behindSource ? 1 : 0;
}

std::pair<int, int> simplicity(const Trial& trial) {
    return {trial.freed(), plausibility(trial.screened.candidate.effect)};
}

bool mayFollowOthers(const NullModel& null, const Trial& trial) {
    return trial.screened.candidate.effect.trial.flexible && !isNoise(null.channels, trial.fit);
}

bool isMissed(const Acceptance& a) { return a.isSignificant && a.isWorthwhile && a.heldOut > 0; }

bool isClearlyMissed(const Acceptance& a) { return std::min(a.evidence, a.effective) > farMore; }

bool isTold(const PlacedEffect& placed, const std::vector<FitEstimate>& estimates, const Acceptance& missed,
            bool leavesNoise) {
    // a standard error reckons with noise: beside structure it is too small
    const bool isDistinct = isDetermined(placed, estimates, leavesNoise ? 1 : deviationsBesideStructure);
    return isDistinct || (isClearlyMissed(missed) && isScaleOpen(placed, estimates));
}

bool isGoodPart(double chi2Decrease, const NullModel& null) { return chi2Decrease > goodPart * excess(null); }

bool isBeyondDoubt(double evidence) { return evidence >= beyondDoubt; }

bool outweighsRest(double chi2Decrease, const NullModel& null, double share) {
    return !(reducedChi(null.fit) > largeResidual) || chi2Decrease > share * excess(null);
}

bool isBorneOut(const BesideDisturbance& without, const BesideDisturbance& with, Eigen::Index rows, int freed) {
    return evidenceBeside(without, with, rows, freed) > clearEvidence;
}

bool isLikelier(const BesideDisturbance& without, const BesideDisturbance& with, Eigen::Index rows, int freed) {
    return evidenceBeside(without, with, rows, freed) > leastLikelier;
}

bool isLongDeadTime(const PlacedEffect& placed, const FitResult& fit, double interval) {
    if (faultOf(placed.effect) != "delay") return false;
    const FitEstimate* delay = fit.find(placed.freed.front().name);
    return delay != nullptr && delay->value > mostSamplesOfDelay * interval;
}

bool isAtBound(const PlacedEffect& placed, const FitResult& fit) {
    return std::any_of(placed.freed.begin(), placed.freed.end(), [&](const FitParameter& p) {
        const FitEstimate* estimate = fit.find(p.name);
        if (estimate == nullptr || !estimate->atBound) return false;
        if (&p == &placed.freed.front()) return true;
        // below its reach a shape is not what the effect is called: no turn of a period, no warming
        const bool isLow = estimate->value < 1.01 * p.min;
        return isLow && placed.effect.trial.reach.contains(p.name.substr(placed.instance.size() + 1));
    });
}

bool isAtBound(const Trial& trial) { return isAtBound(trial.variant.effects.back(), trial.fit); }

bool hasShapeAtBound(const PlacedEffect& placed, const FitResult& fit) {
    return std::any_of(placed.freed.begin() + 1, placed.freed.end(), [&](const FitParameter& p) {
        const FitEstimate* estimate = fit.find(p.name);
        const bool isPhase = p.name == placed.instance + "." + placed.effect.wave.phase;  // it may be any
        return estimate != nullptr && estimate->atBound && !isPhase;
    });
}

bool lacksAPart(const PlacedEffect& placed, const FitResult& fit) {
    const auto valueOf = [&](const std::string& name) {
        const FitEstimate* e = fit.find(placed.instance + "." + name);
        return e == nullptr ? std::nan("") : std::abs(e->value);
    };
    return std::any_of(placed.effect.trial.part.begin(), placed.effect.trial.part.end(), [&](const auto& part) {
        return valueOf(part.first) < part.second * valueOf(placed.effect.parameters.strength);
    });
}

bool drivesToBound(const FitResult& without, const FitResult& with) {
    return std::any_of(without.estimates.begin(), without.estimates.end(), [&](const FitEstimate& before) {
        const FitEstimate* after = with.find(before.name, before.experiment);
        return !before.atBound && after != nullptr && after->atBound;
    });
}

bool fightsAnother(const NullModel& null, const FitResult& with) {
    const auto sizeOf = [](const FitEstimate* e) { return e == nullptr ? 0.0 : std::abs(e->value); };
    return std::any_of(null.variant.effects.begin(), null.variant.effects.end(), [&](const PlacedEffect& e) {
        const std::string& strength = e.freed.front().name;
        return sizeOf(with.find(strength)) > mostGrowth * sizeOf(null.fit.find(strength));
    });
}

double errorOfForms(double explained) {
    constexpr double formError = 0.0015, most = 300;
    return std::min(formError * explained, most);
}

bool beatsNames(const NullModel& null, const std::vector<Trial>& trials, std::size_t proposal,
                std::optional<std::size_t> chosen) {
    if (!chosen) return trials[proposal].evidence > 2 * equivalenceMargin;
    const double weight = independentShare(null, trials[proposal].fit);
    double best = -1e300, leastLeft = 1e300;
    for (const Trial& t : trials) {
        if (!t.ok || isProposal(t)) continue;
        best = std::max(best, t.evidence);
        leastLeft = std::min(leastLeft, t.sumOfSquares());
    }
    const double named = null.sumOfSquares() - leastLeft,
                 proposed = null.sumOfSquares() - trials[proposal].sumOfSquares();
    const bool leavesMuch = reducedChi(trials[proposal].fit) > largeResidual;
    // what explains as much with fewer parameters is the better account, by whatever name
    const bool isSimpler = trials[proposal].freed() < trials[*chosen].freed();
    if (isSimpler && leavesMuch && proposed > asMuch * named) return true;
    const double more = trials[proposal].evidence - best;
    const bool isClear = weight * more > equivalenceMargin && more > errorOfForms(best);
    if (!isClear && !(isSimpler && trials[proposal].evidence > best)) return false;
    return !leavesMuch || named < nearlyAsMuch * proposed;
}

}  // namespace analogon
