/// Effects added one after the other: what is missed stays, what came second is tried again beside the others.
#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

#include "core/base/parallel.hpp"
#include "core/effect/block/twin.hpp"
#include "core/effect/judge/reason.hpp"
#include "core/effect/judge/remainder.hpp"
#include "core/effect/model/model_state.hpp"
#include "core/effect/search/search.hpp"

namespace analogon {
namespace {

constexpr double mostWork = 3e7;  // in steps of the trials, beyond which no other beginning is tried
constexpr std::size_t otherPaths = 2, otherPairs = 2;
constexpr double mostErrorForPairs = 10;    // [%] of the fitted data
constexpr double structuredResidual = 1.1;  // in units of the noise: something is left to find
constexpr double leastGain = 1;             // in evidence, for which an effect is exchanged: exact twins are not
constexpr int mostSharpenings = 2;
constexpr double sameOptimum = 1e-3;   // of the misfit
constexpr double leastSharpening = 8;  // fall in the sum of squares, in units of the noise

/// Whether both are the same fault of a measured or a commanded signal: an offset and an offset, a lag and a lag.
bool isSameFault(const EffectClass& a, const EffectClass& b) {
    return !a.signalSide.empty() && !b.signalSide.empty() && a.proposal.empty() && faultOf(a) == faultOf(b);
}

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

/// The model with these effects instead, on the samples of `on`, beside the same noise.
std::optional<NullModel> refitted(const Variant& on, const NullModel& model, const std::vector<PlacedEffect>& effects,
                                  const FitOptions& options, const Progress& progress) {
    Outcome<Variant> variant = withEffects(on, effects, model.variant.values);
    if (!variant) return std::nullopt;
    variant->plans = model.variant.plans;
    Outcome<NullModel> fitted = fitNull(*variant, model.noise, NoiseLevel::Keep, options, progress);
    if (!fitted) return std::nullopt;
    return std::move(*fitted);
}

}  // namespace

/// Evidence that a model with so many parameters more, which leaves so much, gains over another.
double Search::gainOver(const NullModel& null, double sumOfSquares, int more) {
    const double rows = static_cast<double>(null.fit.optimum.residuals.size());
    const double variance = std::min(sumOfSquares, null.sumOfSquares()) / std::max(1.0, rows - null.parameterCount());
    return (null.sumOfSquares() - sumOfSquares) / variance -
           more * std::log(effectiveCount(null.channels, null.fit.optimum.residuals));
}

/// Walks on a path instead of the present one, or back.
void Search::exchange(Path& path) {
    std::swap(steps_, path.steps);
    std::swap(displaced_, path.displaced);
    std::swap(candidates_, path.candidates);
}

/// Adds one effect a round until nothing passes its tests. The first round is given.
void Search::goOn(Path& path, Round first) {
    exchange(path);
    ++paths_;
    round_ = 0;
    traceModel("path", path.null, "begun");
    for (round_ = 1; round_ <= options_.maxRounds && !progress_.stopRequested(); ++round_) {
        Round round = round_ == 1 ? std::move(first) : tryAll(path.null);
        if (progress_.stopRequested()) break;
        if (round_ > 1) decide(path.null, round);
        beginsAnew_ = round_ > 1 && allowForRecordings(path.null, round);
        if (beginsAnew_) break;
        std::optional<Round> other;
        if (!round.chosen)
            other = chosenTogether(path.null, round);
        else if (isWithinForms(std::max(round.acceptance.evidence, round.acceptance.effective)))
            round.passOver(phrase("explains no more than the forms of the effects that were found may be wrong by"));
        if (progress_.stopRequested()) break;
        noteAll(round);
        if (!round.chosen) break;
        const std::size_t stood = steps_.size();
        steps_.push_back(stepOf(path.null, round));
        if (other) {
            noteAll(*other);
            steps_.push_back(stepOf(path.null, *other));
        }
        for (std::size_t i = stood; i < steps_.size(); ++i) {
            const Candidate& chosen = steps_[i].winner.screened.candidate;
            traceTest("choose", keyOf(chosen.effect, chosen.place), steps_[i].acceptance, "chosen");
        }
        const Variant wider = steps_.back().winner.variant;
        // the noise shows better with every effect that is explained
        Outcome<NullModel> next = fitNull(wider, path.null.noise, NoiseLevel::Estimate, search_.fit, progress_);
        if (!next) next = fitNull(wider, path.null.noise, NoiseLevel::Keep, search_.fit, progress_);
        if (!next) {
            // the model without it stands
            for (; steps_.size() > stood; steps_.pop_back())
                setVerdict(steps_.back().winner.screened.candidate, Verdict::NotSignificant,
                           phrase("could not be fitted: {}", next.diagnostics().front().message));
            break;
        }
        path.null = std::move(*next);
        sharpen(path.null);
        reconsider(path.null);
        crossOver(path.null);
        removeUnneeded(path.null, 1);  // a single one has just passed its tests
        treatAlike(path.null);
        beginsAnew_ = takesEdgesForDelays(path.null);
        if (beginsAnew_) break;
        if (Outcome<ModelState> after = stateOf(path.null.variant, path.null.fit, search_.fit.simulation, progress_);
            after && !progress_.stopRequested()) {
            const double error = errorPercentOf(*after, Role::Fit);
            bestError_ = std::min(bestError_, error);
            if (!hasProposal(path.null) && !(whole_ && errorPercentOf(*whole_->state, Role::Fit) <= error)) {
                whole_ = Path{path.null, steps_, displaced_, candidates_, std::move(*after), {}};
                keepSoFar();
            }
            Stay here = stayAt(path.null, error);
            const auto before =
                std::find_if(visited_.begin(), visited_.end(), [&](const Stay& s) { return s.isLike(here); });
            path.meetsAnother = before != visited_.end() && before->path != paths_;
            if (before != visited_.end()) break;
            visited_.push_back(std::move(here));
        }
        if (!opening_) opening_ = Path{path.null, steps_, displaced_, candidates_, {}};
    }
    traceModel("path", path.null,
               beginsAnew_         ? "begins anew beside the recordings"
               : path.meetsAnother ? "meets another"
                                   : "ended");
    exchange(path);
}

bool Search::Stay::isLike(const Stay& other) const {
    return effects == other.effects && std::abs(misfit - other.misfit) < sameOptimum * misfit;
}

Search::Stay Search::stayAt(const NullModel& null, double misfit) const {
    return {keysOf(null.variant.effects), misfit, paths_};
}

/// Whether so much evidence is no more than the forms of the effects may be wrong by.
bool Search::isWithinForms(double evidence) const {
    double explained = 0;
    for (const Step& each : steps_) explained += each.acceptance.evidence;
    return evidence < errorOfForms(explained);
}

/// The other effects with which the search may begin: they pass the same tests alone.
std::vector<std::size_t> Search::otherBeginnings(const NullModel& null, const Round& round) const {
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < round.trials.size() && others.size() < otherPaths; ++i) {
        const Trial& t = round.trials[i];
        if (!t.ok || isProposal(t) || isAtBound(t) || t.evidence < rivalShare * round.trials[*round.chosen].evidence)
            continue;
        if (i == *round.chosen || std::find(round.members.begin(), round.members.end(), i) != round.members.end())
            continue;
        if (examine(null, t.fit, t.freed(), round.threshold).accepted()) others.push_back(i);
    }
    return others;
}

