#include "core/effect/discover.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <chrono>
#include <cmath>
#include <set>

#include "core/base/parallel.hpp"
#include "core/effect/caution.hpp"
#include "core/effect/change.hpp"
#include "core/effect/model_state.hpp"
#include "core/effect/next_experiment.hpp"
#include "core/effect/remainder.hpp"
#include "core/effect/thin.hpp"
#include "core/effect/trial.hpp"
#include "core/effect/twin.hpp"
#include "core/residual/quantisation.hpp"

namespace analogon {
namespace {

constexpr double equivalenceMargin = 10;   // evidence within which two candidates cannot be told apart
constexpr double twinCorrelation = 0.999;  // projected traces more alike than this are twins
constexpr double largeResidual = 1.2;      // in units of the noise: above it, first-order scores may mislead
constexpr double indistinctShare = 0.03;   // of a large residual
constexpr double nearlyAsMuch = 0.6;       // of the fall in the sum of squares
constexpr double falseAlarmQuantile = 0.99;
constexpr double rivalShare = 0.3;  // of the winner's evidence, from which on a weaker candidate is looked at again
constexpr double mostWork = 3e7;    // in steps of the trials, beyond which no other beginning is tried
constexpr std::size_t mostRivals = 5, mostAlternatives = 6, otherPaths = 2;
constexpr double integrationShare = 2e-3, coarsestTolerance = 3e-5;  // of the noise, and of a channel's range at most
constexpr double structuredResidual = 1.1;                           // in units of the noise: something is left to find
constexpr double leastGain = 1;   // in evidence, for which an effect is exchanged: exact twins are not
constexpr double mostGrowth = 5;  // of an effect's strength when another joins it
constexpr double changeShare = 0.5, leastChange = 100;
constexpr long mostSearchedSamples = 6000;
constexpr int mostSharpenings = 2;
constexpr double leastSharpening = 8;      // fall in the sum of squares, in units of the noise
constexpr int mostExperiments = 2;         // proposed to tell effects apart
constexpr double clearSeparation = 4.472;  // standard deviations: a squared distance of 20
constexpr int startsPerTrial = 2;
constexpr int trialIterations = 12;  // a trial must show what it is worth; the winner is refitted to convergence
constexpr int glanceIterations = 5;  // of the whole catalogue, to see who deserves a trial
constexpr double trialTolerance = 1e-6;

/// Noise of every output from what the model leaves, in the units of the output.
std::vector<Eigen::VectorXd> noiseOf(const EstimationTask& task, const PreparedTask& prepared, const FitResult& fit) {
    std::vector<Eigen::VectorXd> noise(task.recordings.size());
    for (std::size_t e = 0; e < prepared.problem.experiments.size(); ++e) {
        const FitExperiment& experiment = prepared.problem.experiments[e];
        Eigen::VectorXd& n = noise[static_cast<std::size_t>(prepared.fitRecordings[e])];
        n = Eigen::VectorXd::Zero(experiment.measured.rows());
        for (Eigen::Index o = 0; o < n.size(); ++o) {
            if (experiment.weights[o] <= 0) continue;
            const Eigen::VectorXd r =
                (fit.optimum.trajectories[e].outputs.row(o) - experiment.measured.row(o)).transpose();
            const Eigen::VectorXd m = experiment.measured.row(o).transpose();
            n[o] = std::max(noiseFromDifferences(r), quantisationNoise(m));
            // a perfect recording (made by simulation) has no noise to speak of: weigh it by its range
            double low = 1e300, high = -1e300;
            for (const double x : m)
                if (!std::isnan(x)) {
                    low = std::min(low, x);
                    high = std::max(high, x);
                }
            n[o] = std::max({n[o], 1e-6 * (high - low), 1e-300});
        }
    }
    return noise;
}

/// Whether a fit keeps the noise level it is given, or finds it anew from what it leaves.
enum class NoiseLevel { Keep, Estimate };

Outcome<NullModel> fitNull(const Variant& start, const std::vector<Eigen::VectorXd>& noise, NoiseLevel level,
                           const FitOptions& options, const Progress& progress) {
    NullModel null;
    null.variant = start;
    null.noise = noise;
    // without any noise level the first fit weighs by range, and its residual is that of a poorer optimum
    const int passes = level == NoiseLevel::Keep ? 1 : noise.empty() ? 3 : 2;
    for (int pass = 0; pass < passes; ++pass) {
        Outcome<PreparedTask> prepared = prepareAt(null.variant, null.noise);
        if (!prepared) return prepared.diagnostics();
        if (prepared->problem.experiments.empty())
            return error("the study has no experiment with the role \"fit\"", {},
                         "give at least one experiment that role");
        null.fit = fit(prepared->problem, options, progress);
        if (!null.fit.optimum.ok)
            return numericalError(null.fit.message, "give other start values, or narrower bounds");
        null.variant.values = valuesOf(null.fit);
        null.channels = residualChannels(prepared->problem);
        if (pass + 1 < passes) null.noise = noiseOf(null.variant.task, *prepared, null.fit);
    }
    null.whitener = Whitener(null.channels, null.fit.optimum.residuals);
    null.period = dominantPeriod(null);
    return null;
}

double pValue(double explained, int dof, std::size_t tried) {
    if (!(explained > 0) || dof < 1) return 1;
    const double p = boost::math::cdf(boost::math::complement(boost::math::chi_squared(dof), explained));
    return -std::expm1(static_cast<double>(tried) * std::log1p(-p));
}

bool isProposal(const Trial& trial) { return !trial.screened.candidate.effect.proposal.empty(); }

bool hasRole(const ModelState& state, Role role) {
    return std::any_of(state.experiments.begin(), state.experiments.end(),
                       [&](const ExperimentState& e) { return e.role == role; });
}

bool hasProposal(const NullModel& null) {
    return std::any_of(null.variant.effects.begin(), null.variant.effects.end(),
                       [](const PlacedEffect& e) { return !e.effect.proposal.empty(); });
}

/// What a fit leaves, in units of the noise.
double levelOf(const FitResult& fit) {
    return std::sqrt(fit.optimum.residuals.squaredNorm() / static_cast<double>(fit.optimum.residuals.size()));
}

/// Of the samples, those that speak for themselves: neighbours in a slow residual say the same, and beside much that
/// nothing explains a small part of it tells nothing apart (it is the model that is wrong there, not the noise).
double independentShare(const NullModel& null, const FitResult& fit) {
    const Eigen::VectorXd& r = fit.optimum.residuals;
    const double rows = static_cast<double>(r.size());
    const double share = effectiveCount(null.channels, r) / rows;
    return levelOf(fit) > largeResidual ? std::min(share, equivalenceMargin / (indistinctShare * rows)) : share;
}

/// Between kinds that the data cannot tell apart while much is left: a command is followed at once more often than a
/// sensor is fast.
int plausibility(const EffectClass& effect) { return effect.signalSide == "input" ? 1 : 0; }

/// Whether the data fix the strength of an effect: a standard error, and one smaller than the value.
bool isDetermined(const NullModel& null, std::size_t effect) {
    const std::string& strength = null.variant.effects[effect].freed.front().name;
    return std::any_of(null.fit.estimates.begin(), null.fit.estimates.end(), [&](const FitEstimate& e) {
        return e.name == strength && std::isfinite(e.standardError) && e.standardError < std::abs(e.value);
    });
}

/// Whether every channel of the residual passes for white.
bool isNoise(const NullModel& null) {
    return std::all_of(null.channels.begin(), null.channels.end(), [&](const ResidualChannel& c) {
        return summarise(null.fit.optimum.residuals.segment(c.begin, c.end - c.begin)).whiteProbability > 1e-4;
    });
}

/// Whether the strength rests at a bound: the effect then stands for something else.
bool isAtBound(const Trial& trial) {
    const std::string& strength = trial.variant.effects.back().freed.front().name;
    return std::any_of(trial.fit.estimates.begin(), trial.fit.estimates.end(),
                       [&](const FitEstimate& e) { return e.name == strength && e.atBound; });
}

/// Whether a new effect and an old one grow against each other: two that cancel explain what neither does.
bool fightsAnother(const NullModel& null, const FitResult& with) {
    const auto valueOf = [](const FitResult& fit, const std::string& name) {
        for (const FitEstimate& e : fit.estimates)
            if (e.name == name) return std::abs(e.value);
        return 0.0;
    };
    return std::any_of(null.variant.effects.begin(), null.variant.effects.end(), [&](const PlacedEffect& e) {
        const std::string& strength = e.freed.front().name;
        return valueOf(with, strength) > mostGrowth * valueOf(null.fit, strength);
    });
}

/// Whether a proposed equation explains more than every named effect: clearly, and not just as one flexible form more
/// while much is left anyway.
bool beatsNames(const NullModel& null, const std::vector<Trial>& trials, std::size_t proposal,
                std::optional<std::size_t> chosen) {
    if (!chosen) return trials[proposal].evidence > 2 * equivalenceMargin;
    const double weight = independentShare(null, trials[proposal].fit);
    double best = -1e300, leastLeft = 1e300;
    for (const Trial& t : trials) {
        if (!t.ok || isProposal(t)) continue;
        best = std::max(best, t.evidence);
        leastLeft = std::min(leastLeft, t.sumOfSquares());
    }
    if (!(weight * (trials[proposal].evidence - best) > equivalenceMargin)) return false;
    const double named = null.sumOfSquares() - leastLeft,
                 proposed = null.sumOfSquares() - trials[proposal].sumOfSquares();
    return levelOf(trials[proposal].fit) <= largeResidual || named < nearlyAsMuch * proposed;
}

/// What a fit took, in steps of the explicit method.
double workOf(const FitResult& fit) {
    double steps = 0;
    for (const Trajectory& t : fit.optimum.trajectories) steps += t.plan.work() * static_cast<double>(t.outputs.cols());
    return steps * fit.simulations;
}

double excess(const NullModel& null) {
    return null.sumOfSquares() - static_cast<double>(null.fit.optimum.residuals.size());
}

/// Sum of squares that a model leaves, in units of the noise that another one stands beside.
double sumInUnitsOf(const NullModel& units, const NullModel& model) {
    const std::vector<int> recordings = recordingsOf(model.variant.task, Role::Fit);
    double sum = 0;
    for (const ResidualChannel& c : model.channels) {
        const auto r = static_cast<std::size_t>(recordings[static_cast<std::size_t>(c.experiment)]);
        const double ratio = model.noise[r][c.output] / units.noise[r][c.output];
        sum += ratio * ratio * model.fit.optimum.residuals.segment(c.begin, c.end - c.begin).squaredNorm();
    }
    return sum;
}

/// Whether a change in mid run accounts for most of what is above the noise, by a wide margin over chance, and is a
/// better account of it than the effects that were found: another structure, or all of them only to imitate it.
bool isBetterThan(const NullModel& base, const NullModel& with, const Change& change) {
    if (!(change.explained > changeShare * excess(base)) || !(change.explained > leastChange)) return false;
    const double left = sumInUnitsOf(base, with), leftByChange = change.fit.optimum.residuals.squaredNorm();
    const FitResult& nearer = left < leftByChange ? with.fit : change.fit;  // to the truth, as far as we know
    const double count = effectiveCount(base.channels, nearer.optimum.residuals);
    const double rows = static_cast<double>(nearer.optimum.residuals.size());
    const double variance =
        std::min(left, leftByChange) / std::max(1.0, rows - static_cast<double>(nearer.estimates.size()));
    const double gain = (left - leftByChange) / variance * count / rows;
    // the parameter that changes was chosen, too
    const double more = static_cast<double>(change.fit.estimates.size()) - with.parameterCount() + 1;
    return gain - more * std::log(count) > equivalenceMargin;
}

/// Puts proposals first among what is left; the strongest channel tells when it shows and what it moves with.
void offer(std::vector<Remainder> proposed, std::vector<Remainder>& left) {
    for (Remainder& r : proposed)
        if (!left.empty()) {
            const auto strongest =
                std::max_element(left.begin(), left.end(),
                                 [](const Remainder& a, const Remainder& b) { return a.evidence < b.evidence; });
            r.output = strongest->output;
            r.experiment = strongest->experiment;
            if (r.to <= r.from) {
                r.from = strongest->from;
                r.to = strongest->to;
            }
            r.movesWith = strongest->movesWith;
        }
    left.insert(left.begin(), std::make_move_iterator(proposed.begin()), std::make_move_iterator(proposed.end()));
}

/// The equations of a model with its values written in.
Outcome<FlatModel> flattened(const EstimationTask& task, const std::string& textWithValues) {
    Outcome<Library> library = task.library.withSource(std::make_shared<Source>(task.model->name(), textWithValues));
    if (!library) return library.diagnostics();
    return flatten(*library, task.className);
}

/// Adds what an effect computes from its fitted parameters for people to read (the limit behind its reciprocal): its
/// final parameters.
void appendDerived(const FlatModel& model, AddedEffect& effect) {
    const std::string prefix = effect.instance + ".";
    for (std::size_t v = 0; v < model.variables.size(); ++v) {
        const FlatVariable& variable = model.variables[v];
        if (!variable.isFinal || variable.isProtected || variable.variability != FlatVariability::Parameter ||
            variable.type != FlatType::Real || variable.name.rfind(prefix, 0) != 0)
            continue;
        if (const std::optional<double> value = model.parameterValue({static_cast<std::uint32_t>(v)}))
            effect.parameters.push_back({variable.name.substr(prefix.size()), *value, 0, variable.unit});
    }
}

/// Smallest noise of a fitted channel over the range of its measurement.
double quietest(const NullModel& null) {
    double least = 1;
    std::size_t e = 0;
    for (const Recording& r : null.variant.task.recordings) {
        const std::size_t index = e++;
        if (r.role != Role::Fit || index >= null.noise.size()) continue;
        for (Eigen::Index o = 0; o < std::min(r.outputs.rows(), null.noise[index].size()); ++o) {
            double low = std::numeric_limits<double>::infinity(), high = -low;
            for (const double y : r.outputs.row(o))
                if (!std::isnan(y)) {
                    low = std::min(low, y);
                    high = std::max(high, y);
                }
            if (high > low) least = std::min(least, null.noise[index][o] / (high - low));
        }
    }
    return least;
}

/// One search, from the model as given to the model that leaves noise.
class Search {
public:
    Search(const EstimationTask& task, const DiscoverOptions& options, const Progress& progress)
        : full_{task, {}, {}},
          thinning_(thinningFor(task, mostSearchedSamples)),
          base_{thinned(task, thinning_), {}, {}},
          options_(options),
          search_(options),
          progress_(progress) {}

