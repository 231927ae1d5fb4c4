#include "core/simulate/recorded_events.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/eval/event_parts.hpp"
#include "core/simulate/recorded_drive.hpp"

namespace analogon {
namespace {

/// One experiment of a system with events.
class RecordedEvents {
public:
    RecordedEvents(const SimulationTask& task, const SimulationOptions& options, const Progress& progress)
        : task_(task),
          progress_(progress),
          model_(task.system->events()->model),
          between_(*task.system->events()->between) {
        options_.start = task.inputs->time.front();
        options_.stop = task.inputs->time.back();
        options_.tolerance = options.relativeTolerance;
        options_.secondsLimit = options.wallClockLimit;
        for (const SignalInfo& p : between_.parameters()) parameterAt_.push_back(task.system->parameterIndex(p.name));
        for (const HybridModel::Output& o : model_.outputs)
            outputs_.push_back(
                {task.system->outputIndex(o.name), o.slot < 0 ? between_.outputIndex(o.name) : -1, o.slot});
        findStates();
        findObserved();
    }

    bool hasTangents() const { return model_.delays.empty(); }

    /// Tangents with the task's directions where they are wanted.
    void run(const std::vector<double>& parameters, bool withTangents, Trajectory& result) {
        std::optional<EventTangents> tangents;
        if (withTangents) tangents.emplace(model_, between_, directions(), slotAt(), readingAt());
        const int inputs = between_.inputCount();
        std::vector<int> inputAt, slopeAt;
        for (const SignalInfo& input : task_.system->inputs()) {
            inputAt.push_back(between_.inputIndex(input.name));
            slopeAt.push_back(inputAt.back() >= 0 && between_.needsInputDerivative() ? inputs + inputAt.back() : -1);
        }
        RecordedDrive drive{RecordedSignals(*task_.inputs, std::move(inputAt), std::move(slopeAt)), {}};
        for (std::size_t i = 0; i < parameterAt_.size(); ++i)
            drive.parameters.push_back(parameterAt_[i] >= 0 ? parameters[static_cast<std::size_t>(parameterAt_[i])]
                                                            : between_.parameters()[i].value);
        drive.tangents = tangents ? &*tangents : nullptr;
        drive.take = [&](int sample, const EventPoint& point, Workspace& workspace, const std::vector<double>& values) {
            return take(sample, point, workspace, values, drive.tangents, result);
        };
        result.failure = {};
        const Outcome<EventTrajectory> end = simulateRecorded(model_, between_, drive, options_, progress_);
        if (end) {
            for (const Diagnostic& remark : end->remarks) result.remarks.push_back(remark.message);
            return;
        }
        result.failure = {true, drive.reached, {}, "the events do not go on"};
        if (drive.isCancelled) result.failure.reason = "cancelled";
        if (drive.isTooLong) result.failure.reason = "time limit";
        if (!drive.isCancelled && !drive.isTooLong && !end.diagnostics().empty())
            result.failure.cause = end.diagnostics().front().message;
    }

private:
    struct Shown {
        int row{};       // of the system as seen from without
        int output{-1};  // of the system between the events
        int slot{-1};
    };

    std::vector<int> slotAt() const {
        std::vector<int> at;
        for (const std::string& slot : model_.slots) at.push_back(between_.parameterIndex(slot));
        return at;
    }
    std::vector<int> readingAt() const {
        std::vector<int> at;
        for (const std::string& reading : model_.readings) at.push_back(between_.outputIndex(reading));
        return at;
    }
    Eigen::MatrixXd directions() const {
        Eigen::MatrixXd d = Eigen::MatrixXd::Zero(between_.parameterCount(), task_.directions.cols());
        for (std::size_t i = 0; i < parameterAt_.size(); ++i)
            if (parameterAt_[i] >= 0) d.row(static_cast<Eigen::Index>(i)) = task_.directions.row(parameterAt_[i]);
        for (const int slot : slotAt())
            if (slot >= 0) d.row(slot).setZero();
        return d;
    }
    void findStates() {
        for (const SignalInfo& state : task_.system->states()) {
            const auto& inner = between_.states();
            const auto found =
                std::find_if(inner.begin(), inner.end(), [&](const SignalInfo& s) { return s.name == state.name; });
            stateAt_.push_back(found == inner.end() ? -1 : static_cast<int>(found - inner.begin()));
        }
    }
    void findObserved() {
        std::vector<std::string> names;
        for (const std::string& name : task_.observe) {
            const auto slot = std::find(model_.slots.begin(), model_.slots.end(), name);
            observedSlot_.push_back(slot == model_.slots.end() ? -1 : static_cast<int>(slot - model_.slots.begin()));
            names.push_back(name);
        }
        if (!names.empty()) handles_ = between_.observe(names);
    }