/// What the best path ends with. A record that was cut out of a longer one begins where the model does not: what is
/// made up for that is held against the same beside states that are fitted there.
Outcome<Search::Path> Search::bestPath(NullModel& base) {
    Outcome<Path> path = bestPathOfDrawn(base);
    if (!path || progress_.stopRequested() || isExplainedBy(*path, 1)) return path;
    const std::optional<Begun> beginning = findBeginning(base, Against::Noise, 0);
    if (!beginning) return path;
    Drawn before{base,   base_.task, full_.task,  freedStarts_,          noisyInputs_, clocks_,
                 edges_, stamped_,   asRecorded_, std::move(otherEnds_), change_,      dependence_};
    freeStarts(beginning->starts);
    base.variant.values = beginning->values;
    std::optional<Path> begun;
    if (beginAnew(base))
        if (Outcome<Path> found = bestPathOfDrawn(base)) begun = std::move(*found);
    const bool isTaken = begun && !progress_.stopRequested() && isSimpler(*begun, *path, 0);
    if (begun) traceModel("beside starts", begun->null, isTaken ? "taken" : "set aside");
    if (isTaken) return std::move(*begun);
    base = before.base;
    exchange(before);
    return path;
}

/// The same of what is made up for the recordings. A clock that is set or a jump that is placed before the effects are
/// known may lead to wrong ones: where such an end is odd, it is held against that of a search with the recordings as
/// they are given.
Outcome<Search::Path> Search::bestPathOfDrawn(NullModel& base) {
    Outcome<Path> path = bestPathBesideRecordings(base);
    if (!path || progress_.stopRequested() || !isOddlyDrawn(*path)) return path;
    Drawn drawn{base, base_.task, full_.task, freedStarts_, noisyInputs_};
    drawn.searched.recordings = recordingsAsGiven();
    if (!edges_.empty() && !noisyInputs_.empty()) quieten(drawn.searched);
    drawn.full.recordings = asRecorded_;
    exchange(drawn);
    takesAsGiven_ = true;
    const Outcome<Done> isBack = beginAnew(base);
    std::optional<Path> plain;
    if (isBack)
        if (Outcome<Path> found = bestPathBesideRecordings(base)) plain = std::move(*found);
    takesAsGiven_ = false;
    const std::size_t jumps = drawn.edges.empty() || !areHeld(drawn.edges) ? drawn.edges.size() : 1;
    const bool isTaken = plain && !progress_.stopRequested() && isSimpler(*plain, *path, drawn.clocks.size() + jumps);
    if (plain) traceModel("recordings as given", plain->null, isTaken ? "taken" : "set aside");
    if (isTaken) return std::move(*plain);
    base = std::move(drawn.base);
    exchange(drawn);
    return path;
}

/// Whether the recordings are drawn otherwise than they are given, beside effects that are much alike or with something
/// left.
bool Search::isOddlyDrawn(const Path& path) const {
    if (clocks_.empty() && edges_.empty()) return false;
    const auto isOfTime = [&](const PlacedEffect& e) {
        const FitEstimate* strength = path.null.fit.find(e.freed.front().name);
        return !e.effect.signalSide.empty() && strength != nullptr && strength->unit == "s";
    };
    const std::vector<PlacedEffect>& effects = path.null.variant.effects;
    return !isNoise(path.null) || std::any_of(effects.begin(), effects.end(), isOfTime);
}

/// Whether an account is better than another that tells so much of the recordings, or as good with less.
bool Search::isSimpler(const Path& plain, const Path& than, std::size_t told) const {
    const double rows = static_cast<double>(plain.null.fit.optimum.residuals.size());
    const double gain =
        sumInUnitsOf(plain.null, than.null) - plain.null.sumOfSquares() +
        (than.null.parameterCount() + static_cast<double>(told) - plain.null.parameterCount()) * std::log(rows);
    const bool isShorter = !hasProposal(plain.null) && termsIn(plain.null) < termsIn(than.null) + told;
    return independentShare(plain.null, plain.null.fit) * gain > (isShorter ? -equivalenceMargin : equivalenceMargin);
}

/// Sets what a search has found of the recordings and beside them against what another has.
void Search::exchange(Drawn& drawn) {
    std::swap(base_.task, drawn.searched);
    std::swap(full_.task, drawn.full);
    std::swap(freedStarts_, drawn.freedStarts);
    std::swap(noisyInputs_, drawn.noisyInputs);
    std::swap(clocks_, drawn.clocks);
    std::swap(edges_, drawn.edges);
    std::swap(stamped_, drawn.stamped);
    std::swap(asRecorded_, drawn.asRecorded);
    std::swap(otherEnds_, drawn.otherEnds);
    std::swap(change_, drawn.change);
    std::swap(dependence_, drawn.dependence);
}

