#include "core/effect/model/null_model.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <mutex>
#include <unsupported/Eigen/FFT>

#include "core/base/range.hpp"
#include "core/base/stop.hpp"
#include "core/effect/thresholds.hpp"
#include "core/residual/noise.hpp"
#include "core/residual/quantisation.hpp"

namespace analogon {

using namespace threshold::noise;

namespace {

constexpr double roughly = 30;  // times the integration's tolerance, for what is only compared

bool standsStill(const FitExperiment& experiment, Eigen::Index output) {
    return !(rangeOf(experiment.measured.row(output)).width() > 0);
}

/// Where a channel stands still its sensor is as noisy as where it moves; nothing else tells its noise if it is 0
/// throughout.
double noiseAtRest(const FitProblem& problem, const std::vector<Eigen::VectorXd>& noise, Eigen::Index output) {
    constexpr double ofNominal = 1e-3;
    double largest = 0;
    for (std::size_t e = 0; e < problem.experiments.size(); ++e)
        if (problem.experiments[e].isFitted(output)) largest = std::max(largest, noise[e][output]);
    const System& system = *problem.experiments.front().system;
    return largest > 0 ? largest : ofNominal * system.outputs()[static_cast<std::size_t>(output)].nominal;
}

/// Noise of every output from what the model leaves, in the units of the output.
std::vector<Eigen::VectorXd> noiseOf(const EstimationTask& task, const PreparedTask& prepared, const FitResult& fit) {
    const std::vector<FitExperiment>& experiments = prepared.problem.experiments;
    std::vector<Eigen::VectorXd> found(experiments.size());
    for (std::size_t e = 0; e < experiments.size(); ++e) {
        const FitExperiment& experiment = experiments[e];
        found[e] = Eigen::VectorXd::Zero(experiment.measured.rows());
        for (Eigen::Index o = 0; o < found[e].size(); ++o) {
            if (experiment.weights[o] <= 0) continue;
            const Eigen::VectorXd r =
                (fit.optimum.trajectories[e].outputs.row(o) - experiment.measured.row(o)).transpose();
            const Eigen::VectorXd m = experiment.measured.row(o).transpose();
            found[e][o] = channelNoise(r, m);
        }
    }
    std::vector<Eigen::VectorXd> noise(task.recordings.size());
    for (std::size_t e = 0; e < experiments.size(); ++e) {
        Eigen::VectorXd& n = noise[static_cast<std::size_t>(prepared.fitRecordings[e])];
        n = found[e];
        for (Eigen::Index o = 0; o < n.size(); ++o) {
            if (experiments[e].weights[o] <= 0) continue;
            if (standsStill(experiments[e], o)) n[o] = std::max(n[o], noiseAtRest(prepared.problem, found, o));
            n[o] = std::max(n[o], 1e-300);
        }
    }
    return noise;
}

std::vector<std::string> namesOfStates(const System& system) {
    std::vector<std::string> names;
    for (const SignalInfo& state : system.states()) names.push_back(state.name);
    return names;
}

}  // namespace

struct NullModel::FoundOnce {
    std::once_flag hasSteps, hasScores;
    StepsBeside steps;
    std::optional<ScoresBeside> scores;
};

std::shared_ptr<NullModel::FoundOnce> NullModel::nothingYet() { return std::make_shared<FoundOnce>(); }

std::vector<GridPlan> NullModel::plansOf(const System& system, const SimulationOptions& simulation,
                                         const Progress& progress) const {
    std::vector<GridPlan> plans = stepsOf(fit);
    for (std::size_t e = 0; e < plans.size(); ++e)
        if (plans[e].method == GridMethod::Exact && !system.isLinearTimeInvariant())
            plans[e] = steps(simulation, progress).fine[e];
    return plans;
}

SimulationOptions coarse(SimulationOptions simulation) {
    simulation.relativeTolerance *= roughly;
    simulation.isGlance = true;
    return simulation;
}

const StepsBeside& NullModel::steps(const SimulationOptions& simulation, const Progress& progress) const {
    std::call_once(found->hasSteps, [&] {
        StepsBeside& steps = found->steps;
        steps.fine = steps.coarse = stepsOf(fit);
        const Outcome<PreparedTask> held = prepareHeld(variant, {}, noise);
        if (!held) return;
        steps.states = namesOfStates(*held->system);
        SimulationOptions stepwise = simulation;
        stepwise.byRecurrence = false;
        for (std::size_t e = 0; e < steps.fine.size(); ++e) {
            const auto planned = [&](const SimulationOptions& options) {
                return planFor(held->problem, static_cast<int>(e), {}, options, progress);
            };
            SimulationTask task = taskOf(held->problem.experiments[e]);
            task.keepStates = true;
            steps.atTheSamples.push_back(simulateGrid(task, steps.fine[e], simulation).states);
            if (steps.fine[e].method == GridMethod::Exact) steps.fine[e] = planned(stepwise);
            steps.coarse[e] = planned(coarse(stepwise));
        }
    });
    return found->steps;
}

const ScoresBeside& NullModel::scores() const {
    std::call_once(found->hasScores, [&] {
        const Linearisation& at = fit.optimum;
        found->scores = {OrthogonalProjector(at.jacobian), OrthogonalProjector(whitener(at.jacobian)),
                         whitener(at.residuals)};
    });
    return *found->scores;
}

NullModel NullModel::with(Variant other, FitResult fitOfIt) const {
    NullModel model = *this;
    model.variant = std::move(other);
    model.fit = std::move(fitOfIt);
    model.found = nothingYet();
    return model;
}

Outcome<Done> fitNull(NullModel& null, NoiseLevel level, const FitOptions& options, const Progress& progress) {
    // without any noise level the first fit weighs by range, and its residual is that of a poorer optimum
    const int passes = level == NoiseLevel::Keep ? 1 : null.noise.empty() ? 3 : 2;
    for (int pass = 0; pass < passes; ++pass) {
        Outcome<PreparedTask> prepared = prepareAt(null.variant, null.noise);
        if (!prepared) return prepared.diagnostics();
        if (prepared->problem.experiments.empty())
            return error(phrase("the study has no experiment with the role \"fit\""), {},
                         phrase("give at least one experiment that role"));
        FitOptions now = options;
        const bool isLast = pass + 1 == passes;  // those before only tell of the noise
        now.findsRobustErrors = isLast && options.loss == RobustLoss::None;
        now.goesOnInValleys = isLast && options.goesOnInValleys;
        // a misfit that could fall by another 0.3 % leaves a noise level that is right within 0.15 %
        if (!isLast && options.goesOnInValleys) now.costTolerance = std::max(options.costTolerance, 3e-3);
        now.integrationShare = isLast ? options.integrationShare : 0;
        if (Diagnostics faults = validate(prepared->problem); hasError(faults)) return faults;
        FitResult found = fit(prepared->problem, now, progress);
        const bool isWhole = found.optimum.ok;
        const Text message = found.message;
        if (isWhole || found.status == FitStatus::Cancelled) {
            null.fit = std::move(found);
            null.variant.values = valuesOf(null.fit);
            null.variant.plans = stepsOf(null.fit);
        }
        stopPoint();
        if (!isWhole) return numericalError(message, phrase("give other start values, or narrower bounds"));
        if (null.fit.beganElsewhere) null.beginning = {null.variant.values, null.fit.remarks.front()};
        null.channels = residualChannels(prepared->problem);
        if (pass + 1 < passes) null.noise = noiseOf(null.variant.task, *prepared, null.fit);
    }
    null.whitener = Whitener(null.channels, null.fit.optimum.residuals);
    null.period = dominantPeriod(null);
    return Done{};
}

Outcome<NullModel> fitNull(const Variant& start, const std::vector<Eigen::VectorXd>& noise, NoiseLevel level,
                           const FitOptions& options, const Progress& progress) {
    NullModel null;
    null.variant = start;
    null.noise = noise;
    if (Outcome<Done> fitted = fitNull(null, level, options, progress); !fitted) return fitted.diagnostics();
    return null;
}

std::optional<FitResult> fitBeside(const NullModel& null, const Variant& variant, const FitOptions& options,
                                   const Progress& progress) {
    const Outcome<PreparedTask> prepared = prepareAt(variant, null.noise);
    if (!prepared) return std::nullopt;
    FitResult result = fit(prepared->problem, options, progress);
    if (!result.optimum.ok) return std::nullopt;
    return result;
}

double reducedChi(const FitResult& fit) {
    return std::sqrt(fit.optimum.residuals.squaredNorm() / static_cast<double>(fit.optimum.residuals.size()));
}

namespace {

/// A speed counted by an encoder is the difference of two rounded angles: its error has sqrt(2) times the size of a
/// rounding error, and what one sample has too much the next has too little.
bool isOfCounts(const Eigen::VectorXd& residual, double step) {
    constexpr double mostOfIt = 1.1, least = -0.65, most = -0.35;  // of a difference of two: -1/2
    const Eigen::Index count = residual.size() - 1;
    const double squares = residual.squaredNorm(), rms = std::sqrt(squares / static_cast<double>(count + 1));
    const double neighbours = residual.head(count).dot(residual.tail(count)) / squares;
    return rms < mostOfIt * step / std::sqrt(6.0) && neighbours > least && neighbours < most;
}

}  // namespace

bool standsOff(const Eigen::VectorXd& residual) {
    constexpr double share = 0.5, deviations = 4;
    const auto count = static_cast<double>(residual.size());
    const double mean = residual.sum() / count;
    const double scatter = std::max(1.0, std::sqrt((residual.array() - mean).square().sum() / count));
    return std::abs(mean) > std::max(share, deviations / std::sqrt(count)) * scatter;
}

bool isNoise(const ResidualChannel& channel, const Eigen::VectorXd& residuals) {
    const auto isWhite = [](const Eigen::VectorXd& r) {
        return summarise(r).whiteProbability > whiteSignificance && !standsOff(r);
    };
    const Eigen::VectorXd own = residuals.segment(channel.begin, channel.end - channel.begin);
    if (isWhite(own)) return true;
    const double step = quantisationStep(channel.measured);
    if (!(step > 0) || rangeOf(channel.measured).width() < fewestSteps * step) return false;
    const double rms = own.norm() / std::sqrt(static_cast<double>(own.size()));
    return rms < allRounding * step / std::sqrt(12.0) || isOfCounts(own, step) ||
           isWhite(besideRounding(channel, residuals, step));
}

bool isNoise(const std::vector<ResidualChannel>& channels, const FitResult& fit) {
    return std::all_of(channels.begin(), channels.end(),
                       [&](const ResidualChannel& c) { return isNoise(c, fit.optimum.residuals); });
}

bool isNoise(const NullModel& null) { return isNoise(null.channels, null.fit); }

double independentShare(const NullModel& null, const FitResult& fit) {
    const Eigen::VectorXd& r = fit.optimum.residuals;
    const double rows = static_cast<double>(r.size());
    const double share = effectiveCount(null.channels, r) / rows;
    return reducedChi(fit) > largeResidual ? std::min(share, equivalenceMargin / (indistinctShare * rows)) : share;
}

double excess(const NullModel& null) {
    return null.sumOfSquares() - static_cast<double>(null.fit.optimum.residuals.size());
}

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

double quietest(const NullModel& null) {
    double least = 1;
    std::size_t e = 0;
    for (const Recording& r : null.variant.task.recordings) {
        const std::size_t index = e++;
        if (r.role != Role::Fit || index >= null.noise.size()) continue;
        for (Eigen::Index o = 0; o < std::min(r.outputs.rows(), null.noise[index].size()); ++o) {
            const double width = rangeOf(r.outputs.row(o)).width();
            if (width > 0) least = std::min(least, null.noise[index][o] / width);
        }
    }
    return least;
}

bool isDetermined(const PlacedEffect& effect, const std::vector<FitEstimate>& estimates, double deviations) {
    const std::string& strength = effect.freed.front().name;
    return std::any_of(estimates.begin(), estimates.end(), [&](const FitEstimate& e) {
        return e.name == strength && std::isfinite(e.standardError) && deviations * e.standardError < std::abs(e.value);
    });
}

bool isScaleOpen(const PlacedEffect& effect, const std::vector<FitEstimate>& estimates) {
    return std::any_of(estimates.begin(), estimates.end(), [&](const FitEstimate& e) {
        const bool isOwn = std::any_of(effect.freed.begin(), effect.freed.end(),
                                       [&](const FitParameter& p) { return p.name == e.name; });
        return !isOwn && !(std::isfinite(e.standardError) && e.standardError < std::abs(e.value));
    });
}

bool isDetermined(const NullModel& null, std::size_t effect) {
    return isDetermined(null.variant.effects[effect], null.fit.estimates);
}

bool hasProposal(const NullModel& null) {
    return std::any_of(null.variant.effects.begin(), null.variant.effects.end(),
                       [](const PlacedEffect& e) { return !e.effect.proposal.empty(); });
}

double dominantPeriod(const NullModel& null) {
    const Eigen::VectorXd white = null.whitener(null.fit.optimum.residuals);
    std::vector<const Recording*> fitted;
    for (const Recording& r : null.variant.task.recordings)
        if (r.role == Role::Fit) fitted.push_back(&r);
    double largest = 0, period = 0;
    Eigen::FFT<double> transform;
    for (const ResidualChannel& c : null.channels) {
        const std::vector<double>& time = fitted[static_cast<std::size_t>(c.experiment)]->time;
        const int count = c.end - c.begin;
        if (count < 16) continue;
        const std::vector<double> x(white.data() + c.begin, white.data() + c.end);
        std::vector<std::complex<double>> spectrum;
        transform.fwd(spectrum, x);
        const double span =
            time[static_cast<std::size_t>(c.samples.back())] - time[static_cast<std::size_t>(c.samples.front())];
        for (std::size_t k = 2; k < spectrum.size() / 2 && k < static_cast<std::size_t>(count) / 2; ++k)
            if (std::norm(spectrum[k]) / count > largest) {
                largest = std::norm(spectrum[k]) / count;
                period = span * count / (count - 1.0) / static_cast<double>(k);
            }
    }
    return period;
}

std::vector<Trajectory> observe(const NullModel& null, const PreparedTask& held, const std::vector<std::string>& names,
                                const SimulationOptions& simulation) {
    std::vector<Trajectory> traces;
    const std::vector<GridPlan> plans = null.plansOf(*held.system, simulation, {});
    const StepsBeside& beside = null.steps(simulation, {});
    // what is switched off and has no states of its own goes the way of the model
    const bool isSameWay = !beside.states.empty() && namesOfStates(*held.system) == beside.states;
    for (std::size_t e = 0; e < held.problem.experiments.size(); ++e) {
        SimulationTask task = taskOf(held.problem.experiments[e]);
        task.observe = names;
        if (std::optional<Eigen::MatrixXd> seen;
            isSameWay && (seen = observeAlong(task, beside.atTheSamples[e])) && seen->allFinite()) {
            traces.emplace_back().observed = std::move(*seen);
            continue;
        }
        Trajectory t = simulateGrid(task, plans[e], simulation);
        // switched off, an inserted block may still be stiff
        if (t.failure.failed) t = simulateGrid(task, planGrid(task, simulation), simulation);
        traces.push_back(std::move(t));
    }
    return traces;
}

}  // namespace analogon
