/// Equations without a name, that are offered and not added; and experiments that would tell effects apart.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/base/parallel.hpp"
#include "core/effect/block/law.hpp"
#include "core/effect/course/held_parameter.hpp"
#include "core/effect/judge/reason.hpp"
#include "core/effect/model/model_state.hpp"
#include "core/effect/search/search.hpp"
#include "core/effect/tell/next_experiment.hpp"

namespace analogon {
namespace {

constexpr int mostExperiments = 2;      // proposed to tell effects apart
constexpr double clearSeparation = 20;  // squared, in standard deviations
constexpr double leastAgainstRest = 5;  // times what is left above the noise
constexpr double farLess = 0.1;         // of what is left above the noise

Text otherValue(const HeldInstead& held) { return phrase("another value of {} is the better account", held.parameter); }

/// The best of them, and what the data do not tell from it.
std::vector<HeldInstead> equalToFirst(std::vector<HeldInstead> values) {
    std::erase_if(values, [best = values.empty() ? 0 : values.front().gain](const HeldInstead& h) {
        return h.gain < best - equivalenceMargin;
    });
    return values;
}

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
    r.proposedEquation = withValues(equationOf(placed), values);
    if (state) {
        r.errorFitWith = errorPercentOf(*state, Role::Fit);
        r.errorValidateWith = validationErrorOf(*state);
    }
}

}  // namespace

/// Fits the likeliest laws of what the model lacks; their classes join the libraries.
std::vector<Trial> Search::tryLaws(NullModel& null) {
    say("propose", phrase("a law for what is left"), -1);
    const std::vector<Law> laws =
        likelyLaws(null, static_cast<int>(laws_.size()), search_.fit.simulation, options_.threads, progress_);
    for (const Law& law : laws) {
        const std::string& name = law.candidate.effect.className;
        const auto source = std::make_shared<Source>(name + ".mo", law.text);
        for (Library* library : {&null.variant.task.library, &base_.task.library, &full_.task.library}) {
            Outcome<Library> wider = library->withSource(source);
            if (!wider) return {};
            *library = std::move(*wider);
        }
        laws_[name] = law.text;
    }
    std::vector<Screened> screened(laws.size());
    parallelFor(static_cast<int>(laws.size()), options_.threads, [&](int k) {
        const auto i = static_cast<std::size_t>(k);
        screened[i] = screen(null, laws[i].candidate, search_.fit.simulation, progress_);
    });
    std::vector<const Screened*> chosen;
    for (const Screened& s : screened)
        if (s.failure.empty()) chosen.push_back(&s);
    return tryThese(null, chosen, 2 * trialIterations, startsPerTrial);
}

/// Adds the law that passes the tests of an effect, where one does.
bool Search::addLaw(NullModel& null) {
    const Stay here = stayAt(null, null.sumOfSquares());
    if (std::any_of(lawless_.begin(), lawless_.end(), [&](const Stay& s) { return s.isLike(here); })) return false;
    std::vector<Trial> trials = tryLaws(null);
    rank(null, trials);
    traceTrials("law", null, trials);
    std::map<std::size_t, Acceptance> examined;
    const auto accepted = [&](std::size_t i) {
        if (!trials[i].ok) return false;
        if (!examined.contains(i))
            examined.emplace(i, examine(null, trials[i].fit, trials[i].freed(), 2 * equivalenceMargin));
        return examined.at(i).accepted();
    };
    for (std::size_t best = 0; best < trials.size() && !progress_.stopRequested(); ++best) {
        if (!accepted(best)) continue;
        std::vector<std::size_t> places = equalPlaces(null, trials, best);
        std::erase_if(places, [&](std::size_t i) { return !accepted(i); });
        Trial& trial = trials[places.front()];
        Outcome<NullModel> next = fitNull(trial.variant, null.noise, NoiseLevel::Keep, search_.fit, progress_);
        if (!next) continue;
        Step step;
        step.order = ++choices_;
        step.acceptance = examined.at(places.front());
        step.tried = trials.size();
        for (const std::size_t i : places) {
            const Candidate& other = trials[i].screened.candidate;
            if (other.place.at != trial.screened.candidate.place.at)
                step.alternatives.push_back(
                    {other.effect.kind, other.place.at, trial.evidence - trials[i].evidence, true});
        }
        step.winner = std::move(trial);
        const Candidate& law = step.winner.screened.candidate;
        traceTest("law", keyOf(law.effect, law.place), step.acceptance, "chosen", law.effect.proposal);
        steps_.push_back(std::move(step));
        null = std::move(*next);
        return true;
    }
    traceModel("law", null, "none passes");
    if (!progress_.stopRequested()) lawless_.push_back(here);
    return false;
}