    Outcome<Finding> run();

private:
    struct Step {
        Trial winner;
        Acceptance acceptance;
        double pValue{};
        std::vector<Alternative> alternatives;
        std::vector<Candidate> rivals;  // what else explained a good part of the same
        int order{};                    // of all choices
        double errorWithout{-1};        // [%] of the fitted data when this effect alone is left out; -1: not known
    };

    std::vector<Screened> screenAll(const NullModel& null);
    std::vector<Trial> tryBest(const NullModel& null, std::vector<Screened>& screened);
    std::vector<Trial> tryThese(const NullModel& null, const std::vector<const Screened*>& chosen, int iterations,
                                int starts);
    void continueBest(const NullModel& null, std::vector<Trial>& trials);
    /// What was tried beside one model, and what was decided.
    struct Round {
        std::vector<Screened> screened;
        std::vector<Trial> trials;  // best first
        double threshold{};
        std::optional<std::size_t> chosen;  // of the trials
        std::vector<std::size_t> members;   // of its class
        std::set<std::size_t> failsHeldOut;
        Acceptance acceptance;
    };
    /// A named effect that was not needed any more beside a proposed equation.
    struct Displaced {
        PlacedEffect effect;
        Step step;
    };
    /// Effects added one after the other, and the model they lead to.
    struct Path {
        NullModel null;
        std::vector<Step> steps;
        std::vector<Displaced> displaced;
        std::vector<CandidateResult> candidates;
        std::optional<ModelState> state;  // after the last effect: at hand when the search is interrupted
    };

