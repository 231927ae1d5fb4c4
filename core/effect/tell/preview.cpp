#include "core/effect/tell/preview.hpp"

#include <algorithm>

#include "core/effect/block/trial.hpp"
#include "core/effect/model/model_state.hpp"
#include "core/effect/model/thin.hpp"

namespace analogon {
namespace {

Outcome<Candidate> candidateOf(const Variant& variant, const EffectChoice& choice) {
    Outcome<std::vector<EffectClass>> catalogue = effectCatalogue(variant.task.library);
    if (!catalogue) return catalogue.diagnostics();
    std::erase_if(*catalogue, [&](const EffectClass& e) { return e.className != choice.className; });
    Outcome<std::vector<Candidate>> candidates = candidatesFor(variant, *catalogue);
    if (!candidates) return candidates.diagnostics();
    for (Candidate& c : *candidates)
        if (c.place.at == choice.at) return std::move(c);
    return error(phrase("this effect has no such place in the model"));
}

}  // namespace

Outcome<ModelState> stateWith(const EstimationTask& task, const EffectChoice& choice, const FitOptions& options,
                              const Progress& progress) {
    const Variant base{thinned(task, thinningFor(task, mostSearchedSamples)), {}, {}};
    const Outcome<Candidate> candidate = candidateOf(base, choice);
    if (!candidate) return candidate.diagnostics();
    FitOptions quick = trialOptions(options, trialIterations);
    const Outcome<NullModel> null = fitNull(base, {}, NoiseLevel::Estimate, quick, progress);
    if (!null) return null.diagnostics();
    quick.simulation = limited(*null, quick.simulation);
    const Screened screened = screen(*null, *candidate, quick.simulation, progress);
    if (!screened.failure.empty()) return numericalError(screened.failure, {});
    const Trial trial = refit(*null, screened, quick, 1, progress);
    if (!trial.ok)
        return numericalError(trial.failure.empty() ? phrase("the data do not show this effect") : trial.failure, {});
    Outcome<Variant> whole = withEffects(Variant{task, {}, {}}, trial.variant.effects, trial.variant.values);
    if (!whole) return whole.diagnostics();
    return stateOf(*whole, trial.fit, options.simulation, progress, Detail::Errors);
}

}  // namespace analogon