/// The model as given beside the recordings as they are now.
Outcome<Done> Search::beginAnew(NullModel& base) {
    beginsAnew_ = soughtChange_ = false;
    opening_.reset();
    visited_.clear();
    lawless_.clear();
    otherEnds_.clear();
    change_.reset();
    dependence_.reset();
    base.variant.task.recordings = base_.task.recordings;
    Outcome<NullModel> next = fitNull(base.variant, base.noise, NoiseLevel::Estimate, search_.fit, progress_);
    if (!next) return next.diagnostics();
    base = std::move(*next);
    return Done{};
}

/// The same beside what turns out to be wrong with a recording. What was chosen before it did was chosen beside that:
/// the search begins anew then.
Outcome<Search::Path> Search::bestPathBesideRecordings(NullModel& base) {
    for (;;) {
        Outcome<Path> path = bestPathFrom(base);
        if (!path || !beginsAnew_ || progress_.stopRequested()) return path;
        const Outcome<Done> isBack = beginAnew(base);
        if (!isBack) return isBack.diagnostics();
    }
}

/// The path that begins with another of the first trials.
Search::Path Search::pathFrom(const NullModel& base, Round round, std::size_t begin) {
    round.passOver(phrase("the search came to a better end from {}", nameOf(round.candidate(begin))));
    round.chosen = begin;
    round.members = equivalents(base, round.trials, begin);
    round.acceptance = examine(base, round.trials[begin].fit, round.trials[begin].freed(), round.threshold);
    Path path{base, {}, {}, {}, {}};
    goOn(path, std::move(round));
    return path;
}

/// What is tried first of all. Noise with a memory is no missing effect, but a weak one may lie in it.
Search::Round Search::firstRound(NullModel& base) {
    Round first = tryAll(base);
    if (progress_.stopRequested()) return first;
    decide(base, first);
    while (allowForRecordings(base, first)) {
        first = tryAll(base);
        decide(base, first);
    }
    if (first.chosen && !isClearlyMissed(first.acceptance) && isColouredNoise(base))
        first.passOver(phrase("what is left is noise with a memory, and this explains too little of it"));
    return first;
}

/// Whether what is left is noise, of which a part has a memory; where a record is too short to tell, it is not.
bool Search::isColouredNoise(const NullModel& null) const {
    if (isNoise(null)) return false;
    return leftovers(null, search_.fit.simulation).isNoiseAlone();
}

/// Whether nothing is left to find: noise alone behind no more than so many named effects.
bool Search::isExplainedBy(const Path& path, std::size_t most) const {
    return isNoise(path.null) && !hasProposal(path.null) && path.null.variant.effects.size() <= most;
}

/// Whether a path ends better than another: of two accounts that are as good and as simple, the one by names.
bool Search::isBetter(const Path& path, const Path& than) const {
    const auto misfit = [](const Path& p) {
        const double rows = static_cast<double>(p.null.fit.optimum.residuals.size());
        return p.null.sumOfSquares() + p.null.parameterCount() * std::log(rows);
    };
    const double gain = independentShare(path.null, path.null.fit) * (misfit(than) - misfit(path));
    const bool isNamed = hasProposal(than.null) && !hasProposal(path.null) && isNoise(path.null) &&
                         termsIn(path.null) <= termsIn(than.null);
    return gain > (isNamed ? -equivalenceMargin : equivalenceMargin);
}

/// Whether a path with an equation is no simpler than one of names, and explains no more than these forms may be wrong
/// by.
bool Search::isOnlyOfForm(const NullModel& base, const Path& path, const Path& named) const {
    if (!hasProposal(path.null) || hasProposal(named.null) || termsIn(path.null) < termsIn(named.null)) return false;
    const double explained = sumInUnitsOf(named.null, base) - named.null.sumOfSquares();
    const double more = named.null.sumOfSquares() - sumInUnitsOf(named.null, path.null);
    return more < errorOfForms(explained);
}

/// Keeps the better of two paths, and the other among the ends; one that leads where another went adds nothing.
void Search::keepBetter(Path& best, Path path, const NullModel& base) {
    if (path.meetsAnother) return;
    const bool isTaken = isBetter(path, best) && !isOnlyOfForm(base, path, best);
    traceModel("end of path", path.null, isTaken ? "better" : "set aside");
    if (isTaken) std::swap(best, path);
    otherEnds_.push_back(std::move(path));
}

/// Where the first choices leave structure, the search begins again with what came next: two effects that hide each
/// other may not show in the order of their size. Several effects may only imitate what has no name: a short law that
/// leaves next to nothing is the better account.
Outcome<Search::Path> Search::bestPathFrom(NullModel& base) {
    const Round first = firstRound(base);
    Path best{base, {}, {}, {}, {}};
    if (progress_.stopRequested()) return best;
    if (isChangeAlone(base, first))
        return bareOf(base, first, phrase("a parameter that changes is the better account"));
    std::vector<std::size_t> others;
    if (first.chosen) others = otherBeginnings(base, first);
    goOn(best, first);
    if (beginsAnew_ || progress_.stopRequested()) return best;
    const bool hasMore = best.steps.size() > 1 || hasProposal(best.null);
    const std::vector<PlacedEffect>& found = best.null.variant.effects;
    // surroundings as hot as they may be are those of something else
    const bool isAtItsEnd = std::any_of(found.begin(), found.end(),
                                        [&](const PlacedEffect& e) { return hasShapeAtBound(e, best.null.fit); });
    const bool isOdd = isAtItsEnd || std::any_of(found.begin(), found.end(),
                                                 [&](const PlacedEffect& e) { return lacksAPart(e, best.null.fit); });
    if (!hasMore && !isOdd && (isNoise(best.null) || isColouredNoise(best.null))) return best;
    if (!isNoise(best.null) && isChangeAll(base, best.null)) return best;

    addUnprovenPaths(best, base, first);
    if (beginsAnew_) return best;
    const bool isLawful =
        addLawPath(best, base, bareOf(base, first, phrase("an equation without a name explains more in its place")));
    if (beginsAnew_ || (isLawful && termsIn(best.null) < 2)) return best;
    const auto placeOf = [&](std::size_t trial) { return first.trials[trial].screened.candidate.place; };
    for (const std::size_t other : others) {
        const bool isEnough = other != others.front() && work_ > mostWork;
        const bool isDone = !isOdd && levelOf(best.null.fit) < structuredResidual;
        if (progress_.stopRequested() || isDone || isEnough) break;
        // beside an effect that lacks a part and leaves noise it is what goes to the same place that it may stand for
        if (isNoise(best.null) && !isAtItsEnd && !(placeOf(other) == placeOf(*first.chosen))) continue;
        Path path = pathFrom(base, first, other);
        if (beginsAnew_) return best;
        keepBetter(best, std::move(path), base);
    }
    std::vector<Candidate> taken;
    if (first.chosen) taken.push_back(first.trials[*first.chosen].screened.candidate);
    for (const std::size_t other : others) taken.push_back(first.trials[other].screened.candidate);
    addPairPaths(best, base, first, taken);
    if (beginsAnew_ || progress_.stopRequested() || isNoise(best.null) || work_ > mostWork || !opening_) return best;
    addLawPath(best, base, std::move(*opening_));
    return best;
}