    Round tryAll(const NullModel& null);
    void decide(const NullModel& null, Round& round) const;
    void preferSimple(const NullModel& null, Round& round) const;
    Step stepOf(const Round& round);
    void noteAll(const Round& round);
    Outcome<Done> goOn(Path& path, Round first);
    std::vector<std::size_t> otherBeginnings(const NullModel& null, const Round& round) const;
    Outcome<Path> bestPath(const NullModel& base);
    std::vector<std::size_t> equivalents(const NullModel& null, const std::vector<Trial>& trials,
                                         std::size_t best) const;
    std::optional<NullModel> without(const NullModel& null, std::size_t effect);
    std::optional<NullModel> refittedWith(const NullModel& null, const std::vector<PlacedEffect>& effects);
    bool reconsider(NullModel& null);
    std::vector<Remainder> takeOutProposals(NullModel& null);
    void setAsideBehindProposal(NullModel& null);
    void bringBackDisplaced(NullModel& null);
    bool replace(NullModel& null, std::size_t effect);
    void removeUnneeded(NullModel& null, std::size_t least);
    void treatAlike(NullModel& null);
    void sharpen(NullModel& null);
    std::string proposeExperiments(const NullModel& null);
    void setVerdict(const std::string& kind, const std::string& at, Verdict verdict);
    void note(const Screened& s, Verdict verdict, std::optional<double> deltaBic);
    AddedEffect describe(const NullModel& last, const PlacedEffect& placed, const Step& step) const;
    void say(std::string stage, std::string detail, double fraction) const {
        progress_.report({std::move(stage), std::move(detail), fraction, bestError_});
    }

