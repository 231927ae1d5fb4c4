#include "core/effect/search/recordings.hpp"

#include <algorithm>
#include <vector>

#include "core/base/parallel.hpp"
#include "core/effect/block/trial.hpp"
#include "core/effect/model/thin.hpp"
#include "core/effect/search/context.hpp"
#include "core/effect/search/redraw.hpp"
#include "core/effect/search/starts.hpp"

namespace analogon {
namespace {

/// The model beside inputs without their noise; so in all that the search fits from here on.
bool refitQuiet(SearchContext& search, NullModel& null, Variant quiet, const std::vector<NoisyInput>& noisy) {
    Outcome<NullModel> next = fitNull(quiet, null.noise, NoiseLevel::Estimate, search.fit, search.progress);
    if (!next || search.progress.stopRequested()) return false;
    null = std::move(*next);
    quieten(search.readings.searched.task);
    if (!search.readings.drawn.clocks.empty()) {
        EstimationTask stamped = search.readings.searched.task;
        stamped.recordings = std::move(search.readings.drawn.stamped);
        quieten(stamped);
        search.readings.drawn.stamped = std::move(stamped.recordings);
    }
    for (const NoisyInput& input : noisy)
        search.journal.add("reading", "noise of " + input.name,
                           {{"recording", input.recording}, {"deviation", input.deviation}}, "accepted");
    search.readings.noisyInputs = noisy;
    return true;
}

}  // namespace

bool leaveOutFaults(SearchContext& search, const NullModel& fitted) {
    search.readings.faults = faultySamples(fitted);
    leaveOut(search.readings.full.task, search.readings.faults);
    for (const FaultySamples& f : search.readings.faults)
        search.journal.add("reading", "faulty samples " + f.output,
                           {{"recording", f.recording}, {"begin", f.begin}, {"end", f.end}}, "left out");
    if (!search.readings.faults.empty())
        search.readings.searched.task = thinned(search.readings.full.task, search.readings.thinning);
    return !search.readings.faults.empty();
}

std::optional<Allowed> allowed(const SearchContext& search, const NullModel& null, const Variant& variant, int freed,
                               double threshold) {
    if (search.progress.stopRequested()) return std::nullopt;
    const FitOptions options = trialOptions(search.fit, search.fit.maxIterations);
    std::optional<FitResult> fit = fitBeside(null, variant, options, search.progress);
    if (!fit) return std::nullopt;
    const Acceptance gain = examine(null, *fit, freed, threshold);
    return Allowed{std::move(*fit), gain};
}

bool allowForRecordings(SearchContext& search, NullModel& null, const Round& round) {
    double most = round.chosen ? round.acceptance.effective : 0;
    const auto explainsMore = [&](const std::string& reading, const Variant& variant, int freed) {
        const std::optional<Allowed> there = allowed(search, null, variant, freed, round.threshold);
        if (!there) return false;
        const bool isMore = there->gain.isSignificant && there->gain.isWorthwhile && there->gain.effective > most;
        search.journal.test("reading", reading, there->gain, isMore ? "explains more" : "refused");
        if (isMore) most = there->gain.effective;
        return isMore;
    };
    std::vector<ToldStart> freed;
    std::vector<ParameterValue> values = null.variant.values;  // from which they are fitted
    // what is left beside effects may be larger at the start by chance
    const Against against = null.variant.effects.empty() ? Against::Noise : Against::Residual;
    std::optional<Begun> begun = findBeginning(search, null, against, round.threshold);
    if (begun && begun->gain.effective > most) {
        most = begun->gain.effective;
        freed = std::move(begun->starts);
        values = std::move(begun->values);
    }
    const Outcome<std::vector<ToldStart>> told = toldStarts(null.variant.task);
    if (!begun && told && canTry(*told))
        for (const ToldStart& start : *told) {
            search.say("reconsider", start.parameter, -1);
            Variant variant = null.variant;
            setFitted(variant.task, start, true);
            if (explainsMore("start " + start.parameter, variant, 1)) freed = {start};
        }
    Variant quiet = null.variant;
    const std::vector<NoisyInput> noisy =
        search.readings.noisyInputs.empty() ? quieten(quiet.task) : std::vector<NoisyInput>();
    if (!noisy.empty()) {
        search.say("reconsider", phrase("noise of the inputs"), -1);
        if (explainsMore("noise of inputs", quiet, static_cast<int>(noisy.size())))
            return refitQuiet(search, null, std::move(quiet), noisy);
    }
    std::optional<Late> late;
    Drawings drawn;
    const bool canPlace = canPlaceEdges(search, null);
    parallelFor(2, search.options.threads, [&](int i) {
        if (i == 1)
            late = findClocks(search, null, round.threshold, most);
        else if (canPlace)
            drawn = drawings(search, null, round.threshold);
    });
    if (late) most = late->with.gain.effective;
    if (canPlace && placeEdges(search, null, std::move(drawn), round.threshold, most)) return true;
    if (late) return refitLate(search, null, std::move(*late));
    return !freed.empty() && refitWith(search, null, freed, values);
}

}  // namespace analogon