/// The path before its first choice, with what was tried.
Search::Path Search::bareOf(const NullModel& base, Round first, const Text& why) {
    first.passOver(why);
    Path bare{base, {}, {}, {}, {}};
    exchange(bare);
    round_ = 1;
    noteAll(first);
    exchange(bare);
    return bare;
}

/// Begins with what explains most of all that is left and fails only on the blocks left out: those are refitted to
/// first order, which far from the optimum tells little. Where such a path leads to noise, what it found is borne out.
void Search::addUnprovenPaths(Path& best, const NullModel& base, const Round& first) {
    std::size_t tried = 0;
    for (const std::size_t begin : first.failsHeldOut) {
        const bool isEnough = tried == otherPaths || (tried > 0 && work_ > mostWork);
        if (progress_.stopRequested() || isNoise(best.null) || isEnough) return;
        const double fall = base.sumOfSquares() - first.trials[begin].sumOfSquares();
        if (!(fall > goodPart * excess(base))) continue;
        ++tried;
        Path path = pathFrom(base, first, begin);
        if (beginsAnew_) return;
        if (isNoise(path.null) && !hasProposal(path.null)) keepBetter(best, std::move(path), base);
    }
}

/// Begins with the halves of pairs, also where one equation took the place of names: it may stand for two that hide
/// each other.
void Search::addPairPaths(Path& best, const NullModel& base, const Round& first, const std::vector<Candidate>& taken) {
    constexpr std::size_t aPair = 2;
    // far from an optimum no slopes tell of two effects
    const bool isNear = levelOf(best.null.fit) < mostForPairs || bestError_ < mostErrorForPairs;
    if (isExplainedBy(best, aPair) || !isNear || progress_.stopRequested()) return;
    const Round wider = work_ > mostWork ? first : withPairMembers(base, first);
    for (const std::size_t begin : pairBeginnings(base, wider, otherPairs, taken)) {
        if (progress_.stopRequested() || isExplainedBy(best, aPair) || work_ > mostWork) return;
        Path path = pathFrom(base, wider, begin);
        if (beginsAnew_) return;
        if (path.steps.size() > 1) keepBetter(best, std::move(path), base);  // else it has passed no test alone
    }
}

/// Goes on from a path with a law; true where that is the better end. As many terms as there are names are no simpler,
/// and were chosen from far more.
bool Search::addLawPath(Path& best, const NullModel& base, Path begin) {
    if (!isNoise(best.null) && levelOf(best.null.fit) < structuredResidual) return false;
    std::optional<Path> path = withLaw(std::move(begin));
    if (beginsAnew_ || !path) return false;
    const bool isTaken = isBetter(*path, best) && !isOnlyOfForm(base, *path, best);
    traceModel("end of path", path->null, isTaken ? "better" : "set aside");
    if (!isTaken) {
        otherEnds_.push_back(std::move(*path));
        return false;
    }
    if (isNoise(best.null) && termsIn(path->null) >= termsIn(best.null)) return false;
    otherEnds_.push_back(std::move(best));
    best = std::move(*path);
    return isNoise(best.null);
}

/// Effects of a model, each term of a law for one.
std::size_t Search::termsIn(const NullModel& null) const {
    std::size_t terms = 0;
    for (const PlacedEffect& e : null.variant.effects) terms += laws_.contains(e.effect.className) ? e.freed.size() : 1;
    return terms;
}

/// The path that goes on from this one with a law that leaves next to nothing; none where no law does.
std::optional<Search::Path> Search::withLaw(Path begin) {
    exchange(begin);
    const bool isExplained = addLaw(begin.null) && levelOf(begin.null.fit) < largeResidual;
    if (isExplained) removeUnneeded(begin.null, 1);
    exchange(begin);
    if (!isExplained) return std::nullopt;
    Round next = tryAll(begin.null);
    decide(begin.null, next);
    goOn(begin, std::move(next));
    return begin;
}

/// The model refitted with one effect taken out. A whole number that another holds may only have been right beside it.
std::optional<NullModel> Search::without(const NullModel& null, std::size_t effect) const {
    const std::vector<PlacedEffect> others = allBut(null.variant.effects, effect);
    std::optional<NullModel> best = refittedWith(null, others);
    for (std::size_t i = 0; i < others.size() && !progress_.stopRequested(); ++i)
        for (const std::string& name : others[i].effect.whole)
            for (const double step : {-1.0, 1.0}) {
                std::vector<PlacedEffect> next = others;
                if (!isHeld(next[i], name)) continue;
                next[i].values[name] += step;
                if (!(next[i].values[name] >= 1)) continue;
                std::optional<NullModel> there = refittedWith(null, next);
                if (there && (!best || there->sumOfSquares() < best->sumOfSquares())) best = std::move(there);
            }
    return best;
}

/// The same on all samples, of a model that was fitted to them; no more exact than the noise asks for.
std::optional<NullModel> Search::withoutOnAll(const NullModel& last, std::size_t effect) {
    return refitted(full_, last, allBut(last.variant.effects, effect), search_.fit, progress_);
}

