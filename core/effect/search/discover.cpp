#include "core/effect/search/discover.hpp"

#include "core/base/stop.hpp"
#include "core/effect/judge/caution.hpp"
#include "core/effect/model/model_state.hpp"
#include "core/effect/reading/held_command.hpp"
#include "core/effect/search/first_fit.hpp"
#include "core/effect/search/interrupted.hpp"
#include "core/effect/search/run.hpp"

namespace analogon {
namespace {

struct HeldInputs {
    HeldReading reading;
    double errorOnLines{};  // [%]
};

/// The inputs of a task that are held by what a fit on straight lines, `null`, leaves.
std::optional<HeldInputs> heldInputs(NullModel& null, const FitOptions& options, const Progress& progress) {
    if (progress.stopRequested() || !fitNull(null, NoiseLevel::Estimate, options, progress)) return std::nullopt;
    const std::optional<HeldReading> reading = heldReading(null, options, progress);
    if (!reading) return std::nullopt;
    const Outcome<ModelState> state = stateOf(null.variant, null.fit, options.simulation, progress, Detail::Errors);
    if (!state) return std::nullopt;
    return HeldInputs{*reading, errorPercentOf(*state, Role::Fit)};
}

}  // namespace

Outcome<ModelState> fitModel(const EstimationTask& task, const FitOptions& options, const Progress& progress) {
    NullModel null;
    null.variant.task = task;
    const auto state = [&]() -> Outcome<ModelState> {
        try {
            const StopScope scope(progress.stopToken());
            if (Outcome<Done> fitted = fitNull(null, NoiseLevel::Estimate, beginningAnywhere(options), progress);
                !fitted)
                return fitted.diagnostics();
            Outcome<ModelState> whole =
                stateOf(null.variant, null.fit, options.simulation, progress, Detail::Report, options.threads);
            stopPoint();
            return whole;
        } catch (const Stopped&) {
            if (null.fit.estimates.empty()) return error(phrase("cancelled"));
            const std::stop_source nobody;
            const StopScope scope(nobody.get_token());
            return stateSoFar(null, options.simulation);
        }
    };
    Outcome<ModelState> found = state();
    if (!found) return found;
    if (null.beginning) found->remarks.insert(found->remarks.begin(), null.beginning->remark);
    if (Text still = nothingMoves(task, *found); !still.empty())
        found->remarks.push_back(std::move(still));
    else if (Text few = tooFewSamples(null); !few.empty())
        found->remarks.push_back(std::move(few));
    for (const Role role : {Role::Fit, Role::Validate})
        for (Text& sentence : wrongStarts(*found, role)) found->remarks.push_back(std::move(sentence));
    if (progress.stopRequested()) return found;
    if (const auto reading = heldReading(null, options.besideOthers(), progress))
        for (Text& remark : heldRemarks(task, *reading, errorPercentOf(*found, Role::Fit), false))
            found->remarks.push_back(std::move(remark));
    return found;
}

Outcome<ModelState> simulateModel(const EstimationTask& task, const SimulationOptions& options,
                                  const Progress& progress) {
    const Variant variant{task, {}, {}};
    SimulationOptions watched = options;
    double shown = 0;  // what is simulated once more does not set the bar back
    watched.reached = [&](double part) {
        shown = std::max(shown, part);
        progress.report({"simulate", {}, shown});
    };
    watched.reached(0);
    Outcome<ModelState> state = stateOf(variant, {}, watched, progress);
    // the values at which a model stands say little: which reading is right is seen where they are fitted
    FitOptions fit;
    fit.simulation = options;
    if (!state || !anyLooksHeld(task)) return state;
    NullModel null;
    null.variant.task = task;
    if (const auto found = heldInputs(null, fit, progress))
        for (Text& remark : heldRemarks(task, found->reading, found->errorOnLines, false))
            state->remarks.push_back(std::move(remark));
    return state;
}

Outcome<Finding> discover(const EstimationTask& task, const DiscoverOptions& options, const Progress& progress) {
    NullModel onLines;
    onLines.variant.task = task;
    std::optional<HeldInputs> held;
    try {
        const StopScope scope(progress.stopToken());
        held = heldInputs(onLines, options.fit, progress);
        stopPoint();
    } catch (const Stopped&) {
        const std::stop_source nobody;
        const StopScope scope(nobody.get_token());
        return fittedSoFar(onLines, options.fit.simulation);
    }
    if (!held) return Run(task, options, progress).run();
    EstimationTask read = task;
    holdInputs(read, held->reading.inputs);
    Outcome<Finding> finding = Run(read, options, progress).run();
    if (!finding) return finding;
    finding->heldInputs = held->reading.inputs;
    std::vector<Text> remarks = heldRemarks(task, held->reading, held->errorOnLines, true);
    finding->warnings.insert(finding->warnings.begin(), remarks.begin(), remarks.end());
    return finding;
}

}  // namespace analogon
