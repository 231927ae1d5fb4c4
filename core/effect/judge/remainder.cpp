#include "core/effect/judge/remainder.hpp"

#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <optional>
#include <random>

#include "core/effect/model/channel_rows.hpp"
#include "core/effect/thresholds.hpp"
#include "core/residual/quantisation.hpp"

namespace analogon {

using threshold::acceptance::leastBesideOthers;
using threshold::noise::moreThanChance;

namespace {

constexpr double leastMotion = 1e-9;       // of a quantity, beside what the parameters imitate: rounding
constexpr double nothing = 1e-3;           // sigma: what rounding leaves of an output at rest
constexpr double leastCorrelation = 0.05;  // that is told
constexpr int mostShift = 20;              // samples by which two outputs may be shifted to each other

constexpr std::size_t mostCorrelates = 5;  // that are told

/// A quantity the residual may move with, at the samples of every fitted experiment.
struct Regressor {
    std::string variable;
    std::vector<Eigen::VectorXd> series;  // per experiment
};

Eigen::VectorXd differences(const Eigen::VectorXd& x) {
    Eigen::VectorXd d = Eigen::VectorXd::Zero(x.size());
    for (Eigen::Index k = 1; k + 1 < x.size(); ++k) d[k] = 0.5 * (x[k + 1] - x[k - 1]);
    return d;
}

std::vector<Regressor> regressors(const NullModel& null, const PreparedTask& prepared,
                                  const SimulationOptions& simulation) {
    std::vector<Regressor> all;
    const FitProblem& problem = prepared.problem;
    const System& system = *prepared.system;
    const auto add = [&](const std::string& name, const auto& seriesOf) {
        Regressor r{name, {}};
        for (std::size_t e = 0; e < problem.experiments.size(); ++e) r.series.push_back(seriesOf(e));
        all.push_back(std::move(r));
    };
    const auto addForms = [&](const std::string& name, const auto& seriesOf) {
        add(name, seriesOf);
        add("der(" + name + ")", [&](std::size_t e) { return differences(seriesOf(e)); });
        add(name + "*abs(" + name + ")",
            [&](std::size_t e) { return Eigen::VectorXd(seriesOf(e).array() * seriesOf(e).array().abs()); });
        add("sign(" + name + ")", [&](std::size_t e) { return Eigen::VectorXd(seriesOf(e).array().sign()); });
    };
    for (int i = 0; i < system.inputCount(); ++i)
        addForms(system.inputs()[static_cast<std::size_t>(i)].name, [&](std::size_t e) {
            return Eigen::VectorXd(problem.experiments[e].inputs.values.row(i).transpose());
        });
    std::vector<Eigen::MatrixXd> states;
    for (std::size_t e = 0; e < problem.experiments.size(); ++e) {
        SimulationTask task = taskOf(problem.experiments[e]);
        task.keepStates = true;
        states.push_back(simulateGrid(task, null.fit.plans[e], simulation).states);
    }
    for (int i = 0; i < system.stateCount(); ++i)
        addForms(system.states()[static_cast<std::size_t>(i)].name,
                 [&](std::size_t e) { return Eigen::VectorXd(states[e].row(i).transpose()); });
    for (const Recording& r : null.variant.task.recordings) {
        if (r.role != Role::Fit) continue;
        for (const SpareChannel& s : r.spares)
            add(s.name, [&](std::size_t e) {
                const Recording& recording =
                    null.variant.task.recordings[static_cast<std::size_t>(prepared.fitRecordings[e])];
                for (const SpareChannel& channel : recording.spares)
                    if (channel.name == s.name)
                        return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(
                            channel.values.data(), static_cast<Eigen::Index>(channel.values.size())));
                return Eigen::VectorXd(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(recording.time.size())));
            });
        break;
    }
    add("time", [&](std::size_t e) {
        const std::vector<double>& t = problem.experiments[e].inputs.time;
        return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(t.data(), static_cast<Eigen::Index>(t.size())));
    });
    return all;
}

