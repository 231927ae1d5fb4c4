#include "core/effect/judge/caution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/median.hpp"
#include "core/base/range.hpp"
#include "core/base/unit.hpp"
#include "core/effect/model/sampling.hpp"
#include "core/effect/reading/faulty_sample.hpp"
#include "core/effect/reading/start_value.hpp"
#include "core/effect/thresholds.hpp"
#include "core/residual/noise.hpp"

namespace analogon {

using namespace threshold::caution;
using threshold::acceptance::farMore;
using threshold::heldValue::otherValue;
using threshold::judgement::leastOfRest;
using threshold::noise::moreThanChance;

namespace {

Range rangeIn(const Recording& recording, const std::vector<std::string>& names, const Eigen::MatrixXd& values,
              const std::string& name) {
    const auto at = std::find(names.begin(), names.end(), name);
    if (at == names.end() || values.cols() != static_cast<Eigen::Index>(recording.time.size())) return {};
    return rangeOf(values.row(at - names.begin()));
}

/// Whether a parameter that the data determine would have two values that differ and that it may have.
bool isTwoValues(const NullModel& null, const FitEstimate& estimate, double one, double other) {
    const double largest = std::max(std::abs(one), std::abs(other));
    if (!std::isfinite(estimate.standardError) || !(std::abs(one - other) > otherValue * largest)) return false;
    const std::vector<FitParameter>& parameters = null.variant.task.parameters;
    const auto own = std::find_if(parameters.begin(), parameters.end(),
                                  [&](const FitParameter& p) { return p.name == estimate.name; });
    const auto isAllowed = [&](double value) {
        return own == parameters.end() || (value >= own->min && value <= own->max);
    };
    return isAllowed(one) && isAllowed(other);
}

/// Rows of one experiment of a column; the rest 0.
Eigen::VectorXd within(const NullModel& null, int experiment, const Eigen::VectorXd& column) {
    Eigen::VectorXd part = Eigen::VectorXd::Zero(column.size());
    for (const ResidualChannel& c : null.channels)
        if (c.experiment == experiment)
            part.segment(c.begin, c.end - c.begin) = column.segment(c.begin, c.end - c.begin);
    return part;
}

}  // namespace

std::vector<Text> extrapolations(const EstimationTask& task) {
    std::vector<Text> said;
    for (const Recording& checked : task.recordings) {
        if (checked.role != Role::Validate) continue;
        const auto look = [&](const auto& side, const std::string& name, const auto& rangeOfIts) {
            Range fitted;
            for (const Recording& r : task.recordings) {
                if (r.role != Role::Fit) continue;
                if (const Range own = rangeOfIts(r, name); own.width() > 0) fitted.take(own);
            }
            const Range own = rangeOfIts(checked, name);
            if (!(fitted.width() > 0) || own.isEmpty()) return;
            const double beyond = std::max(own.high - fitted.high, fitted.low - own.low) / fitted.width();
            if (beyond > hardlyMoved)
                said.push_back(
                    phrase("the fitted recordings hold {} near {:.4g}, '{}' has it between {:.4g} and {:.4g}: what the "
                           "model says of that is extrapolated",
                           side(name), 0.5 * (fitted.low + fitted.high), checked.name, own.low, own.high));
            else if (beyond > worthSaying)
                said.push_back(
                    phrase("'{}' leaves the range of the fitted recordings on {} by {:.0f} % of that range: "
                           "what the model says there is extrapolated",
                           checked.name, side(name), 100 * beyond));
        };
        for (const std::string& name : checked.inputNames)
            look([](const std::string& n) { return phrase("input {}", n); }, name,
                 [](const Recording& r, const std::string& n) { return rangeIn(r, r.inputNames, r.inputs, n); });
        for (const std::string& name : checked.outputNames)
            look([](const std::string& n) { return phrase("output {}", n); }, name,
                 [](const Recording& r, const std::string& n) { return rangeIn(r, r.outputNames, r.outputs, n); });
    }
    return said;
}

std::vector<Text> driftBetweenRecordings(const NullModel& null) {
    const std::vector<int> recordings = recordingsOf(null.variant.task, Role::Fit);
    if (recordings.size() < 2) return {};
    const Eigen::MatrixXd& jacobian = null.fit.optimum.jacobian;
    const Eigen::VectorXd& residual = null.fit.optimum.residuals;
    const double excess = residual.squaredNorm() - static_cast<double>(residual.size());
    const OrthogonalProjector complement(jacobian);
    struct Drift {
        double explained{}, before{}, after{};
        std::string parameter, recording;
    } best;
    for (std::size_t e = 0; e < recordings.size(); ++e)
        for (Eigen::Index j = 0; j < jacobian.cols(); ++j) {
            const FitEstimate& estimate = null.fit.estimates[static_cast<std::size_t>(j)];
            if (estimate.experiment >= 0) continue;  // a start value
            const Eigen::VectorXd column = within(null, static_cast<int>(e), jacobian.col(j));
            const ColumnScore score = scoreColumns(complement, residual, column, false);
            if (!(score.visible > leastVisible) || !(score.explained > best.explained)) continue;
            const double step = score.strengths[0];
            const double elsewhere = estimate.value - step * complement.coefficients(column)[j];
            if (!isTwoValues(null, estimate, elsewhere, elsewhere + step)) continue;
            best = {score.explained, elsewhere, elsewhere + step, estimate.name,
                    null.variant.task.recordings[static_cast<std::size_t>(recordings[e])].name};
        }
    if (!(best.explained > farMore) || !(best.explained > leastOfRest * excess)) return {};
    return {
        phrase("{} seems to be another one in '{}' (about {:.4g}) than in the other recordings (about {:.4g}): "
               "was the component, or its condition, the same?",
               best.parameter, best.recording, best.after, best.before)};
}

namespace {

/// What a validation recording shows of one output, sample by sample where it was measured.
struct Miss {
    Eigen::VectorXd simulated, measured;
    double uncertain{};  // mean square of what the uncertain parameters leave open