/// Proposals explain while the search goes on and are offered, not added: the model ends without them. What leaves
/// structure is offered only where it is more than a disturbance.
Search::Conclusion Search::takeOutProposals(NullModel& null) {
    Conclusion found;
    if (!hasProposal(null)) return found;
    const bool isDoubtful = !isNoise(null);
    const std::optional<ModelState> with = stateWith(null, search_.fit.simulation, progress_);
    found.with = null;
    found.model = offered(null, with);
    for (std::size_t i = steps_.size(); i-- > 0;) {
        const PlacedEffect& placed = null.variant.effects[i];
        if (placed.effect.proposal.empty()) continue;
        Remainder r;
        r.node = placed.place.at;
        const Acceptance& gain = steps_[i].acceptance;
        r.evidence = std::max({gain.evidence, gain.effective, 0.0});
        r.proposedClass = placed.effect.className;
        if (const auto law = laws_.find(placed.effect.className); law != laws_.end()) r.proposedBlock = law->second;
        tell(r, placed, null, with);
        std::optional<NullModel> rest = without(null, i);
        if (!rest) continue;
        const auto isMore = [&] {
            BesideDisturbance beside[2];
            parallelFor(2, options_.threads, [&](int k) {
                beside[k] = besideDisturbance(k == 0 ? *rest : null, search_.fit.simulation, progress_);
            });
            return isBorneOut(beside[0], beside[1], null.fit.optimum.residuals.size(),
                              static_cast<int>(placed.freed.size()));
        };
        const bool isOffered = !isDoubtful || isMore();
        traceTest("proposal", keyOf(placed.effect, placed.place), gain, isOffered ? "offered" : "taken out",
                  r.proposedEquation);
        if (isOffered) {
            for (const Alternative& a : steps_[i].alternatives)
                if (a.equivalent && a.kind == placed.effect.kind)
                    r.equalNodes.push_back(a.at);
                else if (a.equivalent)
                    found.sameByName.push_back(
                        phrase("{} at {} explains as much with more parameters: {}", a.kind, a.at, r.proposedEquation));
            found.proposed.push_back(std::move(r));
        } else {
            setVerdict(placed, Verdict::NotSignificant, takenOut(noMoreThanDisturbance()));
        }
        null = std::move(*rest);
        steps_.erase(steps_.begin() + static_cast<std::ptrdiff_t>(i));
    }
    std::reverse(found.proposed.begin(), found.proposed.end());
    return found;
}

/// Proposals are told as they are beside the names that are left; `before`: all effects when they were taken out.
void Search::tellBesideNames(const NullModel& null, const std::vector<PlacedEffect>& before,
                             Conclusion& conclusion) const {
    std::vector<PlacedEffect> effects = null.variant.effects, then;
    const std::size_t names = effects.size();
    std::vector<Remainder*> told;
    std::size_t stood = 0;  // of proposals
    for (const PlacedEffect& e : before) {
        if (e.effect.proposal.empty())
            then.push_back(e);
        else
            ++stood;
        for (Remainder& r : conclusion.proposed)
            if (e.effect.className == r.proposedClass && e.place.at == r.node) {
                effects.push_back(e);
                told.push_back(&r);
            }
    }
    const bool isTold = told.size() == stood && keysOf(then) == keysOf(null.variant.effects);
    if (told.empty() || isTold || progress_.stopRequested()) return;
    std::optional<NullModel> with = refittedWith(null, effects);
    if (!with) return;
    const std::optional<ModelState> state = stateWith(*with, search_.fit.simulation, progress_);
    conclusion.model = offered(*with, state);
    for (std::size_t i = 0; i < told.size(); ++i) tell(*told[i], with->variant.effects[names + i], *with, state);
    conclusion.with = std::move(with);
}