/// The stretch of an eighth of the record in which the squares are largest.
void locate(const NullModel& null, const PreparedTask& prepared, const ResidualChannel& channel, Remainder& remainder) {
    constexpr int stretches = 8;
    const std::vector<double>& time =
        prepared.problem.experiments[static_cast<std::size_t>(channel.experiment)].inputs.time;
    const int count = channel.end - channel.begin;
    double largest = -1;
    for (int s = 0; s < stretches; ++s) {
        const int from = count * s / stretches, to = count * (s + 1) / stretches;
        if (to <= from) continue;
        const double power =
            null.fit.optimum.residuals.segment(channel.begin + from, to - from).squaredNorm() / (to - from);
        if (power <= largest) continue;
        largest = power;
        remainder.from = time[static_cast<std::size_t>(channel.samples[static_cast<std::size_t>(from)])];
        remainder.to = time[static_cast<std::size_t>(channel.samples[static_cast<std::size_t>(to - 1)])];
    }
}

/// F test of all regressors together on the residual made white.
double pWhitened(const Explained& all, double total, int count) {
    const double dof = static_cast<double>(all.directions.cols());
    const double f = all.explained / dof / std::max(1e-300, (total - all.explained) / (count - dof));
    return boost::math::cdf(boost::math::complement(boost::math::fisher_f(dof, count - dof), std::max(0.0, f)));
}

/// The same on the residual as it is, each channel taken for noise of its own level and correlation time: an
/// autoregressive model hides slow structure, this does not.
class PatientTest {
public:
    explicit PatientTest(const NullModel& null) : colours_(null.whitener) {
        const Eigen::VectorXd& residuals = null.fit.optimum.residuals;
        scale_ = Eigen::VectorXd::Zero(residuals.size());
        for (const ResidualChannel& c : null.channels) {
            const int count = c.end - c.begin;
            const Eigen::VectorXd own = residuals.segment(c.begin, count);
            const double variance = own.squaredNorm() / count, memory = summarise(own).autocorrelationTime;
            if (variance > 0)
                scale_.segment(c.begin, count).setConstant(1 / std::sqrt(variance * std::max(1.0, memory)));
        }
        complement_.emplace(Eigen::MatrixXd(scale_.asDiagonal() * null.fit.optimum.jacobian));
        basis_.emplace(*complement_, null.channels);
        scaled_ = scaled(residuals);
    }

    /// `columns`: the rows of the channel, its place among the channels. `unlikely`: probability below which noise of
    /// the channels' own colours is asked how often it moves so much. What slow quantities explain of slow noise leaves
    /// it faster than it was, and the test is too sure.
    double p(std::size_t channel, const Eigen::MatrixXd& columns, double unlikely) const {
        const ChannelRows through(*basis_, channel);
        const Eigen::Index count = columns.rows();
        const Eigen::MatrixXd rest =
            through.rest(scale_.segment(basis_->parts[channel].begin, count).asDiagonal() * columns);
        const Eigen::VectorXd residual = through(scaled_);
        const Eigen::MatrixXd directions = explainedBy(residual, rest).directions;
        const double dof = static_cast<double>(directions.cols());
        const Ratio own = ratio(count, directions, residual);
        if (dof < 1 || own.effective < 2 * dof + 10) return 1;
        const double p =
            boost::math::cdf(boost::math::complement(boost::math::fisher_f(dof, own.effective - dof), own.f));
        return p < unlikely ? std::max(p, pAmongSurrogates(through, count, directions, own.f)) : p;
    }

private:
    static constexpr int surrogates = 60;

    /// What some directions explain of a channel, over what they would of noise of the memory that is left.
    struct Ratio {
        double f{}, effective{};
    };

    Eigen::VectorXd scaled(const Eigen::VectorXd& residuals) const {
        return (*complement_)(Eigen::MatrixXd(scale_.cwiseProduct(residuals)));
    }

    /// `count`: of the samples, which are the first rows.
    static Ratio ratio(Eigen::Index count, const Eigen::MatrixXd& directions, const Eigen::VectorXd& residuals) {
        const double dof = static_cast<double>(directions.cols()), n = static_cast<double>(count);
        const Eigen::VectorXd along = directions.transpose() * residuals, left = residuals - directions * along;
        const ResidualSummary noise = summarise(left.head(count));
        const double effective = n / std::max(1.0, noise.autocorrelationTime);
        const double variance = left.head(count).squaredNorm() / (n - dof);
        return {along.squaredNorm() / variance * effective / n / dof, effective};
    }

