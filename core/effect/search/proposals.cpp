#include "core/effect/search/proposals.hpp"

#include <algorithm>
#include <utility>

#include "core/base/parallel.hpp"
#include "core/effect/judge/disturbance.hpp"
#include "core/effect/judge/judgement.hpp"
#include "core/effect/judge/reason.hpp"
#include "core/effect/model/model_state.hpp"
#include "core/effect/search/context.hpp"
#include "core/effect/search/verdicts.hpp"
#include "core/effect/search/without.hpp"
#include "core/effect/thresholds.hpp"

namespace analogon {

using namespace threshold::proposals;

namespace {

/// A model with proposals, held against every recording; empty: it cannot be simulated.
std::optional<ModelState> stateWith(const NullModel& with, const SimulationOptions& simulation,
                                    const Progress& progress) {
    Outcome<ModelState> state = stateOf(with.variant, with.fit, simulation, progress, Detail::Errors);
    return state ? std::optional(std::move(*state)) : std::nullopt;
}

/// The same to be written as a study: its traces are not told.
std::optional<ProposedModel> offered(const NullModel& with, const std::optional<ModelState>& state) {
    if (!state) return std::nullopt;
    ProposedModel model{*state, {}};
    for (ExperimentState& e : model.state.experiments) {
        if (e.failure.failed) return std::nullopt;
        e.time.clear();
        for (OutputState& o : e.outputs) o.measured = o.simulated = Eigen::VectorXd();
    }
    for (const PlacedEffect& placed : with.variant.effects)
        if (!placed.newInput.empty()) model.newInputs[placed.newInput] = placed.place.spare;
    return model;
}

/// The equation of a proposal with the values that it has in a model, and the errors of that.
void tell(Remainder& r, const PlacedEffect& placed, const NullModel& model, const std::optional<ModelState>& state) {
    std::vector<EffectValue> values = estimatesOf(placed, model.fit);
    if (state)
        if (const Outcome<FlatModel> valued = flattened(model.variant.task, state->modelText))
            addOtherParameters(*valued, placed, values);
    r.proposal.equation = withValues(equationOf(placed), values);
    if (state) r.proposal.errors = errorsOf(*state);
}

}  // namespace

Conclusion takeOutProposals(SearchContext& search, Node& node) {
    Conclusion found;
    if (!hasProposal(node.null)) return found;
    const bool isDoubtful = !isNoise(node.null);
    const std::optional<ModelState> with = stateWith(node.null, search.fit.simulation, search.progress);
    found.with = node.null;
    found.model = offered(node.null, with);
    for (std::size_t i = node.steps.size(); i-- > 0;) {
        const PlacedEffect& placed = node.null.variant.effects[i];
        if (placed.effect.proposal.empty()) continue;
        Remainder r;
        r.node = placed.place.at;
        const Acceptance& gain = node.steps[i].acceptance;
        r.evidence = std::max({gain.evidence, gain.effective, 0.0});
        r.proposal.className = placed.effect.className;
        if (const auto law = search.laws.find(placed.effect.className); law != search.laws.end())
            r.proposal.block = law->second;
        tell(r, placed, node.null, with);
        std::optional<NullModel> rest = without(search, node.null, i);
        if (!rest) continue;
        const auto isMore = [&] {
            BesideDisturbance beside[2];
            parallelFor(2, search.options.threads, [&](int k) {
                beside[k] = besideDisturbance(k == 0 ? *rest : node.null, search.fit.simulation, search.progress);
            });
            return isBorneOut(beside[0], beside[1], node.null.fit.optimum.residuals.size(),
                              static_cast<int>(placed.freed.size()));
        };
        const bool isOffered = !isDoubtful || isMore();
        search.journal.test("proposal", keyOf(placed.effect, placed.place), gain, isOffered ? "offered" : "taken out",
                            r.proposal.equation);
        if (isOffered) {
            for (const Alternative& a : node.steps[i].alternatives)
                if (a.equivalent && a.kind == placed.effect.kind)
                    r.proposal.equalNodes.push_back(a.at);
                else if (a.equivalent)
                    found.sameByName.push_back(phrase("{} at {} explains as much with more parameters: {}", a.kind,
                                                      a.at, r.proposal.equation));
            found.proposed.push_back(std::move(r));
        } else {
            setVerdict(search, node, placed, Verdict::NotSignificant, takenOut(noMoreThanDisturbance()));
        }
        node.null = std::move(*rest);
        node.steps.erase(node.steps.begin() + static_cast<std::ptrdiff_t>(i));
    }
    std::reverse(found.proposed.begin(), found.proposed.end());
    return found;
}

void tellBesideNames(const SearchContext& search, const Node& node, const std::vector<PlacedEffect>& before,
                     Conclusion& conclusion) {
    std::vector<PlacedEffect> effects = node.null.variant.effects, then;
    const std::size_t names = effects.size();
    std::vector<Remainder*> told;
    std::size_t stood = 0;  // of proposals
    for (const PlacedEffect& e : before) {
        if (e.effect.proposal.empty())
            then.push_back(e);
        else
            ++stood;
        for (Remainder& r : conclusion.proposed)
            if (e.effect.className == r.proposal.className && e.place.at == r.node) {
                effects.push_back(e);
                told.push_back(&r);
            }
    }
    const bool isTold = told.size() == stood && keysOf(then) == keysOf(node.null.variant.effects);
    if (told.empty() || isTold || search.progress.stopRequested()) return;
    std::optional<NullModel> with = refittedWith(search, node.null, effects);
    if (!with) return;
    const std::optional<ModelState> state = stateWith(*with, search.fit.simulation, search.progress);
    conclusion.model = offered(*with, state);
    for (std::size_t i = 0; i < told.size(); ++i) tell(*told[i], with->variant.effects[names + i], *with, state);
    conclusion.with = std::move(with);
}

void setAsideBehindProposal(SearchContext& search, Node& node) {
    const std::vector<PlacedEffect>& all = node.null.variant.effects;
    int first = search.journal.choices + 1;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (!all[i].effect.proposal.empty()) first = std::min(first, node.steps[i].order);
    std::vector<PlacedEffect> kept;
    std::vector<Step> steps;
    std::vector<Displaced> aside;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const bool isOwn = node.steps[i].chi2Decrease > leastAgainstRest * excess(node.null);
        if (node.steps[i].order <= first || !all[i].effect.proposal.empty() || isOwn) {
            kept.push_back(all[i]);
            steps.push_back(node.steps[i]);
        } else {
            aside.push_back({all[i], node.steps[i]});
            setVerdict(search, node, all[i], Verdict::NotSignificant,
                       phrase("set aside behind an equation without a name that was chosen before it"));
        }
    }
    if (aside.empty()) return;
    std::optional<NullModel> rest = refittedWith(search, node.null, kept);
    if (!rest) return;
    node.null = std::move(*rest);
    node.steps = std::move(steps);
    node.displaced.insert(node.displaced.end(), std::make_move_iterator(aside.begin()),
                          std::make_move_iterator(aside.end()));
}