    bool take(int sample, const EventPoint& point, Workspace& workspace, const std::vector<double>& values,
              EventTangents* tangents, Trajectory& result) const {
        std::vector<double> y = values, dy;
        const Eigen::Index K = tangents ? tangents->count() : 0;
        if (tangents) {
            dy.resize(y.size() * static_cast<std::size_t>(K));
            if (!tangents->outputs(point, y, dy.data())) return false;
        }
        for (const Shown& shown : outputs_) {
            if (shown.row < 0) continue;
            const auto from = static_cast<std::size_t>(shown.slot >= 0 ? shown.slot : shown.output);
            result.outputs(shown.row, sample) = shown.slot >= 0 ? point.slots[from] : y[from];
            for (Eigen::Index k = 0; k < K; ++k) {
                const std::size_t at = from * static_cast<std::size_t>(K) + static_cast<std::size_t>(k);
                result.tangents[static_cast<std::size_t>(shown.row)](sample, k) =
                    shown.slot >= 0 ? tangents->slots()[at] : dy[at];
            }
        }
        for (std::size_t i = 0; task_.keepStates && i < stateAt_.size(); ++i)
            result.states(static_cast<Eigen::Index>(i), sample) =
                stateAt_[i] >= 0 ? point.x[static_cast<std::size_t>(stateAt_[i])] : 0;
        if (handles_.empty()) return true;
        std::vector<double> seen(handles_.size());
        if (!between_.observed(workspace, point.time, point.x, point.u, handles_, seen)) return false;
        for (std::size_t i = 0; i < seen.size(); ++i)
            result.observed(static_cast<Eigen::Index>(i), sample) =
                observedSlot_[i] >= 0 ? point.slots[static_cast<std::size_t>(observedSlot_[i])] : seen[i];
        return true;
    }

    const SimulationTask& task_;
    const Progress& progress_;
    const HybridModel& model_;
    const System& between_;
    EventRunOptions options_;
    std::vector<int> parameterAt_;  // by parameter of the system between: that of the system without; -1: none
    std::vector<int> stateAt_, observedSlot_, handles_;
    std::vector<Shown> outputs_;
};

/// Tangents by changes of a ten-thousandth of the parameters, to both sides.
void addDifferences(RecordedEvents& runs, const SimulationTask& task, Trajectory& result) {
    constexpr double part = 1e-4;
    for (Eigen::Index k = 0; k < task.directions.cols() && !result.failure.failed; ++k) {
        double scale = 0;
        for (Eigen::Index i = 0; i < task.directions.rows(); ++i)
            if (const double along = std::fabs(task.directions(i, k)); along > 0)
                scale = std::max(scale, std::fabs(task.parameters[static_cast<std::size_t>(i)]) / along);
        const double h = part * (scale > 0 ? scale : 1);
        Trajectory up = result, down = result;
        const auto moved = [&](double by, Trajectory& to) {
            std::vector<double> parameters = task.parameters;
            for (std::size_t i = 0; i < parameters.size(); ++i)
                parameters[i] += by * task.directions(static_cast<Eigen::Index>(i), k);
            runs.run(parameters, false, to);
            if (to.failure.failed) result.failure = to.failure;
        };
        moved(h, up);
        moved(-h, down);
        for (std::size_t o = 0; o < result.tangents.size(); ++o)
            result.tangents[o].col(k) =
                (up.outputs.row(static_cast<Eigen::Index>(o)) - down.outputs.row(static_cast<Eigen::Index>(o)))
                    .transpose() /
                (2 * h);
    }
}

}  // namespace

void runWithEvents(const SimulationTask& task, const SimulationOptions& options, const Progress& progress,
                   Trajectory& result) {
    RecordedEvents runs(task, options, progress);
    const bool isAsked = task.directions.cols() > 0;
    runs.run(task.parameters, isAsked && runs.hasTangents(), result);
    if (isAsked && !runs.hasTangents()) addDifferences(runs, task, result);
}

}  // namespace analogon