    /// Parametric bootstrap: the logarithm of the ratio is nearly normal.
    double pAmongSurrogates(const ChannelRows& through, Eigen::Index count, const Eigen::MatrixXd& directions,
                            double f) const {
        std::mt19937_64 random(1);
        Eigen::VectorXd logs(surrogates);
        for (double& log : logs) log = std::log(ratio(count, directions, through(scaled(colours_.noise(random)))).f);
        const double mean = logs.mean(), deviation = std::sqrt((logs.array() - mean).square().sum() / (surrogates - 1));
        const double t = (std::log(f) - mean) / (deviation * std::sqrt(1 + 1.0 / surrogates));
        return boost::math::cdf(boost::math::complement(boost::math::students_t(surrogates - 1), t));
    }

    const Whitener& colours_;
    Eigen::VectorXd scale_, scaled_;
    std::optional<OrthogonalProjector> complement_;
    std::optional<ChannelwiseBasis> basis_;  // of what it takes out
};

/// Whether what is left on two outputs of a recording goes together, at a shift (without its colour) or at a frequency:
/// sensors have no noise in common.
bool isShared(const std::vector<ResidualChannel>& channels, const Eigen::VectorXd& residuals,
              const Eigen::VectorXd& white) {
    for (std::size_t i = 0; i < channels.size(); ++i)
        for (std::size_t j = i + 1; j < channels.size(); ++j) {
            if (channels[i].experiment != channels[j].experiment || channels[i].samples != channels[j].samples)
                continue;
            const int from = channels[i].begin, other = channels[j].begin, count = channels[i].end - from;
            if (coherenceProbability(residuals.segment(from, count), residuals.segment(other, count)) <
                whiteSignificance)
                return true;
            const Eigen::VectorXd a = white.segment(from, count), b = white.segment(other, count);
            const double chance = a.norm() * b.norm() / std::sqrt(static_cast<double>(count));
            for (int lag = -std::min(mostShift, count - 1); lag <= std::min(mostShift, count - 1); ++lag) {
                const int rest = count - std::abs(lag);
                const double together = lag < 0 ? a.head(rest).dot(b.tail(rest)) : a.tail(rest).dot(b.head(rest));
                if (std::abs(together) > moreThanChance * chance) return true;
            }
        }
    return false;
}

/// A channel under the tests.
struct Examined {
    const ResidualChannel* channel{};
    ResidualSummary summary;
    double explained{};                // by what it may move with, white; 0 where there are too few samples to tell
    int directions{};                  // of that
    std::vector<Correlate> movesWith;  // most first
    double pMoves{1};                  // that it moves with so much by chance
    double standsOff{};                // evidence that it stays off by a good part of the noise
    bool isWhite{}, isNoise{};
};

/// What a residual is asked with: the model, what may move with it, and the units in which it stands.
struct Examination {
    const NullModel& null;
    const Eigen::VectorXd& scale;  // one a row; empty: those of the noise throughout
    const PreparedTask& prepared;
    const std::vector<Regressor>& regressors;
    PatientTest patient;
    ChannelwiseBasis whiteBasis;  // of what the parameters explain of the residual made white
    Eigen::VectorXd white;        // the residual, with its noise made white and the parameters' freedom taken out
    double unlikely;              // probability, beyond which it is no chance on any of the channels

    Examination(const NullModel& model, const Eigen::VectorXd& units, const PreparedTask& task,
                const std::vector<Regressor>& candidates)
        : null(model),
          scale(units),
          prepared(task),
          regressors(candidates),
          patient(model),
          whiteBasis(model.scores().white, model.channels),
          white(model.scores().white(model.scores().whiteResidual)),
          unlikely(whiteSignificance / (3 * static_cast<double>(model.channels.size()))) {}

    bool isChance(double p) const { return !(p < unlikely); }
};

/// The regressors as they enter through one channel alone (its rows), less their means.
Eigen::MatrixXd columnsThrough(const Examination& of, const ResidualChannel& channel) {
    const int count = channel.end - channel.begin;
    Eigen::MatrixXd columns(count, static_cast<Eigen::Index>(of.regressors.size()));
    for (std::size_t j = 0; j < of.regressors.size(); ++j) {
        const Eigen::VectorXd& series = of.regressors[j].series[static_cast<std::size_t>(channel.experiment)];
        double mean = 0;
        for (const int sample : channel.samples) mean += series[sample] / count;
        for (int row = 0; row < count; ++row)
            columns(row, static_cast<Eigen::Index>(j)) = series[channel.samples[static_cast<std::size_t>(row)]] - mean;
    }
    if (of.scale.size() > 0) columns = of.scale.segment(channel.begin, count).asDiagonal() * columns;
    return columns;
}

