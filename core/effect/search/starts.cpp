#include "core/effect/search/starts.hpp"

#include <algorithm>
#include <cmath>

#include "core/effect/judge/disturbance.hpp"
#include "core/effect/judge/judgement.hpp"
#include "core/effect/model/model_state.hpp"
#include "core/effect/search/context.hpp"
#include "core/effect/search/recordings.hpp"
#include "core/effect/thresholds.hpp"

namespace analogon {

using namespace threshold::startValue;

namespace {

/// Whether a check determines what it was estimated to begin with: that of an angle tells nothing where nothing depends
/// on it.
bool isDetermined(const ToldStart& start, const ModelState& state) {
    int check = -1;
    for (const ExperimentState& e : state.experiments) {
        if (e.role != Role::Validate || ++check != start.experiment) continue;
        return std::any_of(e.starts.begin(), e.starts.end(), [&](const FitEstimate& estimate) {
            return estimate.name == start.parameter && std::isfinite(estimate.standardError) &&
                   estimate.standardError > 0;
        });
    }
    return false;
}

/// The model with start values fitted, or held where they were told to be.
Outcome<NullModel> fittedWith(const SearchContext& search, Variant variant, const std::vector<Eigen::VectorXd>& noise,
                              const std::vector<ToldStart>& starts, bool isFitted) {
    setFitted(variant.task, starts, isFitted);
    for (const ToldStart& start : starts)
        if (!isFitted)
            std::erase_if(variant.values, [&](const ParameterValue& v) {
                return v.experiment == start.experiment && v.name == start.parameter;
            });
    return fitNull(variant, noise, isFitted ? NoiseLevel::Estimate : NoiseLevel::Keep, search.fit, search.progress);
}

/// Whether the model needs a start value to be fitted, beside the effects found since; `held`: the model without.
bool isNeeded(const SearchContext& search, const ToldStart& start, const NullModel& null, const NullModel& held) {
    // in mid run any state is somewhere else, were it for a sample alone
    const auto rows = static_cast<double>(null.fit.optimum.residuals.size());
    if (start.isOfMidRun) return held.sumOfSquares() - null.sumOfSquares() > equivalenceMargin + std::log(rows);
    const Acceptance missed = examine(held, null.fit, 1, 0);
    const auto isMore = [&] {
        return isBorneOut(besideDisturbance(held, search.fit.simulation, search.progress),
                          besideDisturbance(null, search.fit.simulation, search.progress),
                          null.fit.optimum.residuals.size(), 1);
    };
    return missed.isSignificant && missed.isWorthwhile && (isNoise(null) || isMore());
}

}  // namespace

bool canTry(const std::vector<ToldStart>& starts) { return starts.size() <= mostToldStarts; }

bool isElsewhere(const ToldStart& start, const FitEstimate* fitted) {
    return fitted != nullptr && std::abs(fitted->value - start.value) > leastMoved * fitted->standardError;
}

std::optional<Begun> findBeginning(const SearchContext& search, const NullModel& null, Against against,
                                   double threshold) {
    std::vector<ToldStart> starts = startsBegunElsewhere(null, against);
    if (!canTry(starts)) return std::nullopt;
    while (!starts.empty()) {
        search.say("reconsider", starts.front().parameter, -1);
        Variant variant = null.variant;
        for (const ToldStart& start : starts) setFitted(variant.task, start, true);
        const auto count = static_cast<int>(starts.size());
        std::optional<Allowed> with = allowed(search, null, variant, count, threshold);
        if (null.variant.effects.empty()) {
            variant.values.clear();  // parameters that made up for the start may lead nowhere
            if (std::optional<Allowed> anew = allowed(search, null, variant, count, threshold);
                anew && (!with || anew->fit.objective < with->fit.objective))
                with = std::move(anew);
        }
        if (!with) return std::nullopt;
        const auto isLikeTold = [&](const ToldStart& start) {
            return !isElsewhere(start, with->fit.find(start.parameter, start.experiment));
        };
        if (std::erase_if(starts, isLikeTold) > 0) continue;
        if (!with->gain.isSignificant || !with->gain.isWorthwhile) return std::nullopt;
        return Begun{std::move(starts), with->gain, valuesOf(with->fit), with->fit.optimum.residuals.squaredNorm()};
    }
    return std::nullopt;
}

void freeStarts(SearchContext& search, const std::vector<ToldStart>& starts) {
    setFitted(search.readings.searched.task, starts, true);
    setFitted(search.readings.full.task, starts, true);
    for (const ToldStart& start : starts)
        search.journal.add("reading", "start " + start.parameter,
                           {{"recording", start.recording}, {"told", start.value}}, "accepted");
    search.readings.freedStarts.insert(search.readings.freedStarts.end(), starts.begin(), starts.end());
}

bool refitWith(SearchContext& search, NullModel& null, const std::vector<ToldStart>& starts,
               std::vector<ParameterValue> values) {
    Variant variant = null.variant;
    variant.values = std::move(values);
    Outcome<NullModel> next = fittedWith(search, std::move(variant), null.noise, starts, true);
    if (!next || search.progress.stopRequested()) return false;
    freeStarts(search, starts);
    null = std::move(*next);
    return true;
}

void holdUnneededStarts(SearchContext& search, NullModel& null) {
    for (const ToldStart& start : std::vector<ToldStart>(search.readings.freedStarts)) {
        Outcome<NullModel> held = fittedWith(search, null.variant, null.noise, {start}, false);
        if (search.progress.stopRequested()) return;
        if (!held || isNeeded(search, start, null, *held)) continue;
        search.journal.add("reading", "start " + start.parameter,
                           {{"recording", start.recording}, {"told", start.value}}, "taken back");
        setFitted(search.readings.searched.task, {start}, false);
        setFitted(search.readings.full.task, {start}, false);
        std::erase_if(search.readings.freedStarts, [&](const ToldStart& s) {
            return s.recording == start.recording && s.parameter == start.parameter;
        });
        null = std::move(*held);
    }
}

void freeChecks(SearchContext& search, const NullModel& null) {
    Outcome<Variant> whole = onAllSamples(search.readings, null);
    if (!whole) return;
    const auto checked = [&] { return stateOf(*whole, null.fit, search.fit.simulation, Progress(), Detail::Errors); };
    const Outcome<ModelState> told = checked();
    if (!told) return;
    const bool allDo = std::any_of(search.readings.freedStarts.begin(), search.readings.freedStarts.end(),
                                   [](const ToldStart& s) { return s.isOfMidRun; });
    std::vector<ToldStart> starts = startsOfChecks(search.readings.full.task, *told, allDo);
    if (starts.empty()) return;
    setFitted(whole->task, starts, true);
    const Outcome<ModelState> freed = checked();
    if (!freed) return;
    // what is no beginning is not mended by another one
    const std::vector<ToldStart> still = startsOfChecks(search.readings.full.task, *freed, false);
    std::erase_if(starts, [&](const ToldStart& start) {
        const bool isOfNoBeginning =
            std::any_of(still.begin(), still.end(), [&](const ToldStart& s) { return s.recording == start.recording; });
        return isOfNoBeginning || !isDetermined(start, *freed);
    });
    setFitted(search.readings.searched.task, starts, true);
    setFitted(search.readings.full.task, starts, true);
    for (const ToldStart& start : starts)
        search.journal.add("reading", "start of a check " + start.parameter, {{"recording", start.recording}},
                           "estimated");
    search.readings.checkStarts = std::move(starts);
}

}  // namespace analogon