    explicit Miss(const OutputState& output) {
        std::vector<Eigen::Index> there;
        for (Eigen::Index k = 0; k < output.measured.size(); ++k)
            if (std::isfinite(output.measured[k]) && std::isfinite(output.simulated[k])) there.push_back(k);
        simulated = output.simulated(there);
        measured = output.measured(there);
        if (output.deviation.size() == output.measured.size() && !there.empty())
            uncertain = output.deviation(there).squaredNorm() / static_cast<double>(there.size());
    }
    double count() const { return static_cast<double>(measured.size()); }
    Eigen::VectorXd residual() const { return measured - simulated; }
    double offset() const { return residual().mean(); }
    double gain() const { return measured.dot(simulated) / simulated.squaredNorm(); }
    double rms() const { return residual().norm() / std::sqrt(count()); }
    double rmsBesideOffset() const { return (residual().array() - offset()).matrix().norm() / std::sqrt(count()); }
    double rmsBesideGain() const { return (measured - gain() * simulated).norm() / std::sqrt(count()); }
};

/// Whether a miss is more than noise of this standard deviation and than the parameters leave open: not louder noise,
/// but one side or with a structure.
bool isMoreThanNoise(const Miss& miss, double noise, double correlated) {
    const double ratio = miss.rms() * miss.rms() / (noise * noise);
    const double independent = miss.count() / std::max(1.0, correlated);
    const double byChance = 1.0 + moreThanChance * std::sqrt(2.0 / independent);
    const double byParameters = moreThanChance * moreThanChance * miss.uncertain / (noise * noise);
    if (!(ratio > std::max(clearlyWorse * clearlyWorse, byChance) + byParameters)) return false;
    const bool isOneSided = std::abs(miss.offset()) > moreThanChance * miss.rms() / std::sqrt(independent);
    return isOneSided || summarise(miss.residual()).whiteProbability < whiteSignificance;
}

/// What the miss looks like: the simplest that leaves about as little as there is in the fitted recordings.
Text lookOf(const Miss& miss, double noise, const std::string& unit) {
    const double enough = asGood * std::sqrt(noise * noise + miss.uncertain);
    const std::string shown = behindNumber(unit);
    const double offset = miss.rmsBesideOffset(), gain = miss.rmsBesideGain();
    if (offset <= enough && offset <= gain)
        return phrase("it looks like an offset of {:+.3g}{} in this recording alone ({:.3g}{} remain without it)",
                      miss.offset(), shown, offset, shown);
    if (gain <= enough)
        return phrase("it looks like a gain of {:.4g} in this recording alone ({:.3g}{} remain without it)",
                      miss.gain(), gain, shown);
    return phrase(
        "neither an offset ({:+.3g}{} at best, {:.3g}{} remain) nor a gain ({:.4g}, {:.3g}{} remain) accounts for it: "
        "this recording shows what the fitted ones do not",
        miss.offset(), shown, offset, shown, miss.gain(), gain, shown);
}

/// Calls f(experiment, output, miss, noise) for each output of a validation recording that the model misses.
template <class F>
void eachMissed(const ModelState& state, const F& f) {
    for (const ExperimentState& e : state.experiments) {
        if (e.role != Role::Validate || e.failure.failed) continue;
        for (const OutputState& output : e.outputs) {
            const auto fitted = state.residual.find(output.name);
            const Miss miss(output);
            if (fitted == state.residual.end() || miss.count() < 3) continue;
            const double noise = fitted->second.standardDeviation;
            if (noise > 0 && isMoreThanNoise(miss, noise, fitted->second.autocorrelationTime))
                f(e, output, miss, noise);
        }
    }
}

}  // namespace

std::vector<Text> poorValidations(const ModelState& state) {
    std::vector<Text> said;
    eachMissed(state, [&](const ExperimentState& e, const OutputState& output, const Miss& miss, double noise) {
        said.push_back(
            phrase("'{}': {} is off by {:.3g}{}{} (root mean square), {:.2g} times what is left in "
                   "the fitted recordings; {}",
                   e.name, output.name, miss.rms(), output.unit.empty() ? "" : " ", output.unit, miss.rms() / noise,
                   lookOf(miss, noise, output.unit)));
    });
    return said;
}

std::vector<std::string> missedRecordings(const ModelState& state) {
    std::vector<std::string> names;
    eachMissed(state, [&](const ExperimentState& e, const OutputState&, const Miss&, double) {
        if (names.empty() || names.back() != e.name) names.push_back(e.name);
    });
    return names;
}

std::vector<Text> wrongStarts(const ModelState& state, Role role) {
    std::vector<Text> said;
    int fitted = -1;  // number of the experiment among those that are fitted
    for (const ExperimentState& e : state.experiments) {
        if (e.role == Role::Fit) ++fitted;
        if (e.role != role || e.failure.failed) continue;
        const bool hasOwn =
            !e.starts.empty() ||
            (role == Role::Fit && std::any_of(state.parameters.begin(), state.parameters.end(),
                                              [&](const FitEstimate& p) { return p.experiment == fitted; }));
        for (const OutputState& output : e.outputs) {
            if (!beginsElsewhere(output, state)) continue;
            const std::string unit = output.unit.empty() ? "" : " " + output.unit;
            const Text begins = phrase("'{}' begins with {} at {:.4g}{} where the model begins at {:.4g}{}", e.name,
                                       output.name, output.measured[0], unit, output.simulated[0], unit);
            said.push_back(hasOwn ? phrase("{}, though a start value is fitted there: another one may be wrong, that "
                                           "of a part which an effect has added, too",
                                           begins)
                                  : phrase("{}: tell its start value, or fit it (\"initial\")", begins));
        }
    }
    return said;
}

std::vector<Text> stuckReadings(const EstimationTask& task) {
    std::vector<Text> said;
    for (const Recording& r : task.recordings) {
        if (r.role != Role::Fit) continue;
        for (Eigen::Index o = 0; o < r.outputs.rows(); ++o) {
            const Eigen::VectorXd y = r.outputs.row(o).transpose();
            const Range range = rangeOf(y);
            for (const auto& [begin, end] : runsAlike(y)) {
                const std::string& name = r.outputNames[static_cast<std::size_t>(o)];
                const double value = y[begin], from = r.time[static_cast<std::size_t>(begin)],
                             to = r.time[static_cast<std::size_t>(end - 1)];
                said.push_back(
                    value < range.high && value > range.low
                        ? phrase("output '{}' of '{}' reads {:.5g} from {:.4g} s to {:.4g} s without any change, and "
                                 "hardly ever twice the same elsewhere: did the sensor or the logger stick?",
                                 name, r.name, value, from, to)
                        : phrase("output '{}' of '{}' reads {:.5g} from {:.4g} s to {:.4g} s without any change, and "
                                 "never goes beyond: does the range of the sensor or the logger end there?",
                                 name, r.name, value, from, to));
            }
        }
    }
    return said;
}

namespace {

/// Whether any input runs on straight lines between its samples.
bool joinsSamples(const EstimationTask& task) {
    return std::any_of(task.recordings.begin(), task.recordings.end(), [](const Recording& r) {
        return std::any_of(r.inputNames.begin(), r.inputNames.end(), [&](const auto& name) { return !r.isHeld(name); });
    });
}

}  // namespace

std::vector<Text> delaysInSamples(const EstimationTask& task, const std::vector<AddedEffect>& effects) {
    const double interval = samplingInterval(task);
    if (!(interval > 0)) return {};
    std::vector<Text> said;
    for (const AddedEffect& effect : effects) {
        if (!effect.kind.ends_with(".delay") || effect.parameters.empty()) continue;
        const double delay = effect.parameters.front().value;
        if (delay > threshold::prediction::mostSamplesOfDelay * interval)
            said.push_back(
                phrase("the dead time of {:.3g} s at {} is {:.2g} samples long: what is stored (in a mass, by a "
                       "lag) comes late as well, and smoothed; a step of the input tells which of them it is",
                       delay, effect.at, delay / interval));
        if (!(delay < interval)) continue;
        const bool isHeld =
            effect.kind.starts_with("actuator") && std::abs(delay / interval - 0.5) < 0.25 && joinsSamples(task);
        const Text reason =
            isHeld ? phrase(
                         "a command that is held between its samples looks like half a sample of dead time, since "
                         "inputs run linearly between theirs here")
                   : phrase("when exactly within the interval each channel was sampled may be all there is to it");
        said.push_back(phrase("the dead time of {:.3g} s at {} is {:.2g} of a sample interval ({:.3g} s): {}", delay,
                              effect.at, delay / interval, interval, reason));
    }
    return said;
}

bool anyOutputMoves(const EstimationTask& task) {
    constexpr double rounding = 1e-12;
    std::map<std::string, Range> ranges;  // over all recordings: levels that differ tell something, too
    for (const Recording& r : task.recordings) {
        if (r.role != Role::Fit) continue;
        for (Eigen::Index o = 0; o < r.outputs.rows(); ++o)
            if (!(o < r.weights.size()) || r.weights[o] > 0)
                ranges[r.outputNames[static_cast<std::size_t>(o)]].take(rangeOf(r.outputs.row(o)));
    }
    return std::any_of(ranges.begin(), ranges.end(), [](const auto& named) {
        const Range& range = named.second;
        return range.width() > rounding * std::max(std::abs(range.low), std::abs(range.high));
    });
}

Text nothingMoves(const EstimationTask& task, const ModelState& state) {
    if (anyOutputMoves(task)) return {};
    std::vector<std::string> values;
    for (const ExperimentState& e : state.experiments)
        for (const OutputState& o : e.outputs) {
            if (e.role != Role::Fit) continue;
            const std::string value =
                fmt::format("{} = {:.5g}{}", o.name, rangeOf(o.measured).high, behindNumber(o.unit));
            if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
        }
    constexpr std::size_t shown = 5;
    if (values.size() > shown) values.erase(values.begin() + shown, values.end());
    return phrase(
        "nothing can be judged: no measured output moves in the fitted recordings ({}), and what stands still tells "
        "neither parameters nor effects",
        listed(values));
}

Text tooFewSamples(const NullModel& null) {
    // the shortest straight trend, or step, that the test for whiteness tells from noise (whiteSignificance)
    constexpr int fewestValues = 15;
    int samples = 0, longest = 0;
    for (const ResidualChannel& channel : null.channels) {
        const int count = channel.end - channel.begin;
        samples += count;
        longest = std::max(longest, count);
    }
    const int fitted = static_cast<int>(null.fit.optimum.jacobian.cols());
    if (longest >= fewestValues && samples - fitted >= fewestValues) return {};
    return phrase(
        "too few samples to judge: {} samples, {} parameters; structure is told from noise where an output has "
        "{} samples and there are as many beyond the parameters",
        samples, fitted, fewestValues);
}

std::vector<Text> boundHits(const FitResult& fit) {
    std::vector<Text> said;
    for (const FitEstimate& e : fit.estimates)
        if (e.atBound)
            said.push_back(
                phrase("{} rests at a bound ({:.4g}{}{}): the bound is too narrow, or the model lacks "
                       "something that the parameter stands in for",
                       e.name, e.value, e.unit.empty() ? "" : " ", e.unit));
    return said;
}

}  // namespace analogon