/// With what the residual of a channel moves, most first. `rest`: the regressors, white, beside the parameters;
/// `white`: the residual beside them.
std::vector<Correlate> correlates(const Examination& of, const ResidualChannel& channel, const Eigen::MatrixXd& rest,
                                  const Eigen::VectorXd& white, double total) {
    std::vector<Correlate> found;
    for (std::size_t j = 0; j < of.regressors.size(); ++j) {
        const auto c = rest.col(static_cast<Eigen::Index>(j));
        const double n = c.norm();
        // what hardly moves here (the sign of a temperature) moves with nothing
        if (!(n > leastMotion * of.regressors[j].series[static_cast<std::size_t>(channel.experiment)].norm())) continue;
        const double correlation = c.dot(white) / n / std::sqrt(total);
        if (std::abs(correlation) > leastCorrelation) found.push_back({of.regressors[j].variable, correlation});
    }
    std::sort(found.begin(), found.end(),
              [](const Correlate& a, const Correlate& b) { return std::abs(a.correlation) > std::abs(b.correlation); });
    if (found.size() > mostCorrelates) found.resize(mostCorrelates);
    return found;
}

/// What the channel of that place moves with.
void tellWhatMoves(const Examination& of, std::size_t place, Examined& e) {
    const Eigen::MatrixXd columns = columnsThrough(of, *e.channel);
    const ChannelRows through(of.whiteBasis, place);
    const Eigen::MatrixXd rest = through.rest(of.null.whitener.through(place, columns));
    const Eigen::VectorXd white = through(of.white);
    const Explained all = explainedBy(white, rest);
    const auto count = static_cast<int>(columns.rows());
    const double total = of.white.segment(e.channel->begin, count).squaredNorm();
    const auto directions = static_cast<int>(all.directions.cols());
    if (directions < 1 || count < 2 * directions + 10) return;
    e.explained = all.explained;
    e.directions = directions;
    e.movesWith = correlates(of, *e.channel, rest, white, total);
    e.pMoves = std::min(pWhitened(all, total, count), of.patient.p(place, columns, of.unlikely));
}

/// Empty: there is nothing to ask on this channel.
std::optional<Examined> examine(const Examination& of, std::size_t place) {
    const ResidualChannel& channel = of.null.channels[place];
    const Eigen::VectorXd& residuals = of.null.fit.optimum.residuals;
    if (quantisationStep(channel.measured) > 0 && isNoise(channel, residuals)) return std::nullopt;
    const int count = channel.end - channel.begin;
    const Eigen::VectorXd own = residuals.segment(channel.begin, count);
    if (own.norm() <= nothing * std::sqrt(static_cast<double>(count))) return std::nullopt;
    Examined e;
    e.channel = &channel;
    tellWhatMoves(of, place, e);
    e.summary = summarise(own);
    e.isWhite = of.isChance(e.summary.whiteProbability);
    const double scatter = std::sqrt((own.array() - own.mean()).square().mean());  // of less than the noise: none
    if ((e.isWhite || scatter <= 1) && standsOff(own))
        e.standsOff = std::pow(own.sum(), 2) / count - std::log(static_cast<double>(count));
    const double beyondChance = e.explained - e.directions * std::log(static_cast<double>(count));
    const bool isLittle =
        e.isWhite && std::max(beyondChance, -std::log(std::max(e.pMoves, 1e-300))) < leastBesideOthers;
    e.isNoise = e.standsOff == 0 && (isLittle || of.isChance(e.pMoves)) && (e.isWhite || isStationaryNoise(own));
    return e;
}

const FitExperiment& experimentOf(const Examination& of, const ResidualChannel& channel) {
    return of.prepared.problem.experiments[static_cast<std::size_t>(channel.experiment)];
}

const std::string& outputOf(const Examination& of, const ResidualChannel& channel) {
    return of.prepared.system->outputs()[static_cast<std::size_t>(channel.output)].name;
}

