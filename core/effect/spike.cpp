#include "core/effect/spike.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "core/base/median.hpp"
#include "core/base/range.hpp"

namespace analogon {
namespace {

constexpr int neighbours = 6;        // looked at on either side
constexpr int fewestNeighbours = 3;  // of them
constexpr int longest = 3;           // samples in a row
constexpr double allClear = 8;       // deviations of the noise
constexpr double levelAside = 0.25;  // of the spike, by which the two sides may differ
constexpr double ownPart = 0.5;      // of what the model leaves, that the measurement shows by itself
constexpr double leastSteps = 4;     // of a converter
constexpr int reachOfAJump = 4;      // samples behind a jump of an input
constexpr double jumpOfMedian = 5, jumpOfRange = 0.01;
constexpr double mostOfSamples = 0.01;
constexpr double halfClear = 4, mostHalfClear = 2;  // where that many more stand out, the noise has long tails
constexpr std::size_t mostAnyway = 6, mostTold = 4;

using Runs = std::vector<std::pair<int, int>>;  // [begin, end) of rows

/// Standard deviation of what is new in each sample: from the differences of neighbours, so that what a model leaves
/// slowly does not count.
double noiseOf(const Eigen::VectorXd& values) {
    std::vector<double> differences;
    for (Eigen::Index k = 1; k < values.size(); ++k) differences.push_back(std::abs(values[k] - values[k - 1]));
    return median(std::move(differences)) / (0.6745 * std::numbers::sqrt2);
}

/// The middle of some values beside a run [begin, end), before or behind it.
std::optional<double> levelBeside(const Eigen::VectorXd& values, int begin, int end, bool isBehind) {
    const int from = isBehind ? end : std::max(0, begin - neighbours),
              to = isBehind ? std::min(static_cast<int>(values.size()), end + neighbours) : begin;
    if (to - from < fewestNeighbours) return std::nullopt;
    return median(std::vector<double>(values.begin() + from, values.begin() + to));
}

struct Height {
    double above{};   // the middle of both sides
    bool isReturn{};  // to where it came from
};
Height heightOf(const Eigen::VectorXd& values, int begin, int end) {
    const std::optional<double> before = levelBeside(values, begin, end, false),
                                behind = levelBeside(values, begin, end, true);
    if (!before || !behind) return {};
    const double level = 0.5 * (*before + *behind);
    double height = std::numeric_limits<double>::infinity();
    for (int k = begin; k < end; ++k)
        if (std::abs(values[k] - level) < std::abs(height)) height = values[k] - level;
    return {height, std::abs(*behind - *before) < levelAside * std::abs(height)};
}

/// Noise and slow changes beside a run: what the differences of neighbouring samples spread by.
double unrestBeside(const Eigen::VectorXd& values, int begin, int end) {
    std::vector<double> differences;
    const int last = static_cast<int>(values.size()) - 1;
    for (int k = std::max(0, begin - neighbours); k < std::min(last, end + neighbours); ++k)
        if (k + 1 < begin || k >= end) differences.push_back(std::abs(values[k + 1] - values[k]));
    return median(std::move(differences));
}

/// The step of a converter, if there is one; else next to nothing.
double finestStep(const Eigen::VectorXd& values) {
    double step = std::numeric_limits<double>::infinity();
    for (Eigen::Index k = 1; k < values.size(); ++k)
        if (const double d = std::abs(values[k] - values[k - 1]); d > 0) step = std::min(step, d);
    return std::isfinite(step) ? step : 0;
}

/// Samples at which or shortly before which an input jumps.
std::vector<bool> behindJumps(const Recording& recording) {
    const auto count = static_cast<int>(recording.time.size());
    std::vector<bool> isBehind(static_cast<std::size_t>(count), false);
    for (Eigen::Index i = 0; i < recording.inputs.rows(); ++i) {
        const Eigen::VectorXd u = recording.inputs.row(i).transpose();
        std::vector<double> changes;
        for (Eigen::Index k = 1; k < u.size(); ++k) changes.push_back(std::abs(u[k] - u[k - 1]));
        const double least = std::max(jumpOfMedian * median(changes), jumpOfRange * rangeOf(u).width());
        for (int k = 1; k < count; ++k)
            if (changes[static_cast<std::size_t>(k - 1)] > least)
                for (int at = k - 1; at < std::min(count, k + reachOfAJump); ++at)
                    isBehind[static_cast<std::size_t>(at)] = true;
    }
    return isBehind;
}

/// The runs of a channel that stand alone, by so many deviations of the noise, in what it measures beyond the model as
/// in all that it measures.
Runs runsThatStandAlone(const Eigen::VectorXd& beyond, const Eigen::VectorXd& measured, double clear) {
    const auto count = static_cast<int>(beyond.size());
    const double noise = noiseOf(beyond);
    const double step = finestStep(measured);
    Runs runs;
    const auto changesAt = [&](int k) { return std::abs(beyond[k] - beyond[k - 1]) > 0.5 * clear * noise; };
    for (int begin = 1; begin + 1 < count; ++begin) {
        if (!changesAt(begin)) continue;
        for (int end = begin + 1; end <= std::min(begin + longest, count - 1); ++end) {
            if (!changesAt(end)) continue;
            const Height height = heightOf(beyond, begin, end);
            const double own = heightOf(measured, begin, end).above, size = std::abs(height.above);
            const double least = std::max(noise, unrestBeside(beyond, begin, end));
            const bool isOwn = own * height.above > 0 && std::abs(own) > ownPart * size &&
                               std::abs(own) > leastSteps * step &&
                               std::abs(own) > clear * unrestBeside(measured, begin, end);
            const bool isAlone = height.isReturn && size > clear * least && isOwn;
            if (!isAlone) continue;
            if (!runs.empty() && runs.back().second >= begin)
                runs.back().second = std::max(runs.back().second, end);
            else
                runs.emplace_back(begin, end);
        }
    }
    std::erase_if(runs, [](const auto& run) { return run.second - run.first > longest; });
    return runs;
}

}  // namespace

std::vector<Spike> spikes(const NullModel& model) {
    struct Found {
        const ResidualChannel* channel;
        std::vector<int> samples;
    };
    std::vector<Found> found;
    const std::vector<int> recordings = recordingsOf(model.variant.task, Role::Fit);
    for (const ResidualChannel& channel : model.channels) {
        const int index = recordings[static_cast<std::size_t>(channel.experiment)];
        const std::vector<bool> isBehind = behindJumps(model.variant.task.recordings[static_cast<std::size_t>(index)]);
        const int rows = channel.end - channel.begin;
        const Eigen::VectorXd beyond = -model.fit.optimum.residuals.segment(channel.begin, rows);
        const Runs runs = runsThatStandAlone(beyond, channel.measured, allClear);
        if (runs.empty() ||
            runsThatStandAlone(beyond, channel.measured, halfClear).size() > mostHalfClear * runs.size())
            continue;
        Found here{&channel, {}};
        for (const auto& [begin, end] : runs) {
            const auto first = channel.samples.begin() + begin, last = channel.samples.begin() + end;
            if (std::any_of(first, last, [&](int k) { return isBehind[static_cast<std::size_t>(k)]; })) continue;
            here.samples.insert(here.samples.end(), first, last);
        }
        if (here.samples.size() <= std::max(mostAnyway, static_cast<std::size_t>(mostOfSamples * rows)))
            found.push_back(std::move(here));
    }
    // what several outputs do at once, the component does
    const auto isAlsoIn = [](const Found& other, int sample) {
        return std::any_of(other.samples.begin(), other.samples.end(),
                           [&](int k) { return std::abs(k - sample) <= 1; });
    };
    std::vector<Spike> spikes;
    const Outcome<PreparedTask> held = prepareHeld(model.variant, {}, model.noise);
    if (!held) return spikes;
    for (const Found& here : found)
        for (const int sample : here.samples) {
            const bool isShared = std::any_of(found.begin(), found.end(), [&](const Found& other) {
                return &other != &here && other.channel->experiment == here.channel->experiment &&
                       isAlsoIn(other, sample);
            });
            if (isShared) continue;
            const SignalInfo& output = held->system->outputs()[static_cast<std::size_t>(here.channel->output)];
            spikes.push_back({recordings[static_cast<std::size_t>(here.channel->experiment)], output.name, sample});
        }
    return spikes;
}

void leaveOut(EstimationTask& task, const std::vector<Spike>& spikes) {
    for (const Spike& s : spikes) {
        Recording& recording = task.recordings[static_cast<std::size_t>(s.recording)];
        const auto row = std::find(recording.outputNames.begin(), recording.outputNames.end(), s.output);
        if (row != recording.outputNames.end())
            recording.outputs(row - recording.outputNames.begin(), s.sample) = std::nan("");
    }
}

std::vector<Text> spikeRemarks(const EstimationTask& task, const std::vector<Spike>& spikes) {
    std::vector<Text> remarks;
    for (auto begin = spikes.begin(); begin != spikes.end();) {
        const auto end = std::find_if(begin, spikes.end(), [&](const Spike& s) {
            return s.recording != begin->recording || s.output != begin->output;
        });
        const Recording& recording = task.recordings[static_cast<std::size_t>(begin->recording)];
        const auto count = static_cast<std::size_t>(end - begin);
        std::string when;
        for (std::size_t i = 0; i < std::min(count, mostTold); ++i)
            when +=
                fmt::format("{}{:.5g} s", i == 0 ? "" : ", ",
                            recording.time[static_cast<std::size_t>((begin + static_cast<std::ptrdiff_t>(i))->sample)]);
        if (count > mostTold) when += ", …";
        remarks.push_back(
            phrase("output '{}' of '{}': single samples far from their neighbours and from the model are taken for "
                   "faults of the measurement and left out ({} of them: {})",
                   begin->output, recording.name, count, when));
        begin = end;
    }
    return remarks;
}

}  // namespace analogon
