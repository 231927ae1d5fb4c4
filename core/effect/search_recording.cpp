/// What lies in the recordings and not in the component: start values that were told wrongly look like an offset, a lag
/// or a dead zone, the noise of a recorded input like a limit or a play that cuts it off.
#include <fmt/format.h>

#include <algorithm>

#include "core/effect/input_noise.hpp"
#include "core/effect/search.hpp"

namespace analogon {
namespace {

constexpr std::size_t mostStarts = 12;  // that are tried

}  // namespace

/// Allows for what is wrong with a recording, where that explains more than what this round has chosen. True when it
/// did: the round is to be repeated beside it.
bool Search::allowForRecordings(NullModel& null, const Round& round) {
    double most = round.chosen ? round.acceptance.effective : 0;
    const auto explainsMore = [&](const Variant& variant, int freed) {
        if (progress_.stopRequested()) return false;
        const std::optional<FitResult> fit = fitBeside(null, variant, search_.fit, progress_);
        if (!fit) return false;
        const Acceptance gain = examine(null, *fit, freed, round.threshold);
        if (!gain.isSignificant || !gain.isWorthwhile || !(gain.effective > most)) return false;
        most = gain.effective;
        return true;
    };
    const Outcome<std::vector<ToldStart>> told = toldStarts(null.variant.task);
    std::optional<ToldStart> best;
    if (told && told->size() <= mostStarts)
        for (const ToldStart& start : *told) {
            say("reconsider", start.parameter, -1);
            Variant freed = null.variant;
            setFitted(freed.task, start, true);
            if (explainsMore(freed, 1)) best = start;
        }
    Variant quiet = null.variant;
    const std::vector<NoisyInput> noisy = noisyInputs_.empty() ? quieten(quiet.task) : std::vector<NoisyInput>();
    if (!noisy.empty()) {
        say("reconsider", "noise of the inputs", -1);
        if (explainsMore(quiet, static_cast<int>(noisy.size()))) return refitQuiet(null, std::move(quiet), noisy);
    }
    return best && refitWith(null, *best);
}

/// The model beside inputs without their noise; so in all that the search fits from here on.
bool Search::refitQuiet(NullModel& null, Variant quiet, const std::vector<NoisyInput>& noisy) {
    Outcome<NullModel> next = fitNull(quiet, null.noise, NoiseLevel::Estimate, search_.fit, progress_);
    if (!next || progress_.stopRequested()) return false;
    null = std::move(*next);
    quieten(base_.task);
    noisyInputs_ = noisy;
    return true;
}

/// The model with a start value fitted, or held where it was told to be.
Outcome<NullModel> Search::fittedWith(const NullModel& null, const ToldStart& start, bool isFitted) const {
    Variant variant = null.variant;
    setFitted(variant.task, start, isFitted);
    if (!isFitted)
        std::erase_if(variant.values, [&](const ParameterValue& v) {
            return v.experiment == start.experiment && v.name == start.parameter;
        });
    return fitNull(variant, null.noise, isFitted ? NoiseLevel::Estimate : NoiseLevel::Keep, search_.fit, progress_);
}

/// A start value is fitted in all that the search fits from here on.
bool Search::refitWith(NullModel& null, const ToldStart& start) {
    Outcome<NullModel> next = fittedWith(null, start, true);
    if (!next || progress_.stopRequested()) return false;
    setFitted(base_.task, start, true);
    setFitted(full_.task, start, true);
    freedStarts_.push_back(start);
    null = std::move(*next);
    return true;
}

/// Holds those start values again that, beside the effects found since, explain nothing that counts.
void Search::holdUnneededStarts(NullModel& null) {
    for (const ToldStart& start : std::vector<ToldStart>(freedStarts_)) {
        Outcome<NullModel> held = fittedWith(null, start, false);
        if (progress_.stopRequested()) return;
        if (!held) continue;
        const Acceptance missed = examine(*held, null.fit, 1, 0);
        const auto isMore = [&] {
            return isBorneOut(besideDisturbance(*held, search_.fit.simulation, progress_),
                              besideDisturbance(null, search_.fit.simulation, progress_),
                              null.fit.optimum.residuals.size(), 1);
        };
        if (missed.isSignificant && missed.isWorthwhile && (isNoise(null) || isMore())) continue;
        setFitted(base_.task, start, false);
        setFitted(full_.task, start, false);
        std::erase_if(freedStarts_, [&](const ToldStart& s) {
            return s.recording == start.recording && s.parameter == start.parameter;
        });
        null = std::move(*held);
    }
}

/// What people should know of what was allowed for in the recordings.
std::vector<Text> Search::recordingRemarks(const NullModel& null) const {
    std::vector<Text> remarks;
    for (const NoisyInput& input : noisyInputs_)
        remarks.push_back(
            phrase("the input '{}' of '{}' is recorded with noise ({:.2g} rms) that drives the model and not the "
                   "component: the search has smoothed it, the errors that are reported are with it; record it with "
                   "less noise, or smooth it",
                   input.name, full_.task.recordings[static_cast<std::size_t>(input.recording)].name, input.deviation));
    for (const ToldStart& start : freedStarts_)
        for (const FitEstimate& e : null.fit.estimates) {
            if (e.name != start.parameter || e.experiment != start.experiment) continue;
            const Recording& recording = full_.task.recordings[static_cast<std::size_t>(start.recording)];
            remarks.push_back(
                phrase("'{}' does not begin where the model was told: {} is {:.5g} ± {:.2g}{}{} there, not {:.5g}; "
                       "it is fitted for this recording (\"initial\": \"fit\")",
                       recording.name, start.parameter, e.value, e.standardError, e.unit.empty() ? "" : " ", e.unit,
                       start.value));
        }
    return remarks;
}

}  // namespace analogon