ColouredNoise noiseOf(const Examination& of, const Examined& e) {
    const ResidualChannel& channel = *e.channel;
    const FitExperiment& experiment = experimentOf(of, channel);
    const double span = experiment.inputs.time[static_cast<std::size_t>(channel.samples.back())] -
                        experiment.inputs.time[static_cast<std::size_t>(channel.samples.front())];
    return {outputOf(of, channel), experiment.name,
            e.summary.autocorrelationTime * span / (channel.end - channel.begin - 1)};
}

Remainder structureOf(const Examination& of, const Examined& e) {
    const double p = std::min(e.pMoves, e.summary.whiteProbability);
    const double count = e.channel->end - e.channel->begin;
    Remainder r;
    r.output = outputOf(of, *e.channel);
    r.experiment = experimentOf(of, *e.channel).name;
    r.evidence = std::max({e.explained - e.directions * std::log(count), -std::log(std::max(p, 1e-300)), e.standsOff});
    locate(of.null, of.prepared, *e.channel, r);
    r.movesWith = e.movesWith;
    return r;
}

/// `scale`: the units in which the residual of the model stands, one a row; empty: those of the noise throughout.
Leftovers leftoversIn(const NullModel& null, const Eigen::VectorXd& scale, const PreparedTask& prepared,
                      const std::vector<Regressor>& candidates) {
    const Examination of(null, scale, prepared, candidates);
    std::vector<Examined> examined;
    for (std::size_t c = 0; c < null.channels.size(); ++c)
        if (std::optional<Examined> e = examine(of, c)) examined.push_back(std::move(*e));
    const bool isAllNoise =
        std::all_of(examined.begin(), examined.end(), [](const Examined& e) { return e.isNoise; }) &&
        !isShared(null.channels, null.fit.optimum.residuals, of.white);
    Leftovers found;
    for (const Examined& e : examined) {
        if (e.isWhite && e.isNoise) continue;
        if (isAllNoise)
            found.noise.push_back(noiseOf(of, e));
        else if (Remainder r = structureOf(of, e); r.evidence > 0)
            found.structure.push_back(std::move(r));
    }
    std::stable_sort(found.structure.begin(), found.structure.end(),
                     [](const Remainder& a, const Remainder& b) { return a.evidence > b.evidence; });
    return found;
}

/// One over the noise near each sample; empty where it is even on all channels.
Eigen::VectorXd localScale(const NullModel& null, const PreparedTask& prepared, std::vector<UnevenNoise>& uneven) {
    Eigen::VectorXd scale = Eigen::VectorXd::Ones(null.fit.optimum.residuals.size());
    for (const ResidualChannel& c : null.channels) {
        const Eigen::VectorXd local = localNoise(null.fit.optimum.residuals.segment(c.begin, c.end - c.begin));
        if (local.size() == 0) continue;
        scale.segment(c.begin, c.end - c.begin) = local.cwiseInverse();
        uneven.push_back({prepared.system->outputs()[static_cast<std::size_t>(c.output)].name,
                          prepared.problem.experiments[static_cast<std::size_t>(c.experiment)].name,
                          local.maxCoeff() / local.minCoeff()});
    }
    return uneven.empty() ? Eigen::VectorXd() : scale;
}

}  // namespace

Leftovers leftovers(const NullModel& null, const SimulationOptions& simulation) {
    const Outcome<PreparedTask> prepared = prepareHeld(null.variant, {}, null.noise);
    if (!prepared) return {};
    const std::vector<Regressor> candidates = regressors(null, *prepared, simulation);
    Leftovers found = leftoversIn(null, {}, *prepared, candidates);
    if (found.structure.empty()) return found;
    std::vector<UnevenNoise> uneven;
    const Eigen::VectorXd scale = localScale(null, *prepared, uneven);
    if (scale.size() == 0) return found;
    FitResult scaled = null.fit;
    scaled.optimum.residuals = scale.cwiseProduct(null.fit.optimum.residuals);
    scaled.optimum.jacobian = scale.asDiagonal() * null.fit.optimum.jacobian;
    NullModel even = null.with(null.variant, std::move(scaled));
    even.whitener = Whitener(even.channels, even.fit.optimum.residuals);
    Leftovers within = leftoversIn(even, scale, *prepared, candidates);
    if (!within.structure.empty()) return found;
    within.uneven = std::move(uneven);
    return within;
}

}  // namespace analogon
