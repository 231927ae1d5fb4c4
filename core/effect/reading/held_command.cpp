#include "core/effect/reading/held_command.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/range.hpp"
#include "core/effect/model/model_state.hpp"
#include "core/effect/model/sampling.hpp"
#include "core/effect/thresholds.hpp"
#include "core/fit/clock.hpp"

namespace analogon {

using namespace threshold::heldCommand;
using threshold::likely::mostInputs;

namespace {

constexpr double sameValue = 1e-9;  // of the range, within which a column stays where it is: rounding

/// Inputs that are joined by straight lines and change at all, in the order of the first fitted recording.
std::vector<std::string> inputsOnLines(const EstimationTask& task) {
    std::vector<std::string> inputs;
    for (const Recording& r : task.recordings) {
        if (r.role != Role::Fit) continue;
        for (Eigen::Index i = 0; i < r.inputs.rows(); ++i) {
            const std::string& name = r.inputNames[static_cast<std::size_t>(i)];
            if (!r.isHeld(name) && rangeOf(r.inputs.row(i)).width() > 0 &&
                std::find(inputs.begin(), inputs.end(), name) == inputs.end())
                inputs.push_back(name);
        }
    }
    return inputs;
}

/// Calls `use` with the row of each of these inputs in the fitted recordings.
template <class Use>
void forEach(EstimationTask& task, const std::vector<std::string>& inputs, Use use) {
    for (Recording& r : task.recordings.edit())
        for (Eigen::Index i = 0; i < r.inputs.rows(); ++i) {
            const std::string& name = r.inputNames[static_cast<std::size_t>(i)];
            if (std::find(inputs.begin(), inputs.end(), name) != inputs.end()) use(r, i);
        }
}

bool looksHeld(EstimationTask task, const std::string& input) {
    bool isAny = false, areAll = true;
    forEach(task, {input}, [&](const Recording& r, Eigen::Index row) {
        if (r.role != Role::Fit || !(rangeOf(r.inputs.row(row)).width() > 0)) return;
        isAny = true;
        areAll = areAll && analogon::looksHeld(r.inputs.row(row).transpose());
    });
    return isAny && areAll;
}

/// Whether the outputs move so fast that half a sample of the inputs may explain what is asked for: it moves them by
/// no more than half of what they move from sample to sample.
bool isMovedBySamples(const NullModel& onLines) {
    const double asked = (1 - std::sqrt(muchLess)) * std::sqrt(onLines.sumOfSquares());
    const std::vector<int> fitted = recordingsOf(onLines.variant.task, Role::Fit);
    double squares = 0;
    for (const ResidualChannel& c : onLines.channels) {
        const auto e = static_cast<std::size_t>(c.experiment);
        if (e >= onLines.fit.optimum.trajectories.size()) return true;
        const Eigen::VectorXd& noise = onLines.noise.at(static_cast<std::size_t>(fitted.at(e)));
        const Eigen::MatrixXd& y = onLines.fit.optimum.trajectories[e].outputs;
        const Eigen::Index last = y.cols() - 1;
        const auto row = y.row(c.output);
        squares += (row.tail(last) - row.head(last)).squaredNorm() / (noise[c.output] * noise[c.output]);
    }
    return !(0.5 * std::sqrt(squares) < 0.8 * asked);
}

class Readings {
public:
    Readings(const NullModel& onLines, const FitOptions& options, const Progress& progress)
        : onLines_(onLines),
          options_(options),
          progress_(progress),
          interval_(samplingInterval(onLines.variant.task)),
          complement_(onLines.fit.optimum.jacobian) {}

    Variant held(const std::vector<std::string>& inputs) const {
        Variant variant = onLines_.variant;
        holdInputs(variant.task, inputs);
        return variant;
    }
    /// On lines, but this part of a sample later.
    Variant later(const std::vector<std::string>& inputs, double part) const {
        Variant variant = onLines_.variant;
        forEach(variant.task, inputs, [&](Recording& r, Eigen::Index row) {
            const Eigen::RowVectorXd column = r.inputs.row(row);
            r.inputs.row(row) = onLinesAt(r.time, column, -part * interval_);
        });
        return variant;
    }

    std::optional<FitResult> fitted(const Variant& variant) const {
        if (progress_.stopRequested()) return std::nullopt;
        return fitBeside(onLines_, variant, options_, progress_);
    }
    double squares(const std::optional<FitResult>& fit) const {
        const bool isWhole = fit && fit->optimum.residuals.size() == onLines_.fit.optimum.residuals.size();
        return isWhole ? fit->optimum.residuals.squaredNorm() : std::numeric_limits<double>::infinity();
    }

