#include "core/effect/reading/input_clock.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <iterator>
#include <limits>
#include <set>

#include "core/base/range.hpp"
#include "core/effect/model/sampling.hpp"
#include "core/effect/thresholds.hpp"
#include "core/fit/clock.hpp"
#include "core/fit/held_input.hpp"

namespace analogon {

using namespace threshold::inputClock;
using threshold::likely::mostInputs;

namespace {

constexpr double reach[] = {0.25, 0.5, 1, 1.5, 2, 3, 4, 6, 8, 12, 16};  // of the sampling interval
constexpr int bitsOfAnOffset = 10;

/// What a model leaves with inputs that are late by so much, its parameters following along their tangents.
class ClockModel {
public:
    ClockModel(const NullModel& null, const std::vector<Recording>& stamped, const SimulationOptions& simulation,
               const Progress& progress)
        : null_(null),
          stamped_(stamped),
          simulation_(simulation),
          progress_(progress),
          prepared_(prepareHeld(null.variant, {}, null.noise)),
          complement_(null.fit.optimum.jacobian) {}

    double misfit(const std::vector<InputClock>& clocks) {
        constexpr double none = std::numeric_limits<double>::infinity();
        if (!prepared_ || progress_.stopRequested()) return none;
        std::vector<Recording> recordings = null_.variant.task.recordings;
        setClocks(recordings, stamped_, clocks);
        FitProblem& problem = prepared_->problem;
        for (std::size_t e = 0; e < problem.experiments.size(); ++e)
            setSignals(problem.experiments[e], recordings[static_cast<std::size_t>(prepared_->fitRecordings[e])]);
        const Linearisation l = linearise(problem, {}, false, {}, simulation_, progress_);
        if (!l.ok || l.residuals.size() != null_.fit.optimum.residuals.size() || !l.residuals.allFinite()) return none;
        return complement_(l.residuals).squaredNorm();
    }

private:
    const NullModel& null_;
    const std::vector<Recording>& stamped_;
    const SimulationOptions& simulation_;
    const Progress& progress_;
    Outcome<PreparedTask> prepared_;
    OrthogonalProjector complement_;
};

/// The inputs of the model as recorded that change at all.
std::vector<std::string> changingInputs(const EstimationTask& task, const std::vector<Recording>& stamped) {
    std::vector<std::string> names;
    for (std::size_t r = 0; r < stamped.size(); ++r) {
        if (task.recordings[r].role != Role::Fit) continue;
        for (Eigen::Index i = 0; i < stamped[r].inputs.rows(); ++i) {
            const std::string& name = stamped[r].inputNames[static_cast<std::size_t>(i)];
            if (rangeOf(stamped[r].inputs.row(i)).width() > 0 &&
                std::find(names.begin(), names.end(), name) == names.end())
                names.push_back(name);
        }
    }
    return names;
}

/// The offsets of all inputs when these ones are late by so much.
std::vector<InputClock> with(std::vector<InputClock> clocks, const std::vector<std::string>& inputs, double late) {
    std::erase_if(
        clocks, [&](const InputClock& c) { return std::find(inputs.begin(), inputs.end(), c.input) != inputs.end(); });
    for (const std::string& input : inputs)
        if (late > 0) clocks.push_back({input, late});
    return clocks;
}

std::vector<double> delayedBy(std::vector<double> time, double late) {
    for (double& t : time) t += late;
    return time;
}

}  // namespace

void setClocks(std::vector<Recording>& recordings, const std::vector<Recording>& stamped,
               const std::vector<InputClock>& clocks) {
    for (std::size_t r = 0; r < std::min(recordings.size(), stamped.size()); ++r) {
        const Recording& from = stamped[r];
        for (std::size_t i = 0; i < from.inputNames.size(); ++i) {
            const auto own =
                std::find(recordings[r].inputNames.begin(), recordings[r].inputNames.end(), from.inputNames[i]);
            if (own == recordings[r].inputNames.end()) continue;
            const auto clock = std::find_if(clocks.begin(), clocks.end(),
                                            [&](const InputClock& c) { return c.input == from.inputNames[i]; });
            const Eigen::RowVectorXd column = from.inputs.row(static_cast<Eigen::Index>(i));
            const bool isLate = clock != clocks.end() && clock->late != 0 && from.time.size() > 1;
            recordings[r].inputs.row(own - recordings[r].inputNames.begin()) =
                !isLate                           ? column
                : from.isHeld(from.inputNames[i]) ? heldMeans(from.time, column, delayedBy(from.time, clock->late))
                                                  : onLinesAt(from.time, column, clock->late);
        }
    }
}

std::vector<std::vector<std::string>> clockGroups(const EstimationTask& task, const std::vector<Recording>& stamped) {
    const std::vector<std::string> changing = changingInputs(task, stamped);
    std::vector<std::vector<std::string>> groups;
    for (const std::string& input : changing)
        if (groups.size() < mostInputs) groups.push_back({input});
    if (changing.size() > 1) groups.push_back(changing);
    return groups;
}

double latestOf(const EstimationTask& task) {
    double latest = std::numeric_limits<double>::infinity();
    for (const Recording& r : task.recordings)
        if (r.role == Role::Fit) latest = std::min(latest, mostOfRecording * (r.time.back() - r.time.front()));
    return latest;
}

OffsetsTried offsetsFrom(double first, double interval, double latest, const std::function<double(double)>& misfitAt) {
    OffsetsTried tried{{0}, {first}, 0};
    for (const double part : reach) {
        if (!(part * interval < latest)) break;
        if (static_cast<int>(tried.offsets.size() - 1 - tried.least) >= mostInVain) break;
        tried.offsets.push_back(part * interval);
        tried.misfits.push_back(misfitAt(tried.offsets.back()));
        if (tried.misfits.back() < tried.misfits[tried.least]) tried.least = tried.offsets.size() - 1;
    }
    return tried;
}

std::vector<InputClock> likeliestClocks(const NullModel& null, const std::vector<Recording>& stamped,
                                        const std::vector<InputClock>& now,
                                        const std::vector<std::vector<std::string>>& groups,
                                        const SimulationOptions& simulation, const Progress& progress,
                                        std::size_t& group) {
    const EstimationTask& task = null.variant.task;
    const double interval = samplingInterval(task), latest = latestOf(task);
    ClockModel model(null, stamped, simulation, progress);
    const double before = model.misfit(now);
    const double variance = null.sumOfSquares() / static_cast<double>(null.fit.optimum.residuals.size());
    std::vector<InputClock> best;
    double least = before;
    for (std::size_t g = 0; g < groups.size(); ++g) {
        const auto misfitAt = [&](double late) { return model.misfit(with(now, groups[g], late)); };
        const auto [offsets, misfits, at] = offsetsFrom(now.empty() ? before : misfitAt(0), interval, latest, misfitAt);
        if (at == 0 && now.empty()) continue;
        const double low = offsets[at == 0 ? 0 : at - 1], high = offsets[std::min(at + 1, offsets.size() - 1)];
        if (!(low < high)) continue;
        const auto [late, left] = boost::math::tools::brent_find_minima(misfitAt, low, high, bitsOfAnOffset);
        const bool isOfAll = groups[g].size() > 1 && !best.empty();
        if (!(least - left > (isOfAll ? equivalenceMargin * variance : 0))) continue;
        least = left;
        best = with(now, groups[g], late);
        group = g;
    }
    return best;
}

double explainedByPickUp(const NullModel& null, const std::vector<InputClock>& clocks) {
    std::set<int> outputs;
    for (const ResidualChannel& c : null.channels) outputs.insert(c.output);
    const auto count = static_cast<Eigen::Index>(clocks.size() * outputs.size());
    Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(null.fit.optimum.residuals.size(), count);
    for (const ResidualChannel& c : null.channels) {
        const Recording& recording = fittedRecording(null.variant.task, c.experiment);
        const auto output = static_cast<std::size_t>(std::distance(outputs.begin(), outputs.find(c.output)));
        for (std::size_t i = 0; i < clocks.size(); ++i) {
            const auto& names = recording.inputNames;
            const auto own = std::find(names.begin(), names.end(), clocks[i].input) - names.begin();
            if (own >= recording.inputs.rows()) continue;
            for (int row = c.begin; row < c.end; ++row)
                columns(row, static_cast<Eigen::Index>(output * clocks.size() + i)) =
                    recording.inputs(own, c.samples[static_cast<std::size_t>(row - c.begin)]);
        }
    }
    return scoreColumns(null.scores().plain, null.fit.optimum.residuals, columns, false).explained;
}

}  // namespace analogon