/// The model with these effects instead, refitted beside the same noise.
std::optional<NullModel> Search::refittedWith(const NullModel& null, const std::vector<PlacedEffect>& effects) const {
    return refitted(base_, null, effects, search_.fit, progress_);
}

/// Takes an effect out of the model of the search; false where the rest cannot be fitted.
bool Search::takeOut(NullModel& null, std::size_t effect, const Text& why) {
    std::optional<NullModel> rest = without(null, effect);
    if (!rest) return false;
    setVerdict(null.variant.effects[effect], Verdict::NotSignificant, takenOut(why));
    null = std::move(*rest);
    steps_.erase(steps_.begin() + static_cast<std::ptrdiff_t>(effect));
    return true;
}

/// Whether a trial explains no less than so much evidence as far as the data tell, a part (`weight`) of whose samples
/// are independent.
bool Search::isLike(const Trial& trial, double evidence, double weight) {
    return trial.evidence > leastLike * evidence && weight * (evidence - trial.evidence) < equivalenceMargin;
}

/// While much is left, what is likelier than an effect and does as well as the best comes first.
void Search::likelierFirst(const NullModel& null, const EffectClass& old, std::vector<Trial>& trials) const {
    const Trial& best = trials.front();
    if (!(levelOf(best.fit) > largeResidual)) return;
    const auto isLikelier = [&](const Trial& t) {
        return t.ok && !isProposal(t) && !isAtBound(t) && t.freed() == best.freed() &&
               plausibility(t.screened.candidate.effect) < plausibility(old) &&
               isLike(t, best.evidence, independentShare(null, best.fit));
    };
    const auto first = std::find_if(trials.begin(), trials.end(), isLikelier);
    if (first != trials.end()) std::rotate(trials.begin(), first, first + 1);
}

/// What explains no less than an effect that stands for so much evidence, as far as the data tell, with fewer
/// parameters comes first, unless something else is clearly better. True: one does.
bool Search::simplerFirst(const NullModel& null, double evidence, int freed, std::vector<Trial>& trials) const {
    const Trial& best = trials.front();
    const double weight = independentShare(null, best.fit);
    if (weight * (best.evidence - evidence) > equivalenceMargin) return false;
    auto simplest = trials.end();
    for (auto t = trials.begin(); t != trials.end(); ++t) {
        if (!t->ok || isProposal(*t) || isAtBound(*t) || fightsAnother(null, t->fit)) continue;
        if (isLike(*t, evidence, weight) && t->freed() < (simplest == trials.end() ? freed : simplest->freed()))
            simplest = t;
    }
    if (simplest == trials.end()) return false;
    std::rotate(trials.begin(), simplest, simplest + 1);
    return true;
}

