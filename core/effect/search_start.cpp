/// Start values that recordings were told wrongly: what a wrong one leaves looks like an offset, a lag or a dead zone.
#include <fmt/format.h>

#include <algorithm>

#include "core/effect/search.hpp"

namespace analogon {
namespace {

constexpr std::size_t mostStarts = 12;  // that are tried

}  // namespace

/// Lets the start value be fitted that explains more than what this round has chosen. True when there was one: the
/// round is to be repeated beside it.
bool Search::freeStart(NullModel& null, const Round& round) {
    const Outcome<std::vector<ToldStart>> told = toldStarts(null.variant.task);
    if (!told || told->size() > mostStarts) return false;
    double most = round.chosen ? round.acceptance.effective : 0;
    std::optional<ToldStart> best;
    for (const ToldStart& start : *told) {
        if (progress_.stopRequested()) return false;
        say("reconsider", start.parameter, -1);
        Variant freed = null.variant;
        setFitted(freed.task, start, true);
        const std::optional<FitResult> fit = fitBeside(null, freed, search_.fit, progress_);
        if (!fit) continue;
        const Acceptance gain = examine(null, *fit, 1, round.threshold);
        if (!gain.isSignificant || !gain.isWorthwhile || !(gain.effective > most)) continue;
        most = gain.effective;
        best = start;
    }
    return best && refitWith(null, *best, true);
}

/// The model with a start value fitted, or held where it was told to be; so in all that the search fits from here on.
bool Search::refitWith(NullModel& null, const ToldStart& start, bool isFitted) {
    Variant variant = null.variant;
    setFitted(variant.task, start, isFitted);
    if (!isFitted)
        std::erase_if(variant.values, [&](const ParameterValue& v) {
            return v.experiment == start.experiment && v.name == start.parameter;
        });
    Outcome<NullModel> next =
        fitNull(variant, null.noise, isFitted ? NoiseLevel::Estimate : NoiseLevel::Keep, search_.fit, progress_);
    if (!next || progress_.stopRequested()) return false;
    setFitted(base_.task, start, isFitted);
    setFitted(full_.task, start, isFitted);
    if (isFitted)
        freedStarts_.push_back(start);
    else
        std::erase_if(freedStarts_, [&](const ToldStart& s) {
            return s.recording == start.recording && s.parameter == start.parameter;
        });
    null = std::move(*next);
    return true;
}

/// Holds those start values again that, beside the effects found since, explain nothing that counts.
void Search::holdUnneededStarts(NullModel& null) {
    for (const ToldStart& start : std::vector<ToldStart>(freedStarts_)) {
        if (progress_.stopRequested()) return;
        Variant variant = null.variant;
        setFitted(variant.task, start, false);
        std::erase_if(variant.values, [&](const ParameterValue& v) {
            return v.experiment == start.experiment && v.name == start.parameter;
        });
        const Outcome<NullModel> held = fitNull(variant, null.noise, NoiseLevel::Keep, search_.fit, progress_);
        if (!held) continue;
        const Acceptance missed = examine(*held, null.fit, 1, 0);
        const auto isMore = [&] {
            return isBorneOut(besideDisturbance(*held, search_.fit.simulation, progress_),
                              besideDisturbance(null, search_.fit.simulation, progress_),
                              null.fit.optimum.residuals.size(), 1);
        };
        if (!missed.isSignificant || !missed.isWorthwhile || (!isNoise(null) && !isMore()))
            refitWith(null, start, false);
    }
}

/// What people should know of the start values that were fitted.
std::vector<std::string> Search::startRemarks(const NullModel& null) const {
    std::vector<std::string> remarks;
    for (const ToldStart& start : freedStarts_)
        for (const FitEstimate& e : null.fit.estimates) {
            if (e.name != start.parameter || e.experiment != start.experiment) continue;
            const Recording& recording = full_.task.recordings[static_cast<std::size_t>(start.recording)];
            remarks.push_back(
                fmt::format("'{}' does not begin where the model was told: {} is {:.5g} ± {:.2g}{}{} there, not "
                            "{:.5g}; it is fitted "
                            "for this recording (\"initial\": \"fit\")",
                            recording.name, start.parameter, e.value, e.standardError, e.unit.empty() ? "" : " ",
                            e.unit, start.value));
        }
    return remarks;
}

}  // namespace analogon
