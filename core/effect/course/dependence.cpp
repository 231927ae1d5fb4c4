#include "core/effect/course/dependence.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/range.hpp"
#include "core/effect/catalogue/likeliest.hpp"
#include "core/fit/clock.hpp"
#include "core/flat/parameter_change.hpp"

namespace analogon {
namespace {

constexpr const char* inputName = "recordedChannel";

/// A channel that every fitted recording has, between -0.5 and 0.5 over all of them.
struct Channel {
    std::string name;
    double middle{}, range{};
    std::vector<Eigen::VectorXd> values;  // per recording of the task; empty where it is not recorded
};

std::vector<Channel> unusedChannels(const EstimationTask& task) {
    std::vector<Channel> channels;
    const std::vector<int> fitted = recordingsOf(task, Role::Fit);
    if (fitted.empty()) return channels;
    for (const SpareChannel& spare : task.recordings[static_cast<std::size_t>(fitted.front())].spares) {
        Channel channel{spare.name, 0, 0, {}};
        Range range;
        bool isEverywhere = true;
        for (const Recording& r : task.recordings) {
            const auto own = std::find_if(r.spares.begin(), r.spares.end(),
                                          [&](const SpareChannel& s) { return s.name == spare.name; });
            const bool isThere = own != r.spares.end() && own->values.size() == r.time.size();
            channel.values.push_back(isThere ? Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(
                                                   own->values.data(), static_cast<Eigen::Index>(own->values.size())))
                                             : Eigen::VectorXd());
            if (r.role != Role::Fit) continue;
            isEverywhere = isEverywhere && isThere && channel.values.back().allFinite();
            if (isThere) range.take(rangeOf(own->values));
        }
        if (!isEverywhere || !(range.width() > 0)) continue;
        channel.middle = 0.5 * (range.low + range.high);
        channel.range = range.width();
        for (Eigen::VectorXd& v : channel.values) v = (v.array() - channel.middle) / channel.range;
        channels.push_back(std::move(channel));
    }
    return channels;
}

/// A parameter's column where the parameter moves with a channel; leaves out how the states follow.
Eigen::VectorXd moving(const NullModel& null, const std::vector<int>& fitted, const Channel& channel,
                       const Eigen::VectorXd& column) {
    Eigen::VectorXd result = column;
    for (const ResidualChannel& c : null.channels) {
        const Eigen::VectorXd& values =
            channel.values[static_cast<std::size_t>(fitted[static_cast<std::size_t>(c.experiment)])];
        for (int row = c.begin; row < c.end; ++row)
            result[row] *= values[c.samples[static_cast<std::size_t>(row - c.begin)]];
    }
    return result;
}

struct Likely {
    std::size_t channel{};
    Eigen::Index parameter{};
    double explained{}, slope{};
};

std::optional<ChannelDependence> fitted(const NullModel& null, const Channel& channel, const Likely& likely,
                                        const FitOptions& options, const Progress& progress) {
    const FitEstimate& estimate = null.fit.estimates[static_cast<std::size_t>(likely.parameter)];
    Variant variant = null.variant;
    variant.task.change = ParameterChange{estimate.name, 0, inputName};
    for (std::size_t r = 0; r < variant.task.recordings.size(); ++r) {
        Recording& recording = variant.task.recordings.edit()[r];
        if (channel.values[r].size() == 0) continue;
        recording.addInput(inputName, channel.values[r]);
    }
    FitParameter slope;
    slope.name = slopeOf(estimate.name);
    slope.start = likely.slope;
    variant.task.parameters.push_back(slope);
    std::optional<FitResult> result = fitBeside(null, variant, options, progress);
    if (!result) return std::nullopt;
    ChannelDependence dependence{estimate.name, channel.name, 0, 0, channel.middle, channel.range, 0, {}, {}};
    for (const FitEstimate& e : result->estimates) {
        if (e.name == estimate.name) dependence.value = e.value;
        if (e.name == slope.name) dependence.slope = e.value;
    }
    dependence.explained = null.sumOfSquares() - result->optimum.residuals.squaredNorm();
    variant.values = valuesOf(*result);
    dependence.variant = std::move(variant);
    dependence.fit = std::move(*result);
    return dependence;
}

/// What explains most to first order first.
std::vector<Likely> likelyDependences(const NullModel& null, const std::vector<Channel>& channels) {
    const std::vector<int> recordings = recordingsOf(null.variant.task, Role::Fit);
    const Eigen::MatrixXd& jacobian = null.fit.optimum.jacobian;
    const OrthogonalProjector& complement = null.scores().plain;
    std::vector<Likely> likely;
    for (std::size_t c = 0; c < channels.size(); ++c)
        for (Eigen::Index j = 0; j < jacobian.cols(); ++j) {
            const FitEstimate& estimate = null.fit.estimates[static_cast<std::size_t>(j)];
            if (estimate.experiment >= 0 || isClock(estimate.name)) continue;  // a start value, or none of the model
            const ColumnScore score = scoreColumns(complement, null.fit.optimum.residuals,
                                                   moving(null, recordings, channels[c], jacobian.col(j)), false);
            if (score.visible > leastVisible) likely.push_back({c, j, score.explained, score.strengths[0]});
        }
    std::stable_sort(likely.begin(), likely.end(),
                     [](const Likely& a, const Likely& b) { return a.explained > b.explained; });
    return likely;
}

}  // namespace

double explainedByDependence(const NullModel& null) {
    const std::vector<Likely> likely = likelyDependences(null, unusedChannels(null.variant.task));
    return likely.empty() ? 0 : likely.front().explained;
}

std::optional<ChannelDependence> bestDependence(const NullModel& null, FitOptions options, int threads,
                                                const Progress& progress) {
    options.simulation = limited(null, options.simulation);
    const std::vector<Channel> channels = unusedChannels(null.variant.task);
    if (channels.empty()) return std::nullopt;
    std::vector<Likely> likely = likelyDependences(null, channels);
    keepLikeliest(likely);
    std::optional<ChannelDependence> best;
    takeBest(likely, best, threads, progress,
             [&](const Likely& each) { return fitted(null, channels[each.channel], each, options, progress); });
    return best;
}

}  // namespace analogon