/// Tries the rivals of one effect again, now that others have joined it: what came second alone may be the better
/// half of a pair. True when one of them took its place (at the end of the list).
bool Search::replace(NullModel& null, std::size_t effect, Rivals wanted, const EffectPlace* elsewhere) {
    const PlacedEffect old = null.variant.effects[effect];
    const int oldFreed = static_cast<int>(old.freed.size());
    std::optional<NullModel> rest = without(null, effect);
    if (!rest) return false;
    Outcome<std::vector<Candidate>> places = candidatesIn(rest->variant);
    if (!places) return false;
    std::vector<Candidate> rivals;
    // of a kind that is known to do worse, another class (surroundings of unknown temperature) may do as well
    const auto isKnown = [&](const Candidate& c) {
        const std::vector<Alternative>& known = steps_[effect].alternatives;
        return std::any_of(known.begin(), known.end(), [&](const Alternative& a) {
            return a.kind == c.effect.kind && a.at == c.place.at && (a.equivalent || !c.effect.signalSide.empty());
        });
    };
    // the same fault of another signal, which may have been far from it as long as what stands beside both was missing
    const auto isAtAnotherSignal = [&](const Candidate& c) {
        const std::vector<Alternative>& known = steps_[effect].alternatives;
        return isSameFault(c.effect, old.effect) && !(c.place == old.place) &&
               std::none_of(known.begin(), known.end(), [&](const Alternative& a) {
                   return a.kind == c.effect.kind && a.at == c.place.at && a.equivalent;
               });
    };
    const auto isRival = [&](const Candidate& c) {
        if (elsewhere != nullptr) return c.effect.className == old.effect.className && c.place == *elsewhere;
        const bool isOther = c.effect.className != old.effect.className && c.effect.proposal.empty();
        if (wanted == Rivals::New)
            return isAtAnotherSignal(c) || (isOther && c.place.connector == old.place.connector && !isKnown(c));
        // at a signal's place, what goes there too is taken for it most easily; no round may have told so
        if (isOther && !old.effect.signalSide.empty() && c.place == old.place) return true;
        return std::any_of(steps_[effect].rivals.begin(), steps_[effect].rivals.end(), [&](const Candidate& rival) {
            return c.effect.className == rival.effect.className && c.place == rival.place;
        });
    };
    std::copy_if(places->begin(), places->end(), std::back_inserter(rivals), isRival);
    std::vector<Screened> screened(rivals.size());
    parallelFor(static_cast<int>(rivals.size()), options_.threads, [&](int i) {
        say("reconsider",
            phrase("{} at {} for {}", rivals[static_cast<std::size_t>(i)].effect.kind,
                   rivals[static_cast<std::size_t>(i)].place.at, old.effect.kind),
            -1);
        screened[static_cast<std::size_t>(i)] =
            screen(*rest, rivals[static_cast<std::size_t>(i)], search_.fit.simulation, progress_);
    });
    // at the end few are left to try: also those whose slope has the wrong sign, beside parameters that took their part
    const auto isWorthATrial = [&](const Screened& s) {
        return s.failure.empty() && (s.score() > 0 || (wanted == Rivals::New && s.isWrongSign()));
    };
    std::vector<const Screened*> chosen;
    for (const Screened& s : screened)
        if (isWorthATrial(s)) chosen.push_back(&s);
    std::vector<Trial> trials = tryThese(*rest, chosen, 2 * trialIterations, startsPerTrial);
    continueBest(*rest, trials);
    rank(*rest, trials);
    retryNear(*rest, null.variant.values, null.sumOfSquares(), trials);
    traceTrials("rival of " + keyOf(old.effect, old.place), *rest, trials);
    if (trials.empty() || !trials.front().ok || progress_.stopRequested()) return false;
    const auto gainOf = [&](const Trial& t) { return gainOver(null, t.sumOfSquares(), t.freed() - oldFreed); };
    const bool isSimplerEqual = simplerFirst(null, trials.front().evidence - gainOf(trials.front()), oldFreed, trials);
    if (!isSimplerEqual) likelierFirst(null, old.effect, trials);
    Trial& best = trials.front();
    const double gain = gainOf(best);
    // alternatives are judged beside the other effects of today
    std::vector<Alternative>& alternatives = steps_[effect].alternatives;
    const double own = best.evidence - gain;
    const double weight = independentShare(null, best.fit);
    const auto beside = [&](const Trial& t, double evidence) {
        const Candidate& c = t.screened.candidate;
        return Alternative{c.effect.kind, c.place.at, evidence - t.evidence, isLike(t, evidence, weight)};
    };
    std::erase_if(alternatives, [&](const Alternative& a) {
        return std::any_of(trials.begin(), trials.end(), [&](const Trial& t) {
            const Candidate& c = t.screened.candidate;
            return a.kind == c.effect.kind && a.at == c.place.at;
        });
    });
    for (const Trial& t : trials)  // best first, as they are told
        if (t.ok && !isProposal(t)) alternatives.push_back(beside(t, own));
    // what the data hardly tell apart is not exchanged for the less likely, nor, at the end, beside much that is left
    const int likelier = plausibility(old.effect) - plausibility(best.screened.candidate.effect);
    const bool leavesMuch = levelOf(best.fit) > largeResidual;
    const bool isLikelierEqual = leavesMuch && likelier > 0 && best.freed() == oldFreed &&
                                 best.evidence > leastLike * own && -weight * gain < equivalenceMargin;
    const bool isHardlyTold = weight * gain < equivalenceMargin || (leavesMuch && wanted == Rivals::New);
    if (!isSimplerEqual && !isLikelierEqual && (!(gain > leastGain) || (likelier < 0 && isHardlyTold))) return false;
    const double fall = rest->sumOfSquares() - null.sumOfSquares(),
                 bestFall = rest->sumOfSquares() - best.sumOfSquares();
    if (leavesMuch && best.freed() > oldFreed && fall > nearlyAsMuch * bestFall) return false;
    Outcome<NullModel> next = fitNull(best.variant, null.noise, NoiseLevel::Keep, search_.fit, progress_);
    if (!next) return false;

    Step step;
    step.order = ++choices_;
    step.acceptance = examine(*rest, best.fit, best.freed(), 0);
    step.tried = screened.size();
    step.alternatives.push_back({old.effect.kind, old.place.at, gain, weight * gain < equivalenceMargin});
    for (std::size_t i = 1; i < trials.size(); ++i)
        if (trials[i].ok && !isProposal(trials[i])) step.alternatives.push_back(beside(trials[i], best.evidence));
    for (const Candidate& c : steps_[effect].rivals)
        if (c.effect.className != best.screened.candidate.effect.className ||
            c.place.at != best.screened.candidate.place.at)
            step.rivals.push_back(c);
    step.rivals.push_back({old.effect, old.place});
    step.winner = std::move(best);
    const Candidate& winner = step.winner.screened.candidate;
    setVerdict(old, Verdict::Weaker,
               isSimplerEqual ? phrase("{} explains nearly as much with fewer parameters", nameOf(winner))
                              : phrase("beside the other effects {} explains more in its place", nameOf(winner)));
    setVerdict(winner, Verdict::Chosen, {});
    if (hasProposal(*next) && old.effect.proposal.empty()) displaced_.push_back({old, steps_[effect]});
    null = std::move(*next);
    steps_.erase(steps_.begin() + static_cast<std::ptrdiff_t>(effect));
    steps_.push_back(std::move(step));
    return true;
}

/// Gives the rivals of every effect but the newest another chance. Bounded: each change lowers the misfit.
bool Search::reconsider(NullModel& null) {
    const auto hasRivals = [&](std::size_t i) {
        return !steps_[i].rivals.empty() || !null.variant.effects[i].effect.signalSide.empty();
    };
    bool changed = false;
    for (int pass = 0; pass < 2; ++pass) {
        bool changedNow = false;
        for (std::size_t i = 0; i + 1 < steps_.size() && !progress_.stopRequested();)
            if (hasRivals(i) && replace(null, i))
                changedNow = true;
            else
                ++i;
        changed = changed || changedNow;
        if (!changedNow) break;
    }
    return changed;
}

/// Where a part of an effect is next to nothing, another effect may stand for that part at a place of its own: where
/// one at that place does for both, it takes their place. True: it did.
bool Search::doesForBoth(NullModel& null, std::size_t effect, std::size_t part) {
    const PlacedEffect &odd = null.variant.effects[effect], lesser = null.variant.effects[part];
    const bool mayGoThere = odd.effect.ports.size() == lesser.effect.ports.size() && odd.effect.signalSide.empty() &&
                            lesser.effect.signalSide.empty();
    if (!mayGoThere || odd.place == lesser.place || !lacksAPart(odd, null.fit)) return false;
    std::optional<NullModel> one = without(null, part);
    if (!one) return false;
    Path before{null, steps_, displaced_, candidates_, {}};
    steps_.erase(steps_.begin() + static_cast<std::ptrdiff_t>(part));
    const std::size_t left = effect > part ? effect - 1 : effect;
    const bool isMoved = replace(*one, left, Rivals::New, &lesser.place);
    const bool isBetter =
        isMoved && gainOver(null, one->sumOfSquares(), one->parameterCount() - null.parameterCount()) > 0;
    if (isMoved) traceModel("unite", *one, isBetter ? "taken" : "set aside");
    if (!isBetter) {
        exchange(before);
        return false;
    }
    const Candidate& both = steps_.back().winner.screened.candidate;
    setVerdict(lesser, Verdict::Weaker, phrase("beside the other effects {} explains more in its place", nameOf(both)));
    null = std::move(*one);
    return true;
}