    /// Squares that are left, the parameters following along their tangents: one simulation.
    double promised(const Variant& variant) const {
        constexpr double none = std::numeric_limits<double>::infinity();
        const Outcome<PreparedTask> prepared = prepareHeld(variant, {}, onLines_.noise);
        if (!prepared || progress_.stopRequested()) return none;
        const Linearisation l = linearise(prepared->problem, {}, false, {}, options_.simulation, progress_);
        const bool isWhole = l.ok && l.residuals.size() == onLines_.fit.optimum.residuals.size();
        return isWhole && l.residuals.allFinite() ? complement_(l.residuals).squaredNorm() : none;
    }

    /// Squares that are left on lines where one output is measured late, of all outputs and of delays up to two samples
    /// the least, the parameters following along their tangents. Another output that is late as well would be the
    /// input.
    double squaresWithALateOutput() const {
        double least = std::numeric_limits<double>::infinity();
        const Linearisation& optimum = onLines_.fit.optimum;
        for (int output = 0; output < static_cast<int>(onLines_.noise.front().size()); ++output)
            for (const double samples : {0.25, 0.5, 0.75, 1.0, 1.5, 2.0}) {
                Eigen::VectorXd residuals = optimum.residuals;
                Eigen::MatrixXd jacobian = optimum.jacobian;
                for (const ResidualChannel& c : onLines_.channels)
                    if (c.output == output) delay(c, samples, residuals, jacobian);
                least = std::min(least, OrthogonalProjector(jacobian)(residuals).squaredNorm());
            }
        return least;
    }

private:
    /// What a channel leaves, and its slopes, where it shows the model so many samples late. A row whose predecessors
    /// were not measured stays as it is.
    void delay(const ResidualChannel& c, double samples, Eigen::VectorXd& residuals, Eigen::MatrixXd& jacobian) const {
        const auto whole = static_cast<int>(samples);
        const double part = samples - whole;
        const Eigen::MatrixXd& slopes = onLines_.fit.optimum.jacobian;
        const Eigen::VectorXd simulated =
            onLines_.fit.optimum.residuals.segment(c.begin, c.measured.size()) + c.measured;
        for (int i = whole + 1; i < c.end - c.begin; ++i) {
            const int sample = c.samples[static_cast<std::size_t>(i)], row = c.begin + i;
            if (c.samples[static_cast<std::size_t>(i - whole - 1)] != sample - whole - 1) continue;
            residuals[row] = (1 - part) * simulated[i - whole] + part * simulated[i - whole - 1] - c.measured[i];
            jacobian.row(row) = (1 - part) * slopes.row(row - whole) + part * slopes.row(row - whole - 1);
        }
    }