    Variant full_;  // on every sample
    int thinning_;
    Variant base_;  // on what the search works with
    const DiscoverOptions& options_;
    DiscoverOptions search_;  // integration as exact as the noise asks for
    const Progress& progress_;
    std::vector<EffectClass> catalogue_;
    std::vector<CandidateResult> candidates_;
    std::vector<Step> steps_;
    std::vector<Displaced> displaced_;
    std::optional<Change> change_;  // in mid run, that explains better than any effect
    int round_{}, choices_{};
    double work_{};  // of the trials so far
    double bestError_{-1};
};

std::vector<Screened> Search::screenAll(const NullModel& null) {
    Outcome<std::vector<Candidate>> candidates = candidatesFor(null.variant, catalogue_);
    if (!candidates) return {};
    std::vector<Screened> screened(candidates->size());
    parallelFor(static_cast<int>(screened.size()), options_.threads, [&](int i) {
        const Candidate& c = (*candidates)[static_cast<std::size_t>(i)];
        say("screen", c.effect.kind + " at " + c.place.at,
            static_cast<double>(i) / static_cast<double>(screened.size()));
        screened[static_cast<std::size_t>(i)] = screen(null, c, search_.fit.simulation, progress_);
    });
    return screened;
}

std::vector<Trial> Search::tryThese(const NullModel& null, const std::vector<const Screened*>& chosen, int iterations,
                                    int starts) {
    FitOptions quick = search_.fit;
    quick.maxIterations = iterations;
    quick.costTolerance = trialTolerance;
    quick.simulation = limited(null, quick.simulation);
    std::vector<Trial> trials(chosen.size());
    parallelFor(static_cast<int>(chosen.size()), options_.threads, [&](int i) {
        const Screened& s = *chosen[static_cast<std::size_t>(i)];
        say("trial", s.candidate.effect.kind + " at " + s.candidate.place.at,
            static_cast<double>(i) / static_cast<double>(chosen.size()));
        trials[static_cast<std::size_t>(i)] = refit(null, s, quick, starts, progress_);
    });
    for (const Trial& t : trials) work_ += workOf(t.fit);
    return trials;
}

/// Refits the candidates that promise most by either score; where the residual is large against the noise, all.
std::vector<Trial> Search::tryBest(const NullModel& null, std::vector<Screened>& screened) {
    std::vector<const Screened*> order;
    for (const Screened& s : screened)
        if (s.failure.empty() && s.score() > 0) order.push_back(&s);
    std::stable_sort(order.begin(), order.end(),
                     [](const Screened* a, const Screened* b) { return a->score() > b->score(); });
    std::vector<const Screened*> byWhitened = order;
    std::stable_sort(byWhitened.begin(), byWhitened.end(),
                     [](const Screened* a, const Screened* b) { return a->whitenedScore() > b->whitenedScore(); });
    std::vector<const Screened*> chosen;
    const auto choose = [&](const std::vector<const Screened*>& from, int count) {
        for (const Screened* s : from) {
            if (count == 0) break;
            if (std::find(chosen.begin(), chosen.end(), s) != chosen.end()) continue;
            chosen.push_back(s);
            --count;
        }
    };
    // proposals compete, but do not take the place of a named effect
    const auto isProposal = [](const Screened* s) { return !s->candidate.effect.proposal.empty(); };
    std::vector<const Screened*> proposals;
    std::copy_if(order.begin(), order.end(), std::back_inserter(proposals), isProposal);
    std::erase_if(order, isProposal);
    std::erase_if(byWhitened, isProposal);
    choose(order, options_.refitted);
    choose(byWhitened, options_.refitted / 2);
    choose(proposals, options_.refitted / 3);
    std::vector<Trial> trials = tryThese(null, chosen, trialIterations, startsPerTrial);

    double least = null.sumOfSquares();
    for (const Trial& t : trials)
        if (t.ok) least = std::min(least, t.sumOfSquares());
    const double level = std::sqrt(least / static_cast<double>(null.fit.optimum.residuals.size()));
    if (level > largeResidual && !progress_.stopRequested()) {
        const std::size_t before = chosen.size();
        choose(order, static_cast<int>(order.size()));
        std::vector<Trial> others =
            tryThese(null, {chosen.begin() + static_cast<std::ptrdiff_t>(before), chosen.end()}, glanceIterations, 1);
        trials.insert(trials.end(), std::make_move_iterator(others.begin()), std::make_move_iterator(others.end()));
        continueBest(null, trials);
    }
    return trials;
}

/// Takes the trials that a short fit brought to the front further.
void Search::continueBest(const NullModel& null, std::vector<Trial>& trials) {
    rank(null, trials);
    FitOptions options = search_.fit;
    options.maxIterations = 2 * trialIterations;
    options.costTolerance = trialTolerance;
    options.simulation = limited(null, options.simulation);
    const int count = std::min<int>(options_.refitted, static_cast<int>(trials.size()));
    parallelFor(count, options_.threads, [&](int i) {
        Trial& t = trials[static_cast<std::size_t>(i)];
        if (t.ok && t.fit.status == FitStatus::IterationLimit) proceed(null, t, options, progress_);
    });
}

std::vector<std::size_t> Search::equivalents(const NullModel& null, const std::vector<Trial>& trials,
                                             std::size_t best) const {
    std::vector<std::size_t> members{best};
    const Complement complement(null.fit.optimum.jacobian);
    const auto direction = [&](const Trial& t) {
        const Eigen::MatrixXd rest = complement(Eigen::MatrixXd(t.screened.probes.front().column));
        return Eigen::VectorXd(rest.col(0).normalized());
    };
    const Eigen::VectorXd own = direction(trials[best]);
    const double weight = independentShare(null, trials[best].fit);
    for (std::size_t i = 0; i < trials.size(); ++i) {
        if (i == best || !trials[i].ok || isProposal(trials[i])) continue;
        const double gap = weight * std::abs(trials[best].evidence - trials[i].evidence);
        if (gap < equivalenceMargin ||
            (gap < 3 * equivalenceMargin && std::abs(own.dot(direction(trials[i]))) > twinCorrelation))
            members.push_back(i);
    }
    return members;
}

void Search::note(const Screened& s, Verdict verdict, std::optional<double> deltaBic) {
    CandidateResult c;
    c.kind = s.candidate.effect.kind;
    c.at = s.candidate.place.at;
    c.className = s.candidate.effect.className;
    c.score = s.score();
    c.strength = s.probes.empty() ? 0 : s.probes.front().strength();
    c.deltaBic = deltaBic;
    c.verdict = verdict;
    c.absorbedBy = s.absorbedBy;
    c.round = round_;
    candidates_.push_back(std::move(c));
}

/// Screens every candidate and refits those that promise most.
Search::Round Search::tryAll(const NullModel& null) {
    Round round;
    round.screened = screenAll(null);
    if (progress_.stopRequested()) return round;
    std::vector<Eigen::MatrixXd> directions;
    for (const Screened& s : round.screened)
        if (!s.probes.empty() && !s.isAbsorbed()) directions.push_back(s.probes.front().plain.directions);
    const double logRows = std::log(static_cast<double>(null.fit.optimum.residuals.size()));
    round.threshold = noiseThreshold(directions, logRows, falseAlarmQuantile, 1);
    round.trials = tryBest(null, round.screened);
    rank(null, round.trials);
    return round;
}

/// The best that passes its tests; what lies close to it is its class, of which the simplest is taken.
void Search::decide(const NullModel& null, Round& round) const {
    const std::vector<Trial>& trials = round.trials;
    std::optional<std::size_t> proposal;
    Acceptance ofProposal;
    for (std::size_t i = 0; i < trials.size() && !round.chosen; ++i) {
        if (!trials[i].ok || trials[i].evidence < equivalenceMargin) break;
        if (isProposal(trials[i])) {
            if (proposal || isAtBound(trials[i])) continue;
            ofProposal = examine(null, trials[i].fit, trials[i].freed(), round.threshold);
            if (ofProposal.accepted()) proposal = i;
            continue;
        }
        if (isAtBound(trials[i]) || fightsAnother(null, trials[i].fit)) continue;
        round.acceptance = examine(null, trials[i].fit, trials[i].freed(), round.threshold);
        if (round.acceptance.accepted())
            round.chosen = i;
        else if (round.acceptance.isSignificant)
            round.failsHeldOut.insert(i);
    }
    if (round.chosen) preferSimple(null, round);
    // Where an equation without a name explains clearly more than any name, none of the names fits.
    if (proposal && beatsNames(null, trials, *proposal, round.chosen)) {
        round.chosen = proposal;
        round.acceptance = ofProposal;
        round.members = {*proposal};
    }
}

/// While much is left whatever is taken, one step explains with its flexible parameters what belongs to others: the
/// simplest that explains nearly as much goes first.
void Search::preferSimple(const NullModel& null, Round& round) const {
    const std::vector<Trial>& trials = round.trials;
    const Trial& best = trials[*round.chosen];
    const double fall = null.sumOfSquares() - best.sumOfSquares();
    const bool leavesMuch = levelOf(best.fit) > largeResidual;
    round.members = equivalents(null, trials, *round.chosen);
    std::vector<std::size_t> simpler;
    for (std::size_t i = 0; i < trials.size(); ++i) {
        if (!trials[i].ok || isProposal(trials[i]) || isAtBound(trials[i]) || fightsAnother(null, trials[i].fit))
            continue;
        const bool isSimpler = trials[i].freed() < best.freed();
        const bool isLikelier =
            leavesMuch && trials[i].freed() == best.freed() &&
            plausibility(trials[i].screened.candidate.effect) < plausibility(best.screened.candidate.effect);
        const bool isMember = std::find(round.members.begin(), round.members.end(), i) != round.members.end();
        const bool isNearly = leavesMuch && null.sumOfSquares() - trials[i].sumOfSquares() > nearlyAsMuch * fall;
        if ((isMember && (isSimpler || isLikelier)) || (isNearly && isSimpler)) simpler.push_back(i);
    }
    std::stable_sort(simpler.begin(), simpler.end(),
                     [&](std::size_t a, std::size_t b) { return trials[a].freed() < trials[b].freed(); });
    for (const std::size_t i : simpler) {
        const Acceptance a = examine(null, trials[i].fit, trials[i].freed(), round.threshold);
        if (!a.accepted()) continue;
        round.chosen = i;
        round.acceptance = a;
        round.members = equivalents(null, trials, i);
        break;
    }
}

/// The step that the round has decided on, with what came near it.
Search::Step Search::stepOf(const Round& round) {
    const std::vector<Trial>& trials = round.trials;
    const std::size_t chosen = *round.chosen;
    const auto isMember = [&](std::size_t i) {
        return std::find(round.members.begin(), round.members.end(), i) != round.members.end();
    };
    const auto alternative = [&](std::size_t i, bool isEquivalent) {
        const Candidate& c = trials[i].screened.candidate;
        return Alternative{c.effect.kind, c.place.at, -trials[i].evidence, isEquivalent};
    };
    Step s;
    s.order = ++choices_;
    s.winner = trials[chosen];
    s.acceptance = round.acceptance;
    s.pValue = pValue(round.acceptance.explained, trials[chosen].freed(), round.screened.size());
    for (const std::size_t m : round.members) {
        if (m == chosen) continue;
        s.alternatives.push_back(alternative(m, true));
        s.rivals.push_back(trials[m].screened.candidate);
    }
    for (std::size_t i = 0; i < trials.size(); ++i) {
        if (!trials[i].ok || isMember(i) || i == chosen) continue;
        if (s.rivals.size() < mostRivals && trials[i].evidence > rivalShare * trials[chosen].evidence)
            s.rivals.push_back(trials[i].screened.candidate);
        if (s.alternatives.size() < mostAlternatives) s.alternatives.push_back(alternative(i, false));
    }
    return s;
}

/// The round's line for every candidate of the table.
void Search::noteAll(const Round& round) {
    const auto key = [](const Candidate& c) {
        return c.effect.className + "@" + c.place.at + "@" + c.place.spare + "@" + c.place.node;
    };
    std::set<std::string> refitted;
    for (std::size_t i = 0; i < round.trials.size(); ++i) {
        const Trial& t = round.trials[i];
        refitted.insert(key(t.screened.candidate));
        Verdict verdict = Verdict::NotSignificant;
        if (!t.ok)
            verdict = Verdict::Failed;
        else if (round.chosen && i == *round.chosen)
            verdict = Verdict::Chosen;
        else if (std::find(round.members.begin(), round.members.end(), i) != round.members.end())
            verdict = Verdict::Equivalent;
        else if (round.failsHeldOut.contains(i))
            verdict = Verdict::FailsHeldOut;
        else if (round.chosen && t.evidence > equivalenceMargin)
            verdict = Verdict::Weaker;
        note(t.screened, verdict, t.ok ? std::optional<double>(-t.evidence) : std::nullopt);
    }
    for (const Screened& s : round.screened) {
        if (refitted.contains(key(s.candidate))) continue;
        const Verdict verdict = !s.failure.empty()                                  ? Verdict::Failed
                                : s.isAbsorbed()                                    ? Verdict::Absorbed
                                : s.isWrongSign()                                   ? Verdict::WrongSign
                                : round.chosen && s.score() > 2 * equivalenceMargin ? Verdict::Weaker
                                                                                    : Verdict::NotSignificant;
        note(s, verdict, std::nullopt);
    }
}

/// Adds one effect a round until nothing passes its tests. The first round is given.
Outcome<Done> Search::goOn(Path& path, Round first) {
    std::swap(steps_, path.steps);
    std::swap(displaced_, path.displaced);
    std::swap(candidates_, path.candidates);
    Outcome<Done> done = Done{};
    for (round_ = 1; round_ <= options_.maxRounds && !progress_.stopRequested(); ++round_) {
        Round round = round_ == 1 ? std::move(first) : tryAll(path.null);
        if (progress_.stopRequested()) break;
        if (round_ > 1) decide(path.null, round);
        noteAll(round);
        if (!round.chosen) break;
        Step step = stepOf(round);
        Variant wider = step.winner.variant;
        steps_.push_back(std::move(step));
        // the noise shows better with every effect that is explained
        Outcome<NullModel> next = fitNull(wider, path.null.noise, NoiseLevel::Estimate, search_.fit, progress_);
        if (!next) {
            done = next.diagnostics();
            break;
        }
        path.null = std::move(*next);
        sharpen(path.null);
        reconsider(path.null);
        removeUnneeded(path.null, 1);  // a single one has just passed its tests
        treatAlike(path.null);
        if (Outcome<ModelState> after = stateOf(path.null.variant, path.null.fit, search_.fit.simulation, progress_);
            after && !progress_.stopRequested()) {
            bestError_ = std::min(bestError_, errorPercentOf(*after, Role::Fit));
            path.state = std::move(*after);
        }
    }
    std::swap(steps_, path.steps);
    std::swap(displaced_, path.displaced);
    std::swap(candidates_, path.candidates);
    return done;
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

/// What the best path ends with. Where the first choices leave structure, the search begins again with what came
/// next: two effects that hide each other may not show in the order of their size.
Outcome<Search::Path> Search::bestPath(const NullModel& base) {
    Round first = tryAll(base);
    Path best{base, {}, {}, {}, {}};
    if (progress_.stopRequested()) return best;
    decide(base, first);
    std::vector<std::size_t> others;
    if (first.chosen) others = otherBeginnings(base, first);
    if (Outcome<Done> done = goOn(best, first); !done) return done.diagnostics();
    const auto misfit = [&](const Path& p) {
        const double rows = static_cast<double>(p.null.fit.optimum.residuals.size());
        return p.null.sumOfSquares() + p.null.parameterCount() * std::log(rows);
    };
    for (const std::size_t other : others) {
        if (progress_.stopRequested() || levelOf(best.null.fit) < structuredResidual) break;
        if (work_ > mostWork) break;
        Round round = first;
        round.chosen = other;
        round.members = equivalents(base, round.trials, other);
        round.acceptance = examine(base, round.trials[other].fit, round.trials[other].freed(), round.threshold);
        Path path{base, {}, {}, {}, {}};
        if (Outcome<Done> done = goOn(path, std::move(round)); !done) continue;
        const double weight = independentShare(path.null, path.null.fit);
        if (weight * (misfit(best) - misfit(path)) > equivalenceMargin) best = std::move(path);
    }
    return best;
}

/// The model refitted with one effect taken out.
std::optional<NullModel> Search::without(const NullModel& null, std::size_t effect) {
    std::vector<PlacedEffect> others;
    for (std::size_t k = 0; k < null.variant.effects.size(); ++k)
        if (k != effect) others.push_back(null.variant.effects[k]);
    return refittedWith(null, others);
}

/// The model with these effects instead, refitted beside the same noise.
std::optional<NullModel> Search::refittedWith(const NullModel& null, const std::vector<PlacedEffect>& effects) {
    Outcome<Variant> variant = withEffects(base_, effects, null.variant.values);
    if (!variant) return std::nullopt;
    Outcome<NullModel> refitted = fitNull(*variant, null.noise, NoiseLevel::Keep, search_.fit, progress_);
    if (!refitted) return std::nullopt;
    return std::move(*refitted);
}

/// Tries the rivals of one effect again, now that others have joined it: what came second alone may be the better
/// half of a pair. True when one of them took its place (at the end of the list).
bool Search::replace(NullModel& null, std::size_t effect) {
    const PlacedEffect old = null.variant.effects[effect];
    std::optional<NullModel> rest = without(null, effect);
    if (!rest) return false;
    Outcome<std::vector<Candidate>> places = candidatesFor(rest->variant, catalogue_);
    if (!places) return false;
    std::vector<Candidate> rivals;
    for (const Candidate& rival : steps_[effect].rivals)
        for (const Candidate& place : *places)
            if (place.effect.className == rival.effect.className && place.place == rival.place) rivals.push_back(place);
    std::vector<Screened> screened(rivals.size());
    parallelFor(static_cast<int>(rivals.size()), options_.threads, [&](int i) {
        say("reconsider",
            rivals[static_cast<std::size_t>(i)].effect.kind + " at " + rivals[static_cast<std::size_t>(i)].place.at +
                " for " + old.effect.kind,
            -1);
        screened[static_cast<std::size_t>(i)] =
            screen(*rest, rivals[static_cast<std::size_t>(i)], search_.fit.simulation, progress_);
    });
    std::vector<const Screened*> chosen;
    for (const Screened& s : screened)
        if (s.failure.empty() && s.score() > 0) chosen.push_back(&s);
    std::vector<Trial> trials = tryThese(*rest, chosen, 2 * trialIterations, startsPerTrial);
    rank(*rest, trials);
    if (trials.empty() || !trials.front().ok || progress_.stopRequested()) return false;
    Trial& best = trials.front();
    const double rows = static_cast<double>(null.fit.optimum.residuals.size());
    const double least = std::min(best.sumOfSquares(), null.sumOfSquares());
    const double variance = least / std::max(1.0, rows - null.parameterCount());
    const double gain = (null.sumOfSquares() - best.sumOfSquares()) / variance -
                        (best.freed() - static_cast<int>(old.freed.size())) *
                            std::log(effectiveCount(null.channels, null.fit.optimum.residuals));
    // alternatives are judged beside the other effects of today
    std::vector<Alternative>& alternatives = steps_[effect].alternatives;
    const double own = best.evidence - gain;
    const double weight = independentShare(null, best.fit);
    for (const Trial& t : trials) {
        const EffectPlace& place = t.screened.candidate.place;
        const std::string& kind = t.screened.candidate.effect.kind;
        std::erase_if(alternatives, [&](const Alternative& a) { return a.kind == kind && a.at == place.at; });
        if (t.ok)
            alternatives.push_back({kind, place.at, -t.evidence, weight * (own - t.evidence) < equivalenceMargin});
    }
    // what the data hardly tell apart is not exchanged for the less likely
    const bool isLessLikely = plausibility(best.screened.candidate.effect) > plausibility(old.effect);
    if (!(gain > leastGain) || (isLessLikely && weight * gain < equivalenceMargin)) return false;
    const double fall = rest->sumOfSquares() - null.sumOfSquares(),
                 bestFall = rest->sumOfSquares() - best.sumOfSquares();
    if (levelOf(best.fit) > largeResidual && best.freed() > static_cast<int>(old.freed.size()) &&
        fall > nearlyAsMuch * bestFall)
        return false;
    Outcome<NullModel> next = fitNull(best.variant, null.noise, NoiseLevel::Keep, search_.fit, progress_);
    if (!next) return false;

    Step step;
    step.order = ++choices_;
    step.acceptance = examine(*rest, best.fit, best.freed(), 0);
    step.pValue = pValue(step.acceptance.explained, best.freed(), screened.size());
    step.alternatives.push_back(
        {old.effect.kind, old.place.at, -(best.evidence - gain), weight * gain < equivalenceMargin});
    for (std::size_t i = 1; i < trials.size(); ++i)
        if (trials[i].ok)
            step.alternatives.push_back({trials[i].screened.candidate.effect.kind,
                                         trials[i].screened.candidate.place.at, -trials[i].evidence,
                                         weight * (best.evidence - trials[i].evidence) < equivalenceMargin});
    for (const Candidate& c : steps_[effect].rivals)
        if (c.effect.className != best.screened.candidate.effect.className ||
            c.place.at != best.screened.candidate.place.at)
            step.rivals.push_back(c);
    step.rivals.push_back({old.effect, old.place});
    step.winner = std::move(best);
    setVerdict(old.effect.kind, old.place.at, Verdict::Weaker);
    setVerdict(step.winner.screened.candidate.effect.kind, step.winner.screened.candidate.place.at, Verdict::Chosen);
    if (hasProposal(*next) && old.effect.proposal.empty()) displaced_.push_back({old, steps_[effect]});
    null = std::move(*next);
    steps_.erase(steps_.begin() + static_cast<std::ptrdiff_t>(effect));
    steps_.push_back(std::move(step));
    return true;
}

/// Gives the rivals of every effect but the newest another chance. Bounded: each change lowers the misfit.
bool Search::reconsider(NullModel& null) {
    bool changed = false;
    for (int pass = 0; pass < 2; ++pass) {
        bool changedNow = false;
        for (std::size_t i = 0; i + 1 < steps_.size() && !progress_.stopRequested();)
            if (!steps_[i].rivals.empty() && replace(null, i))
                changedNow = true;
            else
                ++i;
        changed = changed || changedNow;
        if (!changedNow) break;
    }
    return changed;
}

void Search::setVerdict(const std::string& kind, const std::string& at, Verdict verdict) {
    for (auto c = candidates_.rbegin(); c != candidates_.rend(); ++c)
        if (c->kind == kind && c->at == at) {
            c->verdict = verdict;
            return;
        }
}

/// Takes each effect out again and keeps only those that are missed.
void Search::removeUnneeded(NullModel& null, std::size_t least) {
    for (std::size_t i = 0; i < steps_.size() && steps_.size() > least && !progress_.stopRequested();) {
        say("remove", null.variant.effects[i].effect.kind + " at " + null.variant.effects[i].place.at, -1);
        std::optional<NullModel> refitted = without(null, i);
        if (!refitted) {
            ++i;
            continue;
        }
        const int freed = static_cast<int>(null.variant.effects[i].freed.size());
        const Acceptance missed = examine(*refitted, null.fit, freed, 0);
        if (missed.isSignificant && missed.isWorthwhile && missed.heldOut > 0 && isDetermined(null, i)) {
            steps_[i].acceptance = missed;
            if (Outcome<ModelState> state =
                    stateOf(refitted->variant, refitted->fit, search_.fit.simulation, progress_))
                steps_[i].errorWithout = errorPercentOf(*state, Role::Fit);
            ++i;
            continue;
        }
        const PlacedEffect& unneeded = null.variant.effects[i];
        setVerdict(unneeded.effect.kind, unneeded.place.at, Verdict::NotSignificant);
        if (hasProposal(null) && unneeded.effect.proposal.empty()) displaced_.push_back({unneeded, steps_[i]});
        null = std::move(*refitted);
        steps_.erase(steps_.begin() + static_cast<std::ptrdiff_t>(i));
        i = 0;
    }
}

/// What the newest effect rounds off for the sake of the integration (the change of sign of a friction, the corner of a
/// limit) is drawn sharper as long as the data ask for it: the rest would pass for an effect of its own.
void Search::sharpen(NullModel& null) {
    for (int pass = 0; pass < mostSharpenings && !progress_.stopRequested(); ++pass) {
        std::vector<PlacedEffect> effects = null.variant.effects;
        PlacedEffect& newest = effects.back();
        bool changes = false;
        for (const auto& [name, factor] : newest.effect.sharper)
            if (const auto value = newest.values.find(name); value != newest.values.end()) {
                value->second *= factor;
                changes = true;
            }
        if (!changes) return;
        std::optional<NullModel> sharper = refittedWith(null, effects);
        if (!sharper || !(null.sumOfSquares() - sharper->sumOfSquares() > leastSharpening)) return;
        null = std::move(*sharper);
    }
}

/// Where much is left that nothing explains, a channel that shows an effect of its sensor clearly and one of the same
/// kind that does not are more likely two equal sensors than two different ones: the effect is put in front of both,
/// with the same parameters, unless the data speak against it.
void Search::treatAlike(NullModel& null) {
    for (std::size_t i = 0; i < null.variant.effects.size() && !progress_.stopRequested(); ++i) {
        if (!(levelOf(null.fit) > largeResidual)) return;
        const PlacedEffect& placed = null.variant.effects[i];
        if (placed.effect.signalSide != "output" || !placed.effect.proposal.empty() || !placed.twins.empty()) continue;
        const std::vector<EffectPlace> like = likePlaces(null.variant, placed, catalogue_);
        if (like.empty()) continue;
        say("reconsider", fmt::format("{} at every sensor like {}", placed.effect.kind, placed.place.at), -1);
        std::vector<PlacedEffect> effects = null.variant.effects;
        effects[i].twins = like;
        std::optional<NullModel> tied = refittedWith(null, effects);
        if (!tied) continue;
        const double rows = static_cast<double>(null.fit.optimum.residuals.size());
        const double least = std::min(null.sumOfSquares(), tied->sumOfSquares());
        const double worse = (tied->sumOfSquares() - null.sumOfSquares()) / least * (rows - null.parameterCount()) *
                             independentShare(null, null.fit);
        if (worse < equivalenceMargin) null = std::move(*tied);
    }
}

/// Proposals explain while the search goes on and are offered, not added: the model ends without them.
std::vector<Remainder> Search::takeOutProposals(NullModel& null) {
    std::vector<Remainder> found;
    std::optional<ModelState> with;
    if (hasProposal(null))
        if (Outcome<ModelState> state = stateOf(null.variant, null.fit, search_.fit.simulation, progress_))
            with = std::move(*state);
    for (std::size_t i = steps_.size(); i-- > 0;) {
        const PlacedEffect& placed = null.variant.effects[i];
        if (placed.effect.proposal.empty()) continue;
        Remainder r;
        r.node = placed.place.at;
        r.evidence = steps_[i].acceptance.evidence;
        r.proposedEquation = placed.effect.proposal;
        r.proposedClass = placed.effect.className;
        std::string values;
        for (const FitParameter& p : placed.freed)
            for (const FitEstimate& e : null.fit.estimates)
                if (e.name == p.name)
                    values += fmt::format("{}{} = {:.4g}{}{}", values.empty() ? "" : ", ",
                                          p.name.substr(placed.instance.size() + 1), e.value, e.unit.empty() ? "" : " ",
                                          e.unit);
        if (!values.empty()) r.proposedEquation += " with " + values;
        if (with) {
            r.errorFitWith = errorPercentOf(*with, Role::Fit);
            if (hasRole(*with, Role::Validate)) r.errorValidateWith = errorPercentOf(*with, Role::Validate);
        }
        std::optional<NullModel> rest = without(null, i);
        if (!rest) continue;
        found.push_back(std::move(r));
        null = std::move(*rest);
        steps_.erase(steps_.begin() + static_cast<std::ptrdiff_t>(i));
    }
    std::reverse(found.begin(), found.end());
    return found;
}

/// What was chosen beside a proposal may only mend the proposal: it is taken out, to be looked at again without it.
void Search::setAsideBehindProposal(NullModel& null) {
    const std::vector<PlacedEffect>& all = null.variant.effects;
    int first = choices_ + 1;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (!all[i].effect.proposal.empty()) first = std::min(first, steps_[i].order);
    std::vector<PlacedEffect> kept;
    std::vector<Step> steps;
    std::vector<Displaced> aside;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (steps_[i].order <= first || !all[i].effect.proposal.empty()) {
            kept.push_back(all[i]);
            steps.push_back(steps_[i]);
        } else {
            aside.push_back({all[i], steps_[i]});
            setVerdict(all[i].effect.kind, all[i].place.at, Verdict::NotSignificant);
        }
    }
    if (aside.empty()) return;
    std::optional<NullModel> rest = refittedWith(null, kept);
    if (!rest) return;
    null = std::move(*rest);
    steps_ = std::move(steps);
    displaced_.insert(displaced_.end(), std::make_move_iterator(aside.begin()), std::make_move_iterator(aside.end()));
}

/// Without the proposals, the named effects that they had made needless: each is kept if it is missed now.
void Search::bringBackDisplaced(NullModel& null) {
    for (Displaced& each : displaced_) {
        if (progress_.stopRequested()) return;
        say("reconsider", each.effect.effect.kind + " at " + each.effect.place.at, -1);
        std::vector<PlacedEffect> effects = null.variant.effects;
        effects.push_back(each.effect);
        std::optional<NullModel> with = refittedWith(null, effects);
        if (!with) continue;
        const Acceptance missed = examine(null, with->fit, static_cast<int>(each.effect.freed.size()), 0);
        if (!missed.isSignificant || !missed.isWorthwhile || !(missed.heldOut > 0) ||
            !isDetermined(*with, effects.size() - 1) || fightsAnother(null, with->fit))
            continue;
        null = std::move(*with);
        each.step.acceptance = missed;
        setVerdict(each.effect.effect.kind, each.effect.place.at, Verdict::Chosen);
        steps_.push_back(std::move(each.step));
    }
    displaced_.clear();
}

/// For effects of which the recordings leave open what they are: what to run next, and how far that would tell.
std::string Search::proposeExperiments(const NullModel& null) {
    std::string text;
    int count = 0;
    for (std::size_t i = 0; i < steps_.size() && count < mostExperiments && !progress_.stopRequested(); ++i) {
        const PlacedEffect& own = null.variant.effects[i];
        const auto open =
            std::find_if(steps_[i].alternatives.begin(), steps_[i].alternatives.end(),
                         [](const Alternative& a) { return a.equivalent && !a.kind.starts_with("proposal."); });
        if (open == steps_[i].alternatives.end()) continue;
        const std::string names =
            fmt::format("{} at {} from {} at {}", own.effect.kind, own.place.at, open->kind, open->at);
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
        ++count;
        if (!text.empty()) text += ". ";
        text += next->separation >= clearSeparation
                    ? fmt::format("{}, the other inputs at their means, would tell {} by {} standard deviations",
                                  next->programme, names,
                                  next->separation > 100 ? "more than 100" : fmt::format("{:.0f}", next->separation))
                    : fmt::format(
                          "no programme of the inputs within their range tells {} with these sensors (at most "
                          "{:.1f} standard deviations): another quantity has to be measured",
                          names, next->separation);
    }
    return text;
}

AddedEffect Search::describe(const NullModel& last, const PlacedEffect& placed, const Step& step) const {
    AddedEffect effect;
    effect.kind = placed.effect.kind;
    effect.className = placed.effect.className;
    effect.description = placed.effect.description;
    effect.at = placed.place.at;
    effect.way = placed.effect.way;
    effect.instance = placed.instance;
    effect.newInput = placed.newInput;
    effect.channel = placed.place.spare;
    for (const FitParameter& p : placed.freed)
        for (const FitEstimate& e : last.fit.estimates)
            if (e.name == p.name)
                effect.parameters.push_back(
                    {p.name.substr(placed.instance.size() + 1), e.value, e.standardError, e.unit});
    for (const auto& [name, value] : placed.values) {
        const auto unit = placed.effect.units.find(name);
        effect.parameters.push_back({name, value, 0, unit == placed.effect.units.end() ? "" : unit->second});
    }
    effect.evidence.score = step.acceptance.explained;
    effect.evidence.pValue = step.pValue;
    effect.evidence.deltaBic = -step.acceptance.evidence;
    effect.evidence.heldOut = step.acceptance.heldOut;
    effect.alternatives = step.alternatives;
    return effect;
}

Outcome<Finding> Search::run() {
    const auto begin = std::chrono::steady_clock::now();
    Outcome<std::vector<EffectClass>> catalogue = effectCatalogue(base_.task.library);
    if (!catalogue) return catalogue.diagnostics();
    Finding finding;
    for (const Diagnostic& w : catalogue.diagnostics()) finding.warnings.push_back(format(w));
    catalogue_ = std::move(*catalogue);
    if (!options_.kinds.empty())
        std::erase_if(catalogue_, [&](const EffectClass& e) {
            return std::find(options_.kinds.begin(), options_.kinds.end(), e.kind) == options_.kinds.end();
        });

    say("fit", base_.task.className, 0);
    Outcome<NullModel> null = fitNull(base_, {}, NoiseLevel::Estimate, options_.fit, progress_);
    if (!null) return null.diagnostics();
    std::optional<NullModel> onAll;
    if (thinning_ > 1) {
        finding.warnings.push_back(
            fmt::format("long recordings: the search works on means of {} samples, the fit before "
                        "and after it on all of them",
                        thinning_));
        Outcome<NullModel> fitted = fitNull(full_, {}, NoiseLevel::Estimate, options_.fit, progress_);
        if (!fitted) return fitted.diagnostics();
        onAll = std::move(*fitted);
    }
    const NullModel& given = onAll ? *onAll : *null;
    Outcome<ModelState> state = stateOf(given.variant, given.fit, options_.fit.simulation, progress_);
    if (!state) return state.diagnostics();
    finding.baseline = std::move(*state);
    finding.final = finding.baseline;
    bestError_ = errorPercentOf(finding.baseline, Role::Fit);

    const NullModel base = *null;
    search_.fit.simulation.relativeTolerance =
        std::clamp(integrationShare * quietest(base), options_.fit.simulation.relativeTolerance, coarsestTolerance);
    Outcome<Path> path = bestPath(base);
    if (!path) return path.diagnostics();
    null = std::move(path->null);
    steps_ = std::move(path->steps);
    displaced_ = std::move(path->displaced);
    candidates_ = std::move(path->candidates);

    // A parameter that changed in mid run is imitated by many slow effects; none of them is it.
    if (!isNoise(base) && !progress_.stopRequested()) change_ = bestChange(base, search_.fit, progress_);
    if (change_ && isBetterThan(base, *null, *change_)) {
        for (const PlacedEffect& e : null->variant.effects)
            setVerdict(e.effect.kind, e.place.at, Verdict::NotSignificant);
        steps_.clear();
        null = base;
        finding.final = finding.baseline;
    } else {
        change_.reset();
    }
    // where a proposal explains all, what it made needless only imitated it
    const bool leavesMuch = levelOf(null->fit) > largeResidual;
    if (leavesMuch) setAsideBehindProposal(*null);
    std::vector<Remainder> proposed = takeOutProposals(*null);
    if (!proposed.empty()) {
        if (leavesMuch) bringBackDisplaced(*null);
        removeUnneeded(*null, 0);  // what was seen only beside a proposal is not kept without it
    }
    finding.nextExperiment = proposeExperiments(*null);
    if (onAll && steps_.empty()) null = *onAll;
    if (!steps_.empty() && !progress_.stopRequested()) {
        // the search was content with less: on every sample, and integrated as exactly as was asked for
        Outcome<Variant> whole = null->variant;
        if (onAll) whole = withEffects(full_, null->variant.effects, null->variant.values);
        if (!whole) return whole.diagnostics();
        Outcome<NullModel> fitted = fitNull(*whole, onAll ? onAll->noise : null->noise,
                                            onAll ? NoiseLevel::Estimate : NoiseLevel::Keep, options_.fit, progress_);
        if (!fitted) return fitted.diagnostics();
        null = std::move(*fitted);
    }
    if (progress_.stopRequested()) {
        if (path->state) finding.final = std::move(*path->state);
    } else if (!steps_.empty()) {
        Outcome<ModelState> after = stateOf(null->variant, null->fit, options_.fit.simulation, progress_);
        if (!after) return after.diagnostics();
        finding.final = std::move(*after);
    }
    const Outcome<FlatModel> valued = flattened(null->variant.task, finding.final.modelText);
    for (std::size_t i = 0; i < steps_.size() && i < null->variant.effects.size(); ++i) {
        AddedEffect effect = describe(*null, null->variant.effects[i], steps_[i]);
        if (valued) appendDerived(*valued, effect);
        // what the model is without this effect, and with it; the others are there in both
        effect.evidence.errorPercentBefore =
            steps_[i].errorWithout >= 0 ? steps_[i].errorWithout : errorPercentOf(finding.baseline, Role::Fit);
        effect.evidence.errorPercentAfter = errorPercentOf(finding.final, Role::Fit);
        finding.effects.push_back(effect);
        const PlacedEffect& placed = null->variant.effects[i];
        for (std::size_t t = 0; t < placed.twins.size(); ++t) {
            effect.at = placed.twins[t].at;
            effect.instance = placed.twinInstances[t];
            effect.alternatives.clear();
            finding.effects.push_back(effect);
            finding.warnings.push_back(fmt::format(
                "{} stands at {} and {} with one set of parameters: equal sensors, and the data do not tell them apart",
                effect.kind, placed.place.at, effect.at));
        }
    }
    finding.candidates = std::move(candidates_);
    finding.interrupted = progress_.stopRequested();
    if (!finding.interrupted) {
        finding.remainders = remainders(*null, options_.fit.simulation);
        offer(std::move(proposed), finding.remainders);
        if (change_) {
            Remainder r;
            r.node = change_->parameter.substr(0, change_->parameter.rfind('.'));
            r.from = change_->time;
            r.to = finding.final.experiments[static_cast<std::size_t>(change_->experiment)].time.back();
            r.evidence = change_->explained;
            r.proposedEquation = fmt::format("{} = if time < {:.4g} then {:.4g} else {:.4g}", change_->parameter,
                                             change_->time, change_->before, change_->after);
            finding.warnings.push_back(
                fmt::format("the condition seems to have changed in mid run: {} at about {:.4g} s", change_->parameter,
                            change_->time));
            offer({r}, finding.remainders);
            if (finding.remainders.front().output.empty()) finding.remainders.erase(finding.remainders.begin());
        }
    }
    for (const auto& sentences : {extrapolations(full_.task), driftBetweenRecordings(*null), boundHits(null->fit)})
        finding.warnings.insert(finding.warnings.end(), sentences.begin(), sentences.end());
    // an interrupted search has not looked at what is left in detail, but must not call it noise
    const bool leavesStructure = !finding.remainders.empty() || (finding.interrupted && !isNoise(*null));
    finding.kind = !leavesStructure ? (finding.effects.empty() ? FindingKind::Adequate : FindingKind::Effect)
                                    : (finding.effects.empty() ? FindingKind::Unexplained : FindingKind::Partial);
    finding.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return finding;
}

}  // namespace

Outcome<ModelState> fitModel(const EstimationTask& task, const FitOptions& options, const Progress& progress) {
    Outcome<NullModel> null = fitNull({task, {}, {}}, {}, NoiseLevel::Estimate, options, progress);
    if (!null) return null.diagnostics();
    // what a cancelled fit came to is simulated to its end: the best so far is a result, a part of a trace is none
    return stateOf(null->variant, null->fit, options.simulation, progress.stopRequested() ? Progress() : progress);
}

Outcome<ModelState> simulateModel(const EstimationTask& task, const SimulationOptions& options,
                                  const Progress& progress) {
    const Variant variant{task, {}, {}};
    return stateOf(variant, {}, options, progress);
}

Outcome<Finding> discover(const EstimationTask& task, const DiscoverOptions& options, const Progress& progress) {
    return Search(task, options, progress).run();
}

}  // namespace analogon