/// What was chosen beside a proposal may only mend the proposal: it is taken out, to be looked at again without it.
/// What explains far more than all that is left does not.
void Search::setAsideBehindProposal(NullModel& null) {
    const std::vector<PlacedEffect>& all = null.variant.effects;
    int first = choices_ + 1;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (!all[i].effect.proposal.empty()) first = std::min(first, steps_[i].order);
    std::vector<PlacedEffect> kept;
    std::vector<Step> steps;
    std::vector<Displaced> aside;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const bool isOwn = steps_[i].fall > leastAgainstRest * excess(null);
        if (steps_[i].order <= first || !all[i].effect.proposal.empty() || isOwn) {
            kept.push_back(all[i]);
            steps.push_back(steps_[i]);
        } else {
            aside.push_back({all[i], steps_[i]});
            setVerdict(all[i], Verdict::NotSignificant,
                       phrase("set aside behind an equation without a name that was chosen before it"));
        }
    }
    if (aside.empty()) return;
    std::optional<NullModel> rest = refittedWith(null, kept);
    if (!rest) return;
    null = std::move(*rest);
    steps_ = std::move(steps);
    displaced_.insert(displaced_.end(), std::make_move_iterator(aside.begin()), std::make_move_iterator(aside.end()));
}

/// Without the proposals, the named effects that they had made needless: each is kept if it is missed now. It only
/// imitates the proposals where it explains little against what is left, or leaves far more than they did.
void Search::bringBackDisplaced(NullModel& null, double leftByProposals) {
    for (Displaced& each : displaced_) {
        if (progress_.stopRequested()) return;
        say("reconsider", phrase("{} at {}", each.effect.effect.kind, each.effect.place.at), -1);
        std::vector<PlacedEffect> effects = null.variant.effects;
        effects.push_back(each.effect);
        std::optional<NullModel> with = refittedWith(null, effects);
        if (!with) continue;
        const Acceptance missed = examine(null, with->fit, static_cast<int>(each.effect.freed.size()), 0);
        traceTest("brought back", keyOf(each.effect.effect, each.effect.place), missed, "asked");
        const double fall = null.sumOfSquares() - with->sumOfSquares(), left = excess(*with);
        const auto whyNot = [&]() -> Text {
            if (!isMissed(missed)) return whyRefused(missed, 0);
            if (!isDetermined(*with, effects.size() - 1)) return indistinct();
            if (fightsAnother(null, with->fit)) return fights();
            if (fall < leastAgainstRest * left) return explainsLittle();
            if (leftByProposals < farLess * left) return phrase("leaves far more than an equation without a name");
            return {};
        };
        if (const Text why = whyNot(); !why.empty()) {
            setVerdict(each.effect, Verdict::NotSignificant, takenOut(why));
            continue;
        }
        null = std::move(*with);
        each.step.acceptance = missed;
        setVerdict(each.effect, Verdict::Chosen, {});
        steps_.push_back(std::move(each.step));
    }
    displaced_.clear();
}

/// For effects of which the recordings leave open what they are: what to run next, and how far that would tell.
Text Search::proposeExperiments(const NullModel& null) {
    Text text;
    int count = 0;
    for (std::size_t i = 0; i < steps_.size() && count < mostExperiments && !progress_.stopRequested(); ++i) {
        const PlacedEffect& own = null.variant.effects[i];
        const auto open =
            std::find_if(steps_[i].alternatives.begin(), steps_[i].alternatives.end(), [&](const Alternative& a) {
                return a.equivalent && !stands(null.variant, a.kind, a.at) && !a.kind.starts_with("proposal.");
            });
        if (open == steps_[i].alternatives.end()) continue;
        const Text names = phrase("{} at {} from {} at {}", own.effect.kind, own.place.at, open->kind, open->at);
        say("next experiment", names, -1);
        const std::optional<NullModel> rest = without(null, i);
        if (!rest) continue;
        const auto other = std::find_if(steps_[i].rivals.begin(), steps_[i].rivals.end(), [&](const Candidate& c) {
            return c.effect.kind == open->kind && c.place.at == open->at;
        });
        if (other == steps_[i].rivals.end()) continue;
        const Screened screened = screen(*rest, *other, search_.fit.simulation, progress_);
        const std::vector<Trial> rival = tryThese(*rest, {&screened}, 2 * trialIterations, startsPerTrial);
        if (!rival.front().ok) continue;
        const std::optional<ProposedExperiment> next =
            nextExperiment(null, rival.front(), search_.fit.simulation, progress_);
        if (!next) continue;
        trace("next experiment", keyOf(own.effect, own.place), {{"separation", next->separation}}, "told",
              next->programme);
        ++count;
        if (!text.empty()) text += ". ";
        constexpr double most = 100;
        text +=
            next->separation * next->separation < clearSeparation
                ? phrase(
                      "no programme of the inputs within their range tells {} with these sensors (at most "
                      "{:.1f} standard deviations): another quantity has to be measured",
                      names, next->separation)
            : next->separation > most
                ? phrase("{}, the other inputs at their means, would tell {} by more than {:.0f} standard deviations",
                         next->programme, names, most)
                : phrase("{}, the other inputs at their means, would tell {} by {:.0f} standard deviations",
                         next->programme, names, next->separation);
    }
    return text;
}