/// Puts together what the search has taken apart.
void Search::unite(NullModel& null) {
    for (std::size_t i = 0; i < steps_.size(); ++i)
        for (std::size_t part = 0; part < steps_.size() && !progress_.stopRequested(); ++part)
            if (part != i && doesForBoth(null, i, part)) return unite(null);
}

/// What goes to the place of an effect may do as well beside the others, though no round has tried it, and so may the
/// same fault of another signal: at the end each is held against what is new of that.
void Search::completeClasses(NullModel& null) {
    std::size_t i = 0;
    for (std::size_t k = steps_.size(); k-- > 0 && !progress_.stopRequested() && work_ <= mostWork;)
        if (!replace(null, i, Rivals::New)) ++i;  // what takes a place stands at the end
}

/// Of the last line of the table that is of this candidate; what is taken out was chosen there.
void Search::setVerdict(const Candidate& candidate, Verdict verdict, const Text& why) {
    trace("revise", keyOf(candidate.effect, candidate.place), {}, name(verdict), why);
    const auto isIt = [&](const CandidateResult& c) {
        return c.className == candidate.effect.className && c.at == candidate.place.at;
    };
    auto line = candidates_.rend();
    if (verdict != Verdict::Chosen)
        line = std::find_if(candidates_.rbegin(), candidates_.rend(),
                            [&](const CandidateResult& c) { return isIt(c) && c.verdict == Verdict::Chosen; });
    if (line == candidates_.rend()) line = std::find_if(candidates_.rbegin(), candidates_.rend(), isIt);
    if (line == candidates_.rend()) return;
    line->verdict = verdict;
    line->reason = why;
}

void Search::setVerdict(const PlacedEffect& placed, Verdict verdict, const Text& why) {
    setVerdict(Candidate{placed.effect, placed.place}, verdict, why);
}

/// The error that is left without the effect of a step, by the model refitted without it.
void Search::tellErrorWithout(Step& step, const NullModel& without) const {
    if (Outcome<ModelState> state =
            stateOf(without.variant, without.fit, search_.fit.simulation, progress_, Detail::Errors))
        step.errorWithout = errorPercentOf(*state, Role::Fit);
}

/// Whether an effect, missed by so much, has to stay. `beside`: of the model as it stands, once it is
/// asked for. At the last, where something is left that nothing explains, the effect must be more than what a
/// disturbance takes over; where noise is left, a weak one must be likelier.
Search::Need Search::needOf(const NullModel& null, std::size_t effect, const NullModel& without,
                            const Acceptance& missed, bool isLast,
                            const std::function<BesideDisturbance(std::size_t most)>& beside) const {
    const PlacedEffect& placed = null.variant.effects[effect];
    const bool leavesNoise = isNoise(null);
    if (!isMissed(missed)) return {whyRefused(missed, 0)};
    if (!isTold(placed, null.fit.estimates, missed, leavesNoise)) return {indistinct()};
    if (isAtBound(placed, null.fit)) return {atBound()};
    if (!isLast) return {};
    if (!leavesNoise && drivesToBound(without.fit, null.fit))
        return {
            phrase("with it a parameter of the model rests at a bound: it does the work of what is known to be there")};
    if (!(missed.heldOut > leastHeldOut)) return {whyRefused(missed, leastHeldOut)};
    if (leavesNoise && !(missed.evidence < beyondDoubt)) return {};
    // what is constant hardly differs from a flow that varies slowly, and noise with a memory is noise as well
    const bool isNoiseLeft = leavesNoise || isColouredNoise(null);
    const std::size_t most = isNoiseLeft ? 1 : mostDisturbances;
    const BesideDisturbance disturbed = besideDisturbance(without, search_.fit.simulation, progress_, most);
    const BesideDisturbance with = beside(most);
    const Eigen::Index rows = null.fit.optimum.residuals.size();
    const int freed = static_cast<int>(placed.freed.size());
    const bool isMore =
        isNoiseLeft ? isLikelier(disturbed, with, rows, freed) : isBorneOut(disturbed, with, rows, freed);
    return {isMore ? Text() : noMoreThanDisturbance(), evidenceBeside(disturbed, with, rows, freed)};
}

/// Takes each effect out again and keeps only those that are missed. As many as there are threads are judged at once;
/// what was judged beside one that is taken out is judged anew.
void Search::removeUnneeded(NullModel& null, std::size_t least, bool isLast) {
    struct Judged {
        std::optional<NullModel> without;
        Acceptance missed;
        Need need;
    };
    std::optional<BesideDisturbance> known;  // of the model as it stands
    std::mutex guard;
    const auto beside = [&](std::size_t most) {
        const std::lock_guard lock(guard);
        if (!known) known = besideDisturbance(null, search_.fit.simulation, progress_, most);
        return *known;
    };
    const auto judge = [&](std::size_t i) {
        const PlacedEffect& placed = null.variant.effects[i];
        say("remove", phrase("{} at {}", placed.effect.kind, placed.place.at), -1);
        Judged judged{without(null, i), {}, {}};
        if (!judged.without) return judged;
        judged.missed = examine(*judged.without, null.fit, static_cast<int>(placed.freed.size()), 0);
        judged.need = needOf(null, i, *judged.without, judged.missed, isLast, beside);
        return judged;
    };
    std::vector<Judged> judged;
    std::size_t first = 0;  // of these
    for (std::size_t i = 0; i < steps_.size() && steps_.size() > least && !progress_.stopRequested();) {
        if (i >= first + judged.size()) {
            first = i;
            judged.assign(std::min(steps_.size() - i, static_cast<std::size_t>(threadCount(options_.threads))), {});
            parallelFor(static_cast<int>(judged.size()), options_.threads, [&](int k) {
                judged[static_cast<std::size_t>(k)] = judge(first + static_cast<std::size_t>(k));
            });
        }
        Judged& own = judged[i - first];
        if (!own.without) {
            ++i;
            continue;
        }
        const PlacedEffect& placed = null.variant.effects[i];
        const Text why = own.need.whyNot;
        traceTest("missed", keyOf(placed.effect, placed.place), own.missed, why.empty() ? "kept" : "taken out", why);
        if (own.need.besideDisturbance)
            trace("beside disturbance", keyOf(placed.effect, placed.place),
                  {{"delta_bic", -*own.need.besideDisturbance}}, why.empty() ? "kept" : "taken out");
        if (why.empty()) {
            steps_[i].acceptance = own.missed;
            steps_[i].fall = own.without->sumOfSquares() - null.sumOfSquares();
            tellErrorWithout(steps_[i], *own.without);
            ++i;
            continue;
        }
        setVerdict(placed, Verdict::NotSignificant, takenOut(why));
        if (hasProposal(null) && placed.effect.proposal.empty()) displaced_.push_back({placed, steps_[i]});
        null = std::move(*own.without);
        known.reset();
        steps_.erase(steps_.begin() + static_cast<std::ptrdiff_t>(i));
        judged.clear();
        first = i = 0;
    }
}