void bringBackDisplaced(SearchContext& search, Node& node, double leftByProposals) {
    for (Displaced& each : node.displaced) {
        if (search.progress.stopRequested()) return;
        search.say("reconsider", phrase("{} at {}", each.effect.effect.kind, each.effect.place.at), -1);
        std::vector<PlacedEffect> effects = node.null.variant.effects;
        effects.push_back(each.effect);
        std::optional<NullModel> with = refittedWith(search, node.null, effects);
        if (!with) continue;
        const Acceptance missed = examine(node.null, with->fit, static_cast<int>(each.effect.freed.size()), 0);
        search.journal.test("brought back", keyOf(each.effect.effect, each.effect.place), missed, "asked");
        const double chi2Decrease = node.null.sumOfSquares() - with->sumOfSquares(), left = excess(*with);
        const auto whyNot = [&]() -> Text {
            if (!isMissed(missed)) return whyRefused(missed, 0);
            if (!isDetermined(*with, effects.size() - 1)) return indistinct();
            if (fightsAnother(node.null, with->fit)) return fights();
            if (chi2Decrease < leastAgainstRest * left) return explainsLittle();
            if (leftByProposals < threshold::judgement::farLess * left)
                return phrase("leaves far more than an equation without a name");
            return {};
        };
        if (const Text why = whyNot(); !why.empty()) {
            setVerdict(search, node, each.effect, Verdict::NotSignificant, takenOut(why));
            continue;
        }
        node.null = std::move(*with);
        each.step.acceptance = missed;
        setVerdict(search, node, each.effect, Verdict::Chosen, {});
        node.steps.push_back(std::move(each.step));
    }
    node.displaced.clear();
}

}  // namespace analogon