/// Values of held parameters that would explain as much as an effect.
Search::HeldValues Search::heldValues(const NullModel& null) {
    HeldValues values;
    for (std::size_t i = 0; i < steps_.size() && !progress_.stopRequested(); ++i) {
        const PlacedEffect& own = null.variant.effects[i];
        say("reconsider", phrase("{} at {}", own.effect.kind, own.place.at), -1);
        if (const std::optional<NullModel> rest = without(null, i)) {
            values[steps_[i].order] = heldInstead(*rest, null, search_.fit, progress_);
            traceHeld(keyOf(own.effect, own.place), values[steps_[i].order], "as good");
        }
    }
    return values;
}

/// Other values of held parameters, the best and what the data do not tell from it, where they explain clearly more
/// than the one effect that was found, which only imitates them and is taken out; or all that is left, where nothing
/// was found.
std::vector<HeldInstead> Search::takeOutForHeld(NullModel& null, const HeldValues& held) {
    if (steps_.size() > 1 || change_ || dependence_ || progress_.stopRequested()) return {};
    if (steps_.empty()) {
        if (isNoise(null)) return {};
        const std::vector<HeldInstead> alone = equalToFirst(heldInstead(null, null, search_.fit, progress_));
        const bool explains = !alone.empty() && alone[0].leavesNoise && alone[0].gain > 3 * equivalenceMargin;
        traceHeld("", alone, explains ? "taken" : "set aside");
        return explains ? alone : std::vector<HeldInstead>();
    }
    const auto known = held.find(steps_[0].order);
    if (known == held.end() || known->second.empty()) return {};
    const HeldInstead& best = known->second.front();
    // what the effect leaves may be correlated just because it is not the cause: noise beside the value speaks for
    // itself
    const double share = best.leavesNoise && !isNoise(null) ? 1 : independentShare(null, null.fit);
    if (!(share * best.gain > 3 * equivalenceMargin) || !takeOut(null, 0, otherValue(best))) return {};
    traceHeld("", equalToFirst(known->second), "taken");
    return equalToFirst(known->second);
}

/// One value that leaves no more than several effects, or one beside inputs that are late or jump between their
/// samples, is the simpler account of it. Such inputs alone are met more often than wrong values: it must leave clearly
/// less.
std::vector<HeldInstead> Search::takeOutAllForHeld(NullModel& null, const NullModel& base) {
    const bool isOneAccount = steps_.size() < 2 && asRecorded_.empty();
    if (isOneAccount || change_ || dependence_ || progress_.stopRequested()) return {};
    Variant given = base.variant;
    if (!asRecorded_.empty()) given.task.recordings = recordingsAsGiven();
    Outcome<NullModel> without = fitNull(given, null.noise, NoiseLevel::Keep, search_.fit, progress_);
    if (!without || progress_.stopRequested()) return {};
    std::vector<HeldInstead> alone = equalToFirst(heldInstead(*without, null, search_.fit, progress_));
    if (alone.empty() || !(alone[0].leavesNoise || !isNoise(null))) return {};
    if (steps_.empty() && !(alone[0].gain > 3 * equivalenceMargin)) return {};
    traceHeld("", alone, "taken");
    takeOutAll(null, *without, otherValue(alone[0]));
    if (!asRecorded_.empty()) takeRecordingsAsGiven();
    return alone;
}

}  // namespace analogon
