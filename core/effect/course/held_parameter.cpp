#include "core/effect/course/held_parameter.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/unit.hpp"
#include "core/effect/model/model_state.hpp"
#include "core/effect/reading/start_value.hpp"
#include "core/effect/thresholds.hpp"
#include "core/flat/flat_model.hpp"

namespace analogon {

using namespace threshold::heldValue;
using threshold::acceptance::clearEvidence;
using threshold::likely::likelyShare;
using threshold::likely::mostAgain;

namespace {

/// Where the recordings hold a parameter: as the study says, else as the model does; nothing where they differ.
std::optional<double> heldAt(const EstimationTask& task, const std::string& name, std::optional<double> inModel) {
    std::optional<double> common;
    for (const Recording& r : task.recordings) {
        std::optional<double> here = inModel;
        for (const RecordingStart& s : r.starts)
            if (s.parameter == name) here = s.isFitted ? std::nullopt : std::optional<double>(s.value);
        if (!here || (common && *common != *here)) return std::nullopt;
        common = here;
    }
    return common;
}

/// The variant with these parameters fitted that were held, or within wider bounds.
Variant withFreed(Variant variant, const std::vector<FitParameter>& held) {
    for (const FitParameter& p : held) {
        std::erase_if(variant.task.parameters, [&](const FitParameter& fitted) { return fitted.name == p.name; });
        variant.task.parameters.push_back(p);
        const auto isIts = [&](const RecordingStart& s) { return s.parameter == p.name; };
        if (std::any_of(variant.task.recordings.begin(), variant.task.recordings.end(),
                        [&](const Recording& r) { return std::any_of(r.starts.begin(), r.starts.end(), isIts); }))
            for (Recording& r : variant.task.recordings.edit()) std::erase_if(r.starts, isIts);
    }
    return variant;
}

/// Real parameters with a number of their own (other than 0) that are not fitted and belong to no effect.
std::vector<FitParameter> heldParameters(const Variant& variant) {
    const Outcome<FlatModel> flat = flatten(variant.task.library, variant.task.className);
    if (!flat) return {};
    const std::vector<std::string> starts = startParameters(*flat);
    const auto isOfAnEffect = [&](const std::string& name) {
        return std::any_of(variant.effects.begin(), variant.effects.end(),
                           [&](const PlacedEffect& e) { return name.starts_with(e.instance + "."); });
    };
    const auto isFitted = [&](const std::string& name) {
        return std::any_of(variant.task.parameters.begin(), variant.task.parameters.end(),
                           [&](const FitParameter& p) { return p.name == name; });
    };
    std::vector<FitParameter> held;
    for (const FlatVariable& v : flat->variables) {
        if (!isTunable(v) || !v.binding.valid() || !flat->pool->isConstant(v.binding)) continue;
        if (isFitted(v.name) || isOfAnEffect(v.name) || std::binary_search(starts.begin(), starts.end(), v.name))
            continue;
        const std::optional<double> value = heldAt(variant.task, v.name, flat->parameterValue(flat->find(v.name)));
        if (!value || *value == 0 || !std::isfinite(*value)) continue;
        held.push_back({v.name, v.unit, *value, std::min(*value / reach, *value * reach),
                        std::max(*value / reach, *value * reach)});
    }
    return held;
}

/// Fitted parameters that rest at a bound, with room beyond it: a bound that is too narrow holds them.
std::vector<FitParameter> boundParameters(const NullModel& without) {
    std::vector<FitParameter> bound;
    for (const FitParameter& p : without.variant.task.parameters)
        for (const FitEstimate& e : without.fit.estimates) {
            if (e.name != p.name || !e.atBound || e.experiment >= 0 || !(e.value > 0)) continue;
            FitParameter wider = p;
            wider.start = e.value;
            if (p.max - e.value < e.value - p.min)
                wider.max = std::max(p.max, e.value * reach);
            else
                wider.min = std::min(p.min, e.value / reach);
            bound.push_back(wider);
        }
    return bound;
}

struct Likely {
    const FitParameter* parameter;
    double explained;
};

/// What each could explain, in first order; the most first.
std::vector<Likely> likely(const NullModel& without, const std::vector<FitParameter>& held, const FitOptions& options,
                           const Progress& progress) {
    const Outcome<PreparedTask> prepared = prepareAt(withFreed(without.variant, held), without.noise);
    if (!prepared) return {};
    const FitProblem& problem = prepared->problem;
    const Linearisation line = linearise(problem, problem.startValues(), true, {}, options.simulation, progress);
    if (!line.ok || line.residuals.size() != without.fit.optimum.residuals.size()) return {};
    const OrthogonalProjector complement(without.fit.optimum.jacobian);
    std::vector<Likely> all;
    for (std::size_t j = 0; j < problem.parameters.size(); ++j)
        for (const FitParameter& p : held) {
            if (problem.parameters[j].name != p.name) continue;
            const Eigen::MatrixXd column = line.jacobian.col(static_cast<Eigen::Index>(j));
            all.push_back({&p, scoreColumns(complement, without.fit.optimum.residuals, column, false).explained});
        }
    std::stable_sort(all.begin(), all.end(),
                     [](const Likely& a, const Likely& b) { return a.explained > b.explained; });
    return all;
}

}  // namespace

Text HeldInstead::text() const { return phrase("{} = {:.5g}{}", parameter, value, behindNumber(unit)); }

std::vector<HeldInstead> heldInstead(const NullModel& without, const NullModel& with, const FitOptions& options,
                                     const Progress& progress) {
    const double rows = static_cast<double>(with.fit.optimum.residuals.size());
    const double left = sumInUnitsOf(without, with), chi2Decrease = without.sumOfSquares() - left;
    const double variance = left / rows;
    const std::vector<FitParameter> held = heldParameters(without.variant);
    std::vector<HeldInstead> found;
    const std::vector<FitParameter> bound = boundParameters(without);
    std::vector<const FitParameter*> tried;
    for (const FitParameter& p : bound)
        tried.push_back(&p);  // what they would explain beyond has no slope at the bound
    for (const Likely& l : likely(without, held, options, progress))
        if (tried.size() < bound.size() + mostAgain && l.explained >= likelyShare * chi2Decrease)
            tried.push_back(l.parameter);
    for (std::size_t i = 0; i < tried.size() && !progress.stopRequested(); ++i) {
        const FitParameter& p = *tried[i];
        Variant freed = withFreed(without.variant, {p});
        const std::optional<FitResult> fit = fitBeside(without, freed, options, progress);
        if (!fit) continue;
        freed.values = valuesOf(*fit);
        const double squares = fit->optimum.residuals.squaredNorm();
        if (squares > left + equivalenceMargin * variance) continue;
        const double gain = (left - squares) / (squares / rows);
        for (const FitEstimate& e : fit->estimates) {
            if (e.name != p.name) continue;
            const double factor = e.value / p.start;
            if (std::abs(factor - 1) < otherValue) continue;
            const bool isPlausible = factor > 1 / plausibleFactor && factor < plausibleFactor;
            if (!isPlausible && !(gain > clearEvidence)) continue;
            found.push_back({p.name, p.unit, p.start, e.value, e.standardError, i < bound.size(),
                             isNoise(with.channels, *fit), gain,
                             (without.sumOfSquares() - squares) / (squares / rows)});
            if (const Outcome<ModelState> state = stateOf(freed, *fit, options.simulation, progress, Detail::Errors))
                found.back().errors = errorsOf(*state);
        }
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const HeldInstead& a, const HeldInstead& b) { return a.gain > b.gain; });
    return found;
}

}  // namespace analogon
