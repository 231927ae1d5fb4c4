#include "core/effect/search/ending.hpp"

#include <algorithm>
#include <iterator>

#include "core/base/stop.hpp"
#include "core/effect/judge/caution.hpp"
#include "core/effect/model/model_state.hpp"
#include "core/effect/search/context.hpp"
#include "core/effect/search/path.hpp"
#include "core/effect/search/reading_remarks.hpp"
#include "core/effect/search/verdicts.hpp"
#include "core/effect/tell/offer.hpp"
#include "core/effect/tell/other_value.hpp"
#include "core/effect/tell/proposed_value.hpp"

namespace analogon {
namespace {

void append(std::vector<Text>& sentences, std::vector<Text> more) {
    sentences.insert(sentences.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

std::vector<Text> noiseRemarks(const Leftovers& left) {
    std::vector<Text> said;
    for (const ColouredNoise& n : left.noise)
        said.push_back(
            phrase("what is left on output '{}' of '{}' is noise with a memory ({:.2g} s): it moves with nothing "
                   "that is recorded or simulated, and is taken for noise of the measurement",
                   n.output, n.experiment, n.memory));
    for (const UnevenNoise& n : left.uneven)
        said.push_back(
            phrase("the noise on output '{}' of '{}' comes and goes, by a factor of {:.2g}: in units of what it is "
                   "near each sample, what is left there is noise",
                   n.output, n.experiment, n.ratio));
    return said;
}

/// Where what is left is likeliest to come from; a sensor shows on its own output alone.
void tellPlaces(const std::vector<std::string>& places, std::vector<Remainder>& remainders) {
    if (places.empty()) return;
    const bool isSensor = places.front().starts_with(outputPrefix);
    for (Remainder& r : remainders) {
        if (isSensor && places.front().substr(outputPrefix.size()) != r.output) continue;
        r.node = places.front();
        r.proposal.equalNodes.assign(places.begin() + 1, places.end());
    }
}

/// What is left, as long as it is more than the forms of the effects may leave.
void tellWhatIsLeft(const SearchContext& search, Ending& end, const Leftovers& left) {
    Finding& finding = end.finding;
    finding.unexplained.remainders = left.structure;
    // else that accounts for it
    if (search.courses.areEmpty() && end.heldWrongly.empty()) append(finding.warnings, noiseRemarks(left));
    const bool isIndicated = std::any_of(end.node.steps.begin(), end.node.steps.end(),
                                         [](const Step& s) { return s.prediction.has_value(); });
    const bool isSmall =
        !isIndicated && std::all_of(finding.unexplained.remainders.begin(), finding.unexplained.remainders.end(),
                                    [&](const Remainder& r) { return isWithinForms(end.node, r.evidence); });
    if (isSmall && end.conclusion.proposed.empty() && !finding.unexplained.remainders.empty()) {
        finding.warnings.push_back(
            phrase("what is left on output '{}' of '{}' is not quite noise, but far less than what was found "
                   "explains: the forms of its blocks (a rounded change of sign, an exact square) may leave as much",
                   finding.unexplained.remainders.front().output, finding.unexplained.remainders.front().experiment));
        finding.unexplained.remainders.clear();
    }
    tellPlaces(end.source.places, finding.unexplained.remainders);
    if (!finding.unexplained.remainders.empty()) finding.unexplained.disturbance = end.source.flow;
}

void tellProposals(const SearchContext& search, Ending& end, const std::vector<ColouredNoise>& noise) {
    Finding& finding = end.finding;
    if (!end.conclusion.proposed.empty()) {
        append(finding.warnings, std::move(end.conclusion.sameByName));
        finding.unexplained.proposed = std::move(end.conclusion.model);
    }
    const std::size_t offered = end.conclusion.proposed.size();
    offer(std::move(end.conclusion.proposed), noise, finding.final, finding.unexplained.remainders);
    if (offered > 0 && end.conclusion.with)
        keepWhatIsLeft(*end.conclusion.with, offered, search.options.fit.simulation, finding.unexplained.remainders);
}

/// A parameter that is not constant, first among what is left, and what it accounts for not told again.
template <class Course>
void offerCourse(const SearchContext& search, Ending& end, const std::vector<ColouredNoise>& noise, Remainder r,
                 const Course& course) {
    offerAlone(std::move(r), noise, end.finding.final, end.finding.unexplained.remainders);
    keepWhatIsLeft(end.base.with(course.variant, course.fit), 1, search.options.fit.simulation,
                   end.finding.unexplained.remainders);
}

void tellChange(const SearchContext& search, Ending& end, const std::vector<ColouredNoise>& noise) {
    Finding& finding = end.finding;
    const Change& change = *search.courses.change;
    const double last = finding.final.experiments[static_cast<std::size_t>(change.experiment)].time.back();
    Remainder r = remainderOf(change, last);
    finding.warnings.push_back(
        phrase("the condition seems to have changed in mid run: {} at about {:.4g} s", change.parameter, change.time));
    const std::vector<Recording>& recordings = search.readings.full.task.recordings;
    if (const Outcome<ErrorsOfChange> errors =
            errorsOf(change, recordings, search.options.fit.simulation, search.progress)) {
        r.proposal.errors.fit = errors->fitted;
        if (errors->checks.size() == recordingsOf(search.readings.full.task, Role::Validate).size())
            r.proposal.errors.validate = leastOf(errors->checks);
        for (const CheckOfChange& c : errors->checks) finding.warnings.push_back(remarkOf(c, change.parameter));
    }
    offerCourse(search, end, noise, std::move(r), change);
}

void tellHeldWrongly(Ending& end, const std::vector<ColouredNoise>& noise) {
    const std::vector<HeldInstead>& values = end.heldWrongly;
    offerAlone(remainderOf(values.front()), noise, end.finding.final, end.finding.unexplained.remainders);
    end.finding.warnings.push_back(remarkOf(values.front()));
    std::transform(values.begin() + 1, values.end(), std::back_inserter(end.finding.warnings), remarkOfEqual);
}

void tellDependence(const SearchContext& search, Ending& end, const std::vector<ColouredNoise>& noise) {
    const ChannelDependence& dependence = *search.courses.dependence;
    Remainder r = remainderOf(dependence);
    if (const Outcome<ModelState> with =
            stateOf(dependence.variant, dependence.fit, search.options.fit.simulation, search.progress, Detail::Errors))
        r.proposal.errors = errorsOf(*with);
    offerCourse(search, end, noise, std::move(r), dependence);
    end.finding.warnings.push_back(
        phrase("{} seems to move with the recorded channel {}", dependence.parameter, dependence.channel));
}

FindingKind kindOf(const Finding& finding) {
    if (finding.unexplained.remainders.empty())
        return finding.effects.empty() ? FindingKind::Adequate : FindingKind::Effect;
    return finding.effects.empty() ? FindingKind::Unexplained : FindingKind::Partial;
}

}  // namespace

Finding tellEnding(SearchContext& search, Ending end) {
    Finding& finding = end.finding;
    const NullModel& null = end.node.null;
    const SimulationOptions& simulation = search.options.fit.simulation;
    const Readings& readings = search.readings;
    const auto& onTime = readings.drawn.errorsOnTime;

    const Outcome<FlatModel> valued = flattened(null.variant.task, finding.final.modelText);
    const std::vector<Text> heldRemarks =
        addEffects(finding, end.node, end.held, valued ? &*valued : nullptr, onTime ? onTime->first : -1);
    stopPoint();
    const Leftovers left = leftovers(end.beforeReading ? *end.beforeReading : null, simulation);
    tellWhatIsLeft(search, end, left);
    tellProposals(search, end, left.noise);
    if (search.courses.change) tellChange(search, end, left.noise);
    if (!end.heldWrongly.empty()) tellHeldWrongly(end, left.noise);
    if (search.courses.dependence) tellDependence(search, end, left.noise);
    for (Remainder& r : finding.unexplained.remainders)
        if (r.proposal.errors.validate >= 0)
            r.proposal.errorValidateWithout = errorPercentOf(finding.final, Role::Validate);
    finding.candidates = std::move(end.node.candidates);
    settleVerdicts(finding, finding.candidates);

    const bool isRedrawn = !readings.drawn.asRecorded.empty();
    const Recordings& recorded = isRedrawn ? readings.drawn.asRecorded : readings.full.task.recordings;
    const std::vector<FaultySamples> unfitted = faultySamples(recorded, finding.final);
    const ModelState sound = withoutFaults(finding.final, unfitted);
    EstimationTask measured = readings.full.task;
    measured.recordings = recorded;
    leaveOut(measured, unfitted);
    append(finding.warnings, recordingRemarks(search, null));
    append(finding.warnings, faultRemarks(recorded, unfitted, finding.final, sound));
    append(finding.warnings, extrapolations(measured));
    append(finding.warnings, driftBetweenRecordings(null));
    append(finding.warnings, boundHits(null.fit));
    append(finding.warnings, delaysInSamples(readings.full.task, finding.effects));
    append(finding.warnings, heldRemarks);
    finding.kind = kindOf(finding);
    const std::vector<Step>& steps = end.node.steps;
    if (finding.kind == FindingKind::Effect && steps.size() == 1 && !steps.front().equation.empty())
        finding.warnings.push_back(
            phrase("an equation without a name explains as much as {} at {}, and the data do not tell them apart: {}",
                   finding.effects.front().kind, finding.effects.front().at, steps.front().equation));
    append(finding.warnings, poorValidations(sound));
    Variant asMeasured = null.variant;
    asMeasured.task.recordings = measured.recordings;
    append(finding.warnings, otherValues(asMeasured, sound, search.fit, search.progress));
    if (!finding.unexplained.remainders.empty()) {
        append(finding.warnings, wrongStarts(finding.final, Role::Fit));
        append(finding.warnings, stuckReadings(readings.full.task));
    }
    return std::move(finding);
}

}  // namespace analogon
