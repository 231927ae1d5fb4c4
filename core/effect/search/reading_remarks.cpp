#include "core/effect/search/reading_remarks.hpp"

#include <map>

#include "core/base/number_text.hpp"
#include "core/base/stop.hpp"
#include "core/effect/model/model_state.hpp"
#include "core/effect/model/sampling.hpp"
#include "core/effect/search/context.hpp"

namespace analogon {
namespace {

Text remarkOn(const std::vector<InputEdge>& edges) {
    if (areHeld(edges))
        return phrase(
            "the inputs jump just before the next sample ({} jumps): they are held in between and do not run straight "
            "from sample to sample, or reach the component half a sample late, which looks nearly the same; the "
            "parameters reckon with it, the errors that are reported do not",
            edges.size());
    return phrase(
        "the inputs jump between two samples ({} jumps), and the outputs tell when: the parameters reckon with it, the "
        "errors that are reported are with straight lines from sample to sample; record faster, or log the moment of "
        "each jump",
        edges.size());
}

}  // namespace

void reportAsRecorded(SearchContext& search, const NullModel& null, ModelState& state) {
    if (search.readings.drawn.asRecorded.empty()) return;
    Variant plain = search.readings.full;
    for (std::size_t r = 0; r < search.readings.drawn.asRecorded.size(); ++r) {
        Recording& recording = plain.task.recordings.edit()[r];
        const Recording& from = search.readings.drawn.asRecorded[r];
        recording.time = from.time;
        recording.inputs = from.inputs;
        recording.outputs = from.outputs;
        recording.spares = from.spares;
    }
    Outcome<Variant> whole = withEffects(plain, null.variant.effects, null.variant.values);
    if (!whole) return;
    Outcome<ModelState> told = stateOf(*whole, null.fit, search.options.fit.simulation, Progress());
    if (!told || isStopped()) return;
    search.readings.drawn.errorsOnTime = {errorPercentOf(state, Role::Fit), validationErrorOf(state)};
    state.experiments = std::move(told->experiments);
    state.residual = std::move(told->residual);
}

std::vector<Text> recordingRemarks(const SearchContext& search, const NullModel& null) {
    std::vector<Text> remarks = faultRemarks(search.readings.full.task.recordings, search.readings.faults);
    for (const NoisyInput& input : search.readings.noisyInputs)
        remarks.push_back(
            phrase("the input '{}' of '{}' is recorded with noise ({:.2g} rms) that drives the model and not the "
                   "component: the search has smoothed it, the errors that are reported are with it; record it with "
                   "less noise, or smooth it",
                   input.name, search.readings.full.task.recordings[static_cast<std::size_t>(input.recording)].name,
                   input.deviation));
    for (const InputClock& clock : search.readings.drawn.clocks) {
        const double samples = clock.late / samplingInterval(search.readings.full.task);
        remarks.push_back(phrase(
            "the input '{}' is stamped {:.3g} s late ({:.2g} samples; a mean over the last sample is late by half "
            "of one): the search reckons with it, the errors that are reported do not; set it in the study as "
            "its \"clock\": {:.3g}",
            clock.input, clock.late, samples, clock.late));
    }
    if (!search.readings.drawn.clocks.empty() && search.readings.drawn.errorsOnTime)
        remarks.push_back(search.readings.drawn.errorsOnTime->second >= 0
                              ? phrase("with its inputs on time the model has an error of {:.2f} %, and of {:.2f} % on "
                                       "recordings that were not fitted",
                                       search.readings.drawn.errorsOnTime->first,
                                       search.readings.drawn.errorsOnTime->second)
                              : phrase("with its inputs on time the model has an error of {:.2f} %",
                                       search.readings.drawn.errorsOnTime->first));
    if (!search.readings.drawn.edges.empty()) remarks.push_back(remarkOn(search.readings.drawn.edges));
    std::map<int, std::vector<std::string>> ofChecks;
    for (const ToldStart& start : search.readings.checkStarts) ofChecks[start.recording].push_back(start.parameter);
    for (const auto& [recording, names] : ofChecks)
        remarks.push_back(
            phrase("'{}' does not begin where the model was told: what it begins with is estimated from it alone, and "
                   "its errors are with that ({}; say so in the study with \"initial\": \"fit\")",
                   search.readings.full.task.recordings[static_cast<std::size_t>(recording)].name, listed(names)));
    for (const ToldStart& start : search.readings.freedStarts)
        for (const FitEstimate& e : null.fit.estimates) {
            if (e.name != start.parameter || e.experiment != start.experiment) continue;
            const Recording& recording =
                search.readings.full.task.recordings[static_cast<std::size_t>(start.recording)];
            remarks.push_back(
                phrase("'{}' does not begin where the model was told: {} is {}{}{} there, not {:.5g}; "
                       "it is fitted for this recording (\"initial\": \"fit\")",
                       recording.name, start.parameter, Text::number(valueText(e.value, e.standardError)),
                       e.unit.empty() ? "" : " ", e.unit, start.value));
        }
    return remarks;
}

}  // namespace analogon
