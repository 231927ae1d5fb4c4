#include "core/effect/block/trial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/effect/block/trial_parameters.hpp"
#include "core/effect/thresholds.hpp"
#include "core/fit/held_value.hpp"

namespace analogon {

using namespace threshold::trial;

/// A point from which a candidate may be refitted.
struct TrialStart {
    Variant variant;  // effect's parameters freed, at their start values
    PreparedTask prepared;
    double promised{};  // half the sum of squares once the linearised problem is solved from here
    bool isAlongRecorded{};
    std::vector<GridPlan> plans{};  // of the steps near here; empty: not known
    bool isWaiting{};               // `prepared` holds its parameters alone: it is prepared anew when its turn comes
};

namespace {

constexpr int mostRefinements = 2;
constexpr double refinement = 0.1;

/// A simulation near a start, with the steps that served there before: to choose them takes longer than to take them.
Linearisation lineariseAt(TrialStart& start, const Eigen::VectorXd& values, bool withJacobian,
                          const SimulationOptions& options, const Progress& progress) {
    const FitProblem& problem = start.prepared.problem;
    if (!start.plans.empty()) {
        Linearisation known = linearise(problem, values, withJacobian, start.plans, options, progress);
        if (known.ok) return known;
    }
    Linearisation at = linearise(problem, values, withJacobian, {}, options, progress);
    // coarse steps may be stable for states that a friction holds, and not for what moves them
    SimulationOptions finer = options;
    for (int pass = 0; pass < mostRefinements && withJacobian && !at.ok && !progress.stopRequested(); ++pass) {
        finer.relativeTolerance *= refinement;
        at = linearise(problem, values, withJacobian, {}, finer, progress);
    }
    start.plans.clear();
    for (const Trajectory& t : at.trajectories)
        if (at.ok) start.plans.push_back(t.plan);
    return at;
}

/// Half the sum of squares that is left when all parameters follow the tangent at this point.
double promisedCost(const Linearisation& at) {
    return 0.5 * OrthogonalProjector(at.jacobian)(at.residuals).squaredNorm();
}

/// The strength of the newest effect among the parameters of its problem.
std::vector<FitParameter>::iterator strengthOf(TrialStart& start) {
    const std::string& name = start.variant.effects.back().freed.front().name;
    std::vector<FitParameter>& parameters = start.prepared.problem.parameters;
    return std::find_if(parameters.begin(), parameters.end(), [&](const FitParameter& p) { return p.name == name; });
}

/// Lets the first `count` starts hold one along the recorded course and one along the simulated, where there are both:
/// what they promise does not compare.
void bothCourses(std::vector<TrialStart>& starts, std::size_t count) {
    if (count < 2 || starts.size() <= count) return;
    const auto last = starts.begin() + static_cast<std::ptrdiff_t>(count);
    const auto isOther = [&](const TrialStart& s) { return s.isAlongRecorded != starts.front().isAlongRecorded; };
    if (std::any_of(starts.begin(), last, isOther)) return;
    if (const auto other = std::find_if(last, starts.end(), isOther); other != starts.end())
        std::iter_swap(last - 1, other);
}

bool isAmong(const std::vector<std::string>& names, const PlacedEffect& placed, const FitParameter& parameter) {
    return std::any_of(names.begin(), names.end(),
                       [&](const std::string& name) { return parameter.name == placed.instance + "." + name; });
}

bool isWhole(const PlacedEffect& placed, const FitParameter& parameter) {
    return isAmong(placed.effect.parameters.whole, placed, parameter);
}

/// Where the strength comes from a slope at 0, the slope may promise far more than the model bears there (a magnet that
/// warms until its field turns over). The strength is taken back until it is no worse than the model without; where
/// that is no way down, so is all that the effect is linear in (a friction beside one of which it takes the part), and
/// where all of it is none either, the strength begins alone (beside a friction of nearly that form, of which it would
/// take any amount).
void takeBack(const NullModel& null, TrialStart& start, const SimulationOptions& simulation, const Progress& progress) {
    std::vector<FitParameter>& parameters = start.prepared.problem.parameters;
    const std::vector<FitParameter> promised = parameters;
    const PlacedEffect& placed = start.variant.effects.back();
    const auto leadsDown = [&](const std::vector<std::string>& taken, double first) {
        for (double part = first; part > 0.01; part *= 0.25) {
            for (std::size_t i = 0; i < parameters.size(); ++i)
                if (isAmong(taken, placed, promised[i]))
                    parameters[i].start = std::clamp(part * promised[i].start, promised[i].min, promised[i].max);
            const Linearisation at =
                lineariseAt(start, start.prepared.problem.startValues(), false, simulation, progress);
            if (at.ok && at.residuals.squaredNorm() < null.sumOfSquares()) return true;
        }
        return false;
    };
    const std::vector<std::string>& further = placed.effect.parameters.linear;
    std::vector<std::string> all = further;
    all.push_back(placed.effect.parameters.strength);
    if (leadsDown({placed.effect.parameters.strength}, 1) || (!further.empty() && leadsDown(all, 0.25))) return;
    parameters = promised;
    if (further.empty()) return;
    for (FitParameter& p : parameters)
        if (isAmong(further, placed, p)) p.start = std::clamp(0.0, p.min, p.max);
    if (!leadsDown({placed.effect.parameters.strength}, 1)) parameters = promised;
}

/// Moves the start to the optimum of a problem with the same parameters, whole numbers held where they start.
void follow(TrialStart& start, FitProblem held, const FitOptions& options, const Progress& progress) {
    const PlacedEffect& placed = start.variant.effects.back();
    std::vector<FitParameter>& parameters = start.prepared.problem.parameters;
    for (const FitParameter& p : parameters)
        if (isWhole(placed, p)) setParameter(held, p.name, p.start);
    std::erase_if(held.parameters, [&](const FitParameter& p) { return isWhole(placed, p); });
    for (FitParameter& own : held.parameters)
        for (const FitParameter& p : parameters)
            if (p.name == own.name && p.experiment == own.experiment) own.start = p.start;
    const FitResult result = fit(held, options, progress);
    if (!result.optimum.ok) return;
    for (const FitEstimate& e : result.estimates)
        for (FitParameter& p : parameters)
            if (p.name == e.name && p.experiment == e.experiment) p.start = e.value;
}

/// Over many turns a count of waves that is off by a little fits nearly as well one turn later, and no slope leads from
/// there to the best: what is a whole number is held at the start until all else has followed.
void followWholeNumbers(TrialStart& start, const FitOptions& options, const Progress& progress) {
    if (!start.variant.effects.back().effect.parameters.whole.empty())
        follow(start, start.prepared.problem, options, progress);
}

/// Where the flow goes along a course that the model without it misses, all parameters first follow along the recorded
/// one: from there the model takes that course by itself.
void followRecorded(const NullModel& null, const Screened& screened, TrialStart& start, const FitOptions& options,
                    const Progress& progress) {
    if (!start.isAlongRecorded || !screened.recorded) return;
    Variant variant = *screened.recorded;
    for (const FitParameter& p : start.variant.effects.back().freed) variant.task.parameters.push_back(p);
    const Outcome<PreparedTask> prepared = prepareAt(variant, null.noise);
    if (prepared) follow(start, prepared->problem, options, progress);
}

}  // namespace

FitOptions trialOptions(FitOptions options, int iterations) {
    options.maxIterations = iterations;
    options.costTolerance = trialTolerance;
    return options;
}

bool isWeighed(std::ptrdiff_t ready, double explained, double best) {
    return ready < (explained < faintShare * best ? mostStarts / 2 : mostStarts);
}

TrialStarts::TrialStarts(const NullModel& null, const Screened& screened, const FitOptions& options, int starts,
                         const Progress& progress)
    : null_(null), screened_(screened), options_(options), progress_(progress) {
    best_.screened = screened;
    const Outcome<Variant> wired = wiredIn(null, screened);
    if (!wired) {
        best_.failure = wired.diagnostics().front().message;
        return;
    }
    best_.variant = *wired;
    const SimulationOptions rough = coarse(options.simulation);  // starts are only compared
    const std::vector<std::pair<const Probe*, double>> offered = startsOf(screened);
    for (const auto& [probe, strength] : offered) {
        if (progress.stopRequested()) break;
        const auto alike = std::count_if(ready_.begin(), ready_.end(), [&](const TrialStart& s) {
            return s.isAlongRecorded == probe->isAlongRecorded;
        });
        if (!isWeighed(alike, probe->plain.explained, offered.front().first->plain.explained)) continue;
        std::optional<TrialStart> start = begin(*wired, *probe, strength);
        if (!start) continue;
        if (probe->secant == 0 && !probe->isAlongRecorded) takeBack(null, *start, rough, progress);
        start->isAlongRecorded = probe->isAlongRecorded;
        if (probe->isAlongRecorded) {
            start->promised = 0.5 * (null.sumOfSquares() - probe->plain.explained);
        } else if (offered.size() > 1) {
            const Eigen::VectorXd values = start->prepared.problem.startValues();
            const Linearisation at = lineariseAt(*start, values, true, rough, progress);
            if (!at.ok || !at.jacobian.allFinite()) continue;
            start->promised = promisedCost(at);
            // where the effect is not felt at all (below a threshold) a search by slopes has nowhere to go
            const Eigen::Index strengthColumn = strengthOf(*start) - start->prepared.problem.parameters.begin();
            if (at.jacobian.col(strengthColumn).norm() * std::abs(values[strengthColumn]) < 1e-6 * at.residuals.norm())
                continue;
        }
        ready_.push_back(std::move(*start));
    }
    std::stable_sort(ready_.begin(), ready_.end(),
                     [](const TrialStart& a, const TrialStart& b) { return a.promised < b.promised; });
    const auto count = static_cast<std::size_t>(starts);
    bothCourses(ready_, count);
    if (ready_.size() > count) ready_.erase(ready_.begin() + static_cast<std::ptrdiff_t>(count), ready_.end());
    // the measurements of a start that may never have its turn are not kept for it
    for (std::size_t i = 1; i < ready_.size(); ++i) {
        PreparedTask alone;
        alone.problem.parameters = std::move(ready_[i].prepared.problem.parameters);
        ready_[i].prepared = std::move(alone);
        ready_[i].isWaiting = true;
    }
}

std::optional<PreparedTask> TrialStarts::prepared(const Variant& variant) {
    Outcome<PreparedTask> prepared = prepareAt(variant, null_.noise);
    if (!prepared) {
        best_.failure = prepared.diagnostics().front().message;
        return std::nullopt;
    }
    // the steps of the model without it serve near it, too: where that takes exact ones and this cannot, others
    prepared->problem.knownPlans = null_.plansOf(*prepared->system, options_.simulation, progress_);
    return std::move(*prepared);
}

std::optional<TrialStart> TrialStarts::begin(const Variant& wired, const Probe& probe, double strength) {
    TrialStart start;
    start.variant = wired;
    start.variant.effects.back().freed = freedParameters(screened_, probe, wired);
    if (strength != 0) start.variant.effects.back().freed.front().start = strength;
    for (const FitParameter& p : start.variant.effects.back().freed) start.variant.task.parameters.push_back(p);
    std::optional<PreparedTask> task = prepared(start.variant);
    if (!task) return std::nullopt;
    start.prepared = std::move(*task);
    for (FitParameter& p : start.prepared.problem.parameters) p.start = std::clamp(p.start, p.min, p.max);
    return start;
}

bool TrialStarts::resume(TrialStart& start) {
    std::optional<PreparedTask> task = prepared(start.variant);
    if (!task) return false;
    task->problem.parameters = std::move(start.prepared.problem.parameters);
    start.prepared = std::move(*task);
    return true;
}

TrialStarts::~TrialStarts() = default;

bool TrialStarts::hasNext() const { return next_ < ready_.size() && !progress_.stopRequested(); }

double TrialStarts::promised() const { return 2 * ready_[next_].promised; }

void TrialStarts::dropSlopes() {
    best_.isLean = best_.ok;
    best_.fit.optimum.jacobian.resize(0, 0);
    best_.fit.optimum.trajectories.clear();
}

void TrialStarts::takeNext() {
    TrialStart start = std::move(ready_[next_++]);
    if (start.isWaiting && !resume(start)) return;
    followRecorded(null_, screened_, start, options_, progress_);
    followWholeNumbers(start, options_, progress_);
    FitResult result = fit(start.prepared.problem, options_, progress_);
    if (!result.optimum.ok) {
        best_.failure = result.message;
        return;
    }
    holdWholeNumber(start, result);
    if (best_.ok && result.objective >= best_.fit.objective) return;
    best_.isLean = false;
    best_.variant = std::move(start.variant);
    best_.variant.values = valuesOf(result);
    best_.variant.plans = stepsOf(result);
    best_.fit = std::move(result);
    best_.ok = true;
}

/// Holds a whole number at the better of those next to where the fit came to, if that explains nearly as much: beside
/// what is not right yet a fraction of a period explains a little more, and takes the place of what is missing.
void TrialStarts::holdWholeNumber(TrialStart& start, FitResult& result) const {
    const PlacedEffect placed = start.variant.effects.back();
    const auto whole = std::find_if(placed.freed.begin(), placed.freed.end(), [&](const FitParameter& p) {
        return isWhole(placed, p) && result.find(p.name) != nullptr;
    });
    if (whole == placed.freed.end()) return;
    // below the least that was tried it is no number of periods: a spring that stiffens looks like half of one
    const std::string name = whole->name.substr(placed.instance.size() + 1);
    const double least = whole->min * reachOf(placed.effect, name) - 1e-6;
    const std::vector<ParameterValue> found = valuesOf(result);
    const double value = result.find(whole->name)->value;
    if (value < least) return;
    const auto chi2Decrease = [&](const FitResult& r) {
        return null_.sumOfSquares() - r.optimum.residuals.squaredNorm();
    };
    double most = threshold::acceptance::simplerKeeps * chi2Decrease(result);
    for (const double number : {std::floor(value), std::ceil(value)}) {
        if (!(number >= least && number <= whole->max) || progress_.stopRequested()) continue;
        PlacedEffect with = placed;
        with.values[name] = number;
        std::erase_if(with.freed, [&](const FitParameter& p) { return p.name == whole->name; });
        Outcome<Variant> held = withEffects(null_.variant, {with}, found);
        if (!held) return;
        const Outcome<PreparedTask> prepared = prepareAt(*held, null_.noise);
        if (!prepared) return;
        FitResult fitted = fit(prepared->problem, options_, progress_);
        if (!fitted.optimum.ok || !(chi2Decrease(fitted) > most)) continue;
        most = chi2Decrease(fitted);
        start.variant = std::move(*held);
        result = std::move(fitted);
    }
}

Trial refit(const NullModel& null, const Screened& screened, const FitOptions& options, int starts,
            const Progress& progress) {
    TrialStarts all(null, screened, options, starts, progress);
    while (all.hasNext()) all.takeNext();
    return std::move(all).best();
}

void proceed(const NullModel& null, Trial& trial, const FitOptions& options, const Progress& progress) {
    Outcome<PreparedTask> prepared = prepareAt(trial.variant, null.noise);
    if (!prepared) return;
    FitResult result = fit(prepared->problem, options, progress);
    if (!result.optimum.ok || result.objective > trial.fit.objective) return;
    trial.variant.values = valuesOf(result);
    trial.variant.plans = stepsOf(result);
    trial.fit = std::move(result);
    trial.isLean = false;
}

const Trial* leastLeft(const std::vector<Trial>& trials) {
    const auto best = std::min_element(trials.begin(), trials.end(), [](const Trial& a, const Trial& b) {
        return (a.ok ? a.sumOfSquares() : 1e300) < (b.ok ? b.sumOfSquares() : 1e300);
    });
    return best != trials.end() && best->ok ? &*best : nullptr;
}

void rank(const NullModel& null, std::vector<Trial>& trials) {
    const Trial* best = leastLeft(trials);
    if (best == nullptr) return;
    const EvidenceScale evidence(null, best->fit);
    for (Trial& t : trials) t.evidence = t.ok ? evidence.of(t.sumOfSquares(), t.freed()) : -1e300;
    std::stable_sort(trials.begin(), trials.end(),
                     [](const Trial& a, const Trial& b) { return a.evidence > b.evidence; });
}

}  // namespace analogon