    const NullModel& onLines_;
    const FitOptions& options_;
    const Progress& progress_;
    double interval_{};
    OrthogonalProjector complement_;
};

}  // namespace

bool looksHeld(const Eigen::VectorXd& column) {
    const double range = rangeOf(column).width();
    if (!(range > 0)) return false;
    const Eigen::Index steps = column.size() - 1;
    const auto moves = [&](Eigen::Index k) {
        return k >= 0 && k < steps && std::abs(column[k + 1] - column[k]) > sameValue * range;
    };
    int jumps = 0, single = 0, moving = 0;
    for (Eigen::Index k = 0; k < steps; ++k) {
        if (!moves(k)) continue;
        ++moving;
        if (std::abs(column[k + 1] - column[k]) < leastJump * range) continue;
        ++jumps;
        if (!moves(k - 1) && !moves(k + 1)) ++single;
    }
    return jumps >= fewestJumps && 2 * moving <= steps && single >= alone * moving;
}

bool anyLooksHeld(const EstimationTask& task) {
    const std::vector<std::string> inputs = inputsOnLines(task);
    return std::any_of(inputs.begin(), inputs.end(), [&](const std::string& input) { return looksHeld(task, input); });
}

std::vector<std::string> inputsToAsk(const EstimationTask& task) {
    if (fittedSamples(task) > mostSamples) return {};
    std::vector<std::string> inputs = inputsOnLines(task);
    if (inputs.size() > mostInputs) inputs.resize(mostInputs);
    return inputs;
}

bool isPromising(double promised, double onLines) { return promised < promising * onLines; }

bool isBetterThanDelay(double held, double delayed, bool looksSo) {
    return held < (looksSo ? likeHalf : betterThanHalf) * delayed;
}

std::optional<HeldReading> heldReading(const NullModel& onLines, const FitOptions& options, const Progress& progress) {
    const EstimationTask& task = onLines.variant.task;
    const std::vector<std::string> inputs = inputsToAsk(task);
    const bool isSettled = onLines.fit.optimum.ok && onLines.fit.optimum.jacobian.allFinite();
    if (progress.stopRequested() || inputs.empty() || !isSettled || !isMovedBySamples(onLines) || isNoise(onLines))
        return std::nullopt;

    std::vector<std::vector<std::string>> groups;
    std::vector<std::string> shaped;
    for (const std::string& input : inputs)
        if (looksHeld(task, input)) shaped.push_back(input);
    for (const std::string& input : inputs) groups.push_back({input});
    if (shaped.size() > 1) groups.push_back(shaped);

    const Readings readings(onLines, options, progress);
    const double squares = onLines.sumOfSquares();
    const std::vector<std::string>* best{};
    std::optional<FitResult> bestFit;
    for (const std::vector<std::string>& group : groups) {
        const bool isShaped = std::find(shaped.begin(), shaped.end(), group.front()) != shaped.end();
        const Variant variant = readings.held(group);
        if (!isShaped && !isPromising(readings.promised(variant), squares)) continue;
        std::optional<FitResult> fit = readings.fitted(variant);
        const double least = best ? readings.squares(bestFit) / (group.size() > 1 ? 1.1 : 1.0) : muchLess * squares;
        if (!(readings.squares(fit) < least)) continue;
        best = &group;
        bestFit = std::move(fit);
    }
    if (!best) return std::nullopt;
    const double left = readings.squares(bestFit);
    const bool isShaped = std::find(shaped.begin(), shaped.end(), best->front()) != shaped.end();
    const double asHalf = readings.squares(readings.fitted(readings.later(*best, 0.5)));
    if (!isBetterThanDelay(left, asHalf, isShaped)) return std::nullopt;
    if (!(left < readings.squares(readings.fitted(readings.later(*best, 1))))) return std::nullopt;
    if (!isBetterThanDelay(left, readings.squaresWithALateOutput(), isShaped)) return std::nullopt;
    Variant held = readings.held(*best);
    held.values = valuesOf(*bestFit);
    const Outcome<ModelState> state = stateOf(held, *bestFit, options.simulation, progress, Detail::Errors);
    if (!state || progress.stopRequested()) return std::nullopt;
    return HeldReading{*best, errorPercentOf(*state, Role::Fit), asHalf < likeHalf * left};
}

void holdInputs(EstimationTask& task, const std::vector<std::string>& inputs) {
    forEach(task, inputs, [](Recording& r, Eigen::Index row) {
        const std::string& name = r.inputNames[static_cast<std::size_t>(row)];
        if (!r.isHeld(name)) r.held.push_back(name);
    });
}

std::vector<Text> heldRemarks(const EstimationTask& task, const HeldReading& reading, double errorOnLines,
                              bool isReckonedWith) {
    std::vector<Text> remarks;
    for (const std::string& input : reading.inputs) {
        std::string mapping = "{\"column\": …, \"interpolation\": \"hold\"}";
        for (const Recording& r : task.recordings)
            if (const auto known = r.asHeld.find(input); known != r.asHeld.end()) mapping = known->second;
        const Text found =
            reading.isLikeDeadTime
                ? phrase(
                      "the input '{}' is held between its samples by what the outputs say, or reaches the component "
                      "half a sample late, which looks nearly the same, and the study joins them by straight lines: "
                      "held, a fit leaves an error of {:.2f} %, on straight lines one of {:.2f} %",
                      input, reading.errorPercent, errorOnLines)
                : phrase(
                      "the input '{}' is held between its samples by what the outputs say, and the study joins them "
                      "by straight lines: held, a fit leaves an error of {:.2f} %, on straight lines one of {:.2f} %",
                      input, reading.errorPercent, errorOnLines);
        const Text remedy = phrase(
            "write \"{}\": {} under \"inputs\" of the study (in the window: the menu of the input "
            "among the measurements)",
            input, mapping);
        remarks.push_back(isReckonedWith ? phrase("{}; all that is told here is with it held: {}", found, remedy)
                                         : phrase("{}; {}", found, remedy));
    }
    return remarks;
}

}  // namespace analogon
