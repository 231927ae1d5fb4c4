#pragma once

#include <optional>
#include <utility>

#include "core/effect/block/trial.hpp"
#include "core/effect/judge/disturbance.hpp"
#include "core/effect/thresholds.hpp"

/// By what trials are held against each other and kept or refused, once they are fitted.
namespace analogon {

using threshold::judgement::beyondDoubt;
using threshold::judgement::goodPart;
using threshold::judgement::leastBesideOffered;
using threshold::judgement::leastOfRest;
using threshold::judgement::nearlyAsMuch;

/// Probability of so much in noise, with as many candidates tried (Sidak 1967).
double pValue(double explained, int dof, std::size_t tried);

/// Whether what was tried is an equation without a name.
bool isProposal(const Trial& trial);

/// Such an equation; a channel in it by its name.
std::string equationOf(const PlacedEffect& placed);

/// What a fit has found for the parameters of an effect, by their names in it.
std::vector<EffectValue> estimatesOf(const PlacedEffect& placed, const FitResult& fit);

/// Between kinds that the data cannot tell apart while much is left: a command is followed at once more often than a
/// sensor is fast, heat is passed on at once by what gives it, and neighbours exchange heat more often than they share
/// a contact to their surroundings.
int plausibility(const EffectClass& effect);

/// Of trials that explain or predict as much, the one that goes first: with the fewest parameters, and met most often.
std::pair<int, int> simplicity(const Trial& trial);

/// Whether an effect of a flexible form leaves structure: there it may stand in for other effects.
bool mayFollowOthers(const NullModel& null, const Trial& trial);

/// Whether an effect, by what the model loses without it, has to stay.
bool isMissed(const Acceptance& a);

/// Whether the model is so much worse without an effect that its standard error need not bear it out: where the model's
/// own parameters are known but for a common factor, it tells nothing.
bool isClearlyMissed(const Acceptance& a);

/// Whether the strength of an effect is told by the data: by its standard error, or, where the scale of the model is
/// open, by what the model loses without it. `leavesNoise`: the model explains all but noise.
bool isTold(const PlacedEffect& placed, const std::vector<FitEstimate>& estimates, const Acceptance& missed,
            bool leavesNoise);

/// Whether an effect is more than what a flow that nobody measured takes over, one that varies slowly at some node: a
/// second mass or a small exponent imitates it well from one short block to the next.
bool isBorneOut(const BesideDisturbance& without, const BesideDisturbance& with, Eigen::Index rows, int freed);

/// The same of an effect that leaves noise: it need only be the likelier account (what is constant hardly differs from
/// a flow that varies slowly).
bool isLikelier(const BesideDisturbance& without, const BesideDisturbance& with, Eigen::Index rows, int freed);

/// Whether a decrease of chi-square is a good part of what a model leaves above the noise: enough for a path of the
/// search to begin with it unproved.
bool isGoodPart(double chi2Decrease, const NullModel& null);

/// Whether nothing that leaves noise with so much evidence [BIC] looks like the truth by chance.
bool isBeyondDoubt(double evidence);

/// Whether what the model loses without an effect (a decrease of chi-square) outweighs this share of what the model
/// leaves above the noise: in the shadow of something large that has no name, many an effect passes for a part of it.
bool outweighsRest(double chi2Decrease, const NullModel& null, double share);

/// Whether an effect is a dead time of more than a few samples (`interval` [s] apart). Heat and flows come late by
/// storage as a rule, and what is stored smooths them, too.
bool isLongDeadTime(const PlacedEffect& placed, const FitResult& fit, double interval);

/// Whether the strength rests at a bound, or a shape at the low end of its reach: the effect then stands for something
/// else.
bool isAtBound(const PlacedEffect& placed, const FitResult& fit);
bool isAtBound(const Trial& trial);

/// Whether a further parameter of the effect rests at a bound of its own: as far as the effect goes, it is not enough
/// (surroundings as hot as they may be), and may stand for something else.
bool hasShapeAtBound(const PlacedEffect& placed, const FitResult& fit);

/// Whether a part that the effect has as a rule is next to nothing (a breakaway without friction at speed): it may
/// stand for two others.
bool lacksAPart(const PlacedEffect& placed, const FitResult& fit);

/// Whether a parameter of the model that has a value of its own without an effect rests at a bound with it: the effect
/// does the work of what is known to be there.
bool drivesToBound(const FitResult& without, const FitResult& with);

/// Whether a new effect and an old one grow against each other: two that cancel explain what neither does.
bool fightsAnother(const NullModel& null, const FitResult& with);

/// What the forms of effects that explain so much may be wrong by, both in evidence: a change of sign is rounded off,
/// and no drag is exactly quadratic.
double errorOfForms(double explained);

/// Whether a proposed equation explains more than every named effect: clearly, beyond what their forms may be wrong by,
/// and not just as one flexible form more while much is left anyway.
bool beatsNames(const NullModel& null, const std::vector<Trial>& trials, std::size_t proposal,
                std::optional<std::size_t> chosen);

}  // namespace analogon