/// Takes out the names that explain little against what is left beside them, least first: the others are judged without
/// it.
void Search::removeOutweighed(NullModel& null, double share) {
    while (!progress_.stopRequested()) {
        std::optional<std::size_t> least;
        for (std::size_t i = 0; i < steps_.size(); ++i)
            if (null.variant.effects[i].effect.proposal.empty() && (!least || steps_[i].fall < steps_[*least].fall))
                least = i;
        const Text why = explainsLittle();
        if (!least || outweighsRest(steps_[*least].fall, null, share) || !takeOut(null, *least, why)) return;
        removeUnneeded(null, 0, true);
    }
}

/// Of the last refit, an effect whose strength as it would be reported is not distinguishable from 0 is taken out of
/// the model of the search; false: there is none.
bool Search::dropIndistinct(const NullModel& last, const ModelState& state, NullModel& null) {
    // where the fit found no errors at all they tell nothing of an effect
    if (std::none_of(state.parameters.begin(), state.parameters.end(),
                     [](const FitEstimate& e) { return std::isfinite(e.standardError); }))
        return false;
    const std::vector<PlacedEffect>& effects = last.variant.effects;
    for (std::size_t i = 0; i < effects.size(); ++i) {
        if (!isTold(effects[i], state.parameters, steps_[i].acceptance, isNoise(last)) &&
            takeOut(null, i, indistinct()))
            return true;
    }
    return false;
}

/// Means of neighbouring samples blur what is faster than they are, and an effect can mend just that. On all samples
/// each must be missed as well; true: one was not, and is taken out of the model of the search.
bool Search::dropUnmissed(const NullModel& last, NullModel& null) {
    std::optional<std::size_t> least;
    Text why;
    double leastEvidence = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < steps_.size() && !progress_.stopRequested(); ++i) {
        say("remove", phrase("{} at {}", last.variant.effects[i].effect.kind, last.variant.effects[i].place.at), -1);
        const std::optional<NullModel> rest = withoutOnAll(last, i);
        if (!rest) continue;
        const Acceptance missed = examine(*rest, last.fit, static_cast<int>(last.variant.effects[i].freed.size()), 0);
        if (isMissed(missed)) {
            steps_[i].acceptance = missed;
            tellErrorWithout(steps_[i], *rest);
        } else if (missed.evidence < leastEvidence) {
            least = i;
            why = phrase("on all samples instead of means of them: {}", whyRefused(missed, 0));
            leastEvidence = missed.evidence;
        }
    }
    return least && !progress_.stopRequested() && takeOut(null, *least, why);
}

/// What the newest effect rounds off for the sake of the integration (the change of sign of a friction, the corner of a
/// limit) is drawn sharper as long as the data ask for it: the rest would pass for an effect of its own.
void Search::sharpen(NullModel& null) {
    for (int pass = 0; pass < mostSharpenings && !progress_.stopRequested(); ++pass) {
        std::vector<PlacedEffect> effects = null.variant.effects;
        if (!drawSharper(effects.back())) return;
        std::optional<NullModel> sharper = refittedWith(null, effects);
        if (!sharper || !(null.sumOfSquares() - sharper->sumOfSquares() > leastSharpening)) return;
        if (sharper->fit.takesDifferences) return;  // too sharp for the steps: nothing could be screened beside it
        traceModel("sharpen", *sharper, "drawn sharper");
        null = std::move(*sharper);
    }
}

/// Where much is left that nothing explains, a channel that shows an effect of its sensor clearly and one of the same
/// kind that does not are more likely two equal sensors than two different ones: the effect is put in front of both,
/// with the same parameters, unless the data speak against it. So are two inputs that feed the same kind of block.
void Search::treatAlike(NullModel& null) {
    for (std::size_t i = 0; i < null.variant.effects.size() && !progress_.stopRequested(); ++i) {
        if (!(levelOf(null.fit) > largeResidual)) return;
        const PlacedEffect& placed = null.variant.effects[i];
        if (placed.effect.signalSide.empty() || !placed.effect.proposal.empty() || !placed.twins.empty()) continue;
        const std::vector<EffectPlace> like = likePlaces(null.variant, placed, catalogue_);
        if (like.empty()) continue;
        say("reconsider", phrase("{} at every channel like {}", placed.effect.kind, placed.place.at), -1);
        std::vector<PlacedEffect> effects = null.variant.effects;
        effects[i].twins = like;
        std::optional<NullModel> tied = refittedWith(null, effects);
        if (!tied) continue;
        const double rows = static_cast<double>(null.fit.optimum.residuals.size());
        const double least = std::min(null.sumOfSquares(), tied->sumOfSquares());
        const double worse = (tied->sumOfSquares() - null.sumOfSquares()) / least * (rows - null.parameterCount()) *
                             independentShare(null, null.fit);
        const bool isTaken = worse < equivalenceMargin;
        traceModel("alike", *tied, isTaken ? "taken" : "set aside");
        if (isTaken) null = std::move(*tied);
    }
}

}  // namespace analogon
