#include "core/effect/tell/other_value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/unit.hpp"
#include "core/effect/judge/caution.hpp"
#include "core/effect/thresholds.hpp"
#include "core/fit/fit.hpp"

namespace analogon {

using threshold::judgement::goodPart;
using threshold::prediction::nearlyAsWell;

namespace {

constexpr std::size_t mostRecordings = 6;  // that are looked at: each costs a short fit a parameter

/// A parameter with another value in one recording.
struct OtherValue {
    std::string name, unit;
    double value{}, elsewhere{};
    double left{};  // of the miss (root mean square)

    double removed() const { return 1 - left; }
};

/// The variant with one recording alone, to be fitted.
Variant aloneOf(const Variant& variant, const Recording& recording) {
    Variant alone = variant;
    alone.task.recordings.clear();
    alone.task.recordings.push_back(recording);
    alone.task.recordings.edit().front().role = Role::Fit;
    std::erase_if(alone.values, [](const ParameterValue& v) { return v.experiment >= 0; });
    alone.plans.clear();
    return alone;
}

std::optional<OtherValue> fittedAlone(const Variant& alone, const FitParameter& parameter, const FitOptions& options,
                                      const Progress& progress) {
    const auto at = std::find_if(alone.values.begin(), alone.values.end(),
                                 [&](const ParameterValue& v) { return v.name == parameter.name; });
    if (at == alone.values.end()) return std::nullopt;
    FitParameter free = parameter;
    free.start = at->value;
    free.prior.reset();  // it says what the component is as a rule
    const Outcome<PreparedTask> prepared = prepareHeld(alone, {free}, {});
    if (!prepared) return std::nullopt;
    const FitResult result = fit(prepared->problem, options, progress);
    if (result.status != FitStatus::Converged || result.values.size() != 1 || result.estimates.front().atBound)
        return std::nullopt;
    const Linearisation before = linearise(prepared->problem, Eigen::VectorXd::Constant(1, at->value), false,
                                           result.plans, options.simulation, progress);
    const double squares = before.ok ? before.residuals.squaredNorm() : 0;
    if (!(squares > 0)) return std::nullopt;
    return OtherValue{parameter.name, result.estimates.front().unit, result.values[0], at->value,
                      std::sqrt(2 * result.cost / squares)};
}

std::string valued(const OtherValue& v) { return fmt::format("{} = {:.4g}{}", v.name, v.value, behindNumber(v.unit)); }

Text tellOther(const std::string& recording, const std::vector<OtherValue>& best) {
    const OtherValue& first = best.front();
    const Text told = phrase(
        "'{}': with {} there, where the fitted recordings say {:.4g}, the model misses it by {:.0f} % less: the "
        "component may be another one, or something around it that was not recorded",
        recording, valued(first), first.elsewhere, std::min(99.0, 100 * first.removed()));
    if (best.size() == 1) return told;
    return phrase("{}; {} does nearly as well", told, valued(best[1]));
}

}  // namespace

std::vector<Text> otherValues(const Variant& variant, const ModelState& state, const FitOptions& options,
                              const Progress& progress) {
    std::vector<Text> said;
    std::size_t looked = 0;
    for (const std::string& name : missedRecordings(state)) {
        const auto recording = std::find_if(variant.task.recordings.begin(), variant.task.recordings.end(),
                                            [&](const Recording& r) { return r.name == name; });
        if (recording == variant.task.recordings.end()) continue;
        if (looked++ == mostRecordings) break;
        const Variant alone = aloneOf(variant, *recording);
        std::vector<OtherValue> found;
        for (const FitParameter& p : variant.task.parameters) {
            if (progress.stopRequested()) return said;
            if (p.experiment >= 0) continue;  // a start value
            if (const std::optional<OtherValue> other = fittedAlone(alone, p, options, progress);
                other && other->left < goodPart)
                found.push_back(*other);
        }
        if (found.empty()) continue;
        std::sort(found.begin(), found.end(), [](const OtherValue& a, const OtherValue& b) { return a.left < b.left; });
        const double least = nearlyAsWell * found.front().removed();
        std::erase_if(found, [&](const OtherValue& v) { return v.removed() < least; });
        said.push_back(tellOther(name, found));
    }
    return said;
}

}  // namespace analogon
