#include "core/effect/search/without.hpp"

#include <algorithm>

#include "core/effect/judge/reason.hpp"
#include "core/effect/search/context.hpp"
#include "core/effect/search/verdicts.hpp"

namespace analogon {
namespace {

std::vector<PlacedEffect> allBut(std::vector<PlacedEffect> effects, std::size_t one) {
    effects.erase(effects.begin() + static_cast<std::ptrdiff_t>(one));
    return effects;
}

/// Whether a parameter of an effect stands at a value of its own, and is not fitted.
bool isHeld(const PlacedEffect& placed, const std::string& parameter) {
    return placed.values.contains(parameter) &&
           std::none_of(placed.freed.begin(), placed.freed.end(),
                        [&](const FitParameter& p) { return p.name == placed.instance + "." + parameter; });
}

/// The model with these effects instead, from these values, on the samples of `on`, beside the same noise.
std::optional<NullModel> refitted(const Variant& on, const NullModel& model, const std::vector<PlacedEffect>& effects,
                                  const std::vector<ParameterValue>& values, const FitOptions& options,
                                  const Progress& progress) {
    Outcome<Variant> variant = withEffects(on, effects, values);
    if (!variant) return std::nullopt;
    variant->plans = model.variant.plans;
    Outcome<NullModel> fitted = fitNull(*variant, model.noise, NoiseLevel::Keep, options, progress);
    if (!fitted) return std::nullopt;
    return std::move(*fitted);
}

}  // namespace

std::optional<NullModel> refittedWith(const SearchContext& search, const NullModel& null,
                                      const std::vector<PlacedEffect>& effects) {
    return refitted(search.readings.searched, null, effects, null.variant.values, search.fit, search.progress);
}

void seekFromTheStart(const SearchContext& search, const Variant& given, NullModel& model) {
    std::optional<NullModel> other =
        refitted(given, model, model.variant.effects, given.values, search.fit, search.progress);
    if (other && !search.progress.stopRequested() && other->sumOfSquares() < model.sumOfSquares())
        model = std::move(*other);
}

std::optional<NullModel> without(const SearchContext& search, const NullModel& null, std::size_t effect) {
    const std::vector<PlacedEffect> others = allBut(null.variant.effects, effect);
    std::optional<NullModel> best = refittedWith(search, null, others);
    for (std::size_t i = 0; i < others.size() && !search.progress.stopRequested(); ++i)
        for (const std::string& name : others[i].effect.parameters.whole)
            for (const double step : {-1.0, 1.0}) {
                std::vector<PlacedEffect> next = others;
                if (!isHeld(next[i], name)) continue;
                next[i].values[name] += step;
                if (!(next[i].values[name] >= 1)) continue;
                std::optional<NullModel> there = refittedWith(search, null, next);
                if (there && (!best || there->sumOfSquares() < best->sumOfSquares())) best = std::move(there);
            }
    return best;
}

std::optional<NullModel> withoutOnAll(const SearchContext& search, const NullModel& last, std::size_t effect) {
    return refitted(search.readings.full, last, allBut(last.variant.effects, effect), last.variant.values, search.fit,
                    search.progress);
}

bool takeOut(SearchContext& search, Node& node, std::size_t effect, const Text& why) {
    std::optional<NullModel> rest = without(search, node.null, effect);
    if (!rest) return false;
    setVerdict(search, node, node.null.variant.effects[effect], Verdict::NotSignificant, takenOut(why));
    node.null = std::move(*rest);
    node.steps.erase(node.steps.begin() + static_cast<std::ptrdiff_t>(effect));
    return true;
}

double gainOver(const NullModel& null, double sumOfSquares, int more) {
    const double rows = static_cast<double>(null.fit.optimum.residuals.size());
    const double variance = std::min(sumOfSquares, null.sumOfSquares()) / std::max(1.0, rows - null.parameterCount());
    return (null.sumOfSquares() - sumOfSquares) / variance -
           more * std::log(effectiveCount(null.channels, null.fit.optimum.residuals));
}

}  // namespace analogon
