#include "core/effect/faulty_sample.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "core/base/median.hpp"
#include "core/base/range.hpp"

namespace analogon {
namespace {

constexpr int neighbours = 6;           // looked at on either side
constexpr int fewestNeighbours = 3;     // of them
constexpr int longest = 3;              // samples in a row
constexpr int longestStart = 4;         // until a model at rest has caught up
constexpr double leastDecay = 0.5;      // of what it lacks, from one of them to the next
constexpr double mostAfterwards = 0.1;  // of the first one
constexpr double allClear = 8;          // deviations of the noise
constexpr double levelAside = 0.25;     // of the spike, by which the two sides may differ
constexpr double ownPart = 0.5;         // of what the model leaves, that the measurement shows by itself
constexpr double leastSteps = 4;        // of a converter
constexpr int reachOfAJump = 4;         // samples behind a jump of an input
constexpr double jumpOfMedian = 5, jumpOfRange = 0.01;
constexpr double mostOfSamples = 0.01;
constexpr double halfClear = 4, mostHalfClear = 2;  // where that many more stand out, the noise has long tails
constexpr std::size_t mostAnyway = 6, mostTold = 4;
constexpr int fewestAlike = 12, fewestSamples = 50;  // in a row; of a channel that can be judged
constexpr double mostAlike = 0.01;                   // of neighbours elsewhere

using Runs = std::vector<std::pair<int, int>>;  // [begin, end) of rows

/// Standard deviation of what is new in each sample: from the differences of neighbours, so that what a model leaves
/// slowly does not count, nor a reading that stays the same.
double noiseOf(const Eigen::VectorXd& values) {
    std::vector<double> differences;
    for (Eigen::Index k = 1; k < values.size(); ++k)
        if (const double d = std::abs(values[k] - values[k - 1]); d > 0) differences.push_back(d);
    return median(std::move(differences)) / (0.6745 * std::numbers::sqrt2);
}

/// The middle of some values beside a run [begin, end), before or behind it.
std::optional<double> levelBeside(const Eigen::VectorXd& values, int begin, int end, bool isBehind) {
    const int from = isBehind ? end : std::max(0, begin - neighbours),
              to = isBehind ? std::min(static_cast<int>(values.size()), end + neighbours) : begin;
    if (to - from < fewestNeighbours) return std::nullopt;
    return median(std::vector<double>(values.begin() + from, values.begin() + to));
}

/// By how much a run stands out.
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

/// How many samples a model that begins at rest takes to catch up with a channel in motion; 0: it does not, or begins
/// with it. A fast state without a start value of its own (the current of a machine) does so within a few samples, and
/// all that follow show nothing of it.
int samplesToCatchUp(const NullModel& model, const ResidualChannel& channel, const Recording& recording) {
    const int rows = channel.end - channel.begin;
    if (rows < fewestSamples || channel.samples.front() != 0) return 0;
    const Eigen::VectorXd beyond = -model.fit.optimum.residuals.segment(channel.begin, rows);
    const double noise = noiseOf(beyond), first = std::abs(beyond[0]);
    if (!(first > allClear * noise)) return 0;
    int count = 1;
    while (count <= longestStart && std::abs(beyond[count]) > halfClear * noise) {
        if (beyond[count] * beyond[0] < 0 || std::abs(beyond[count]) > leastDecay * std::abs(beyond[count - 1]))
            return 0;
        ++count;
    }
    // what is slower has been pushed a little meanwhile
    const double least = std::max(halfClear * noise, mostAfterwards * first);
    const bool isOver = count <= longestStart && beyond.segment(count, neighbours).cwiseAbs().maxCoeff() < least;
    const double own = rangeOf(channel.measured.head(count + 1)).width();
    return isOver && own < ownPart * first && !behindJumps(recording).front() ? count : 0;
}

/// Samples of a channel that stand alone.
struct Spikes {
    const ResidualChannel* channel{};
    std::vector<int> samples;
};

Spikes spikesOf(const NullModel& model, const ResidualChannel& channel, const Recording& recording) {
    Spikes spikes{&channel, {}};
    const int rows = channel.end - channel.begin;
    const Eigen::VectorXd beyond = -model.fit.optimum.residuals.segment(channel.begin, rows);
    const Runs runs = runsThatStandAlone(beyond, channel.measured, allClear);
    if (runs.empty() || runsThatStandAlone(beyond, channel.measured, halfClear).size() > mostHalfClear * runs.size())
        return spikes;
    const std::vector<bool> isBehind = behindJumps(recording);
    for (const auto& [begin, end] : runs) {
        const auto first = channel.samples.begin() + begin, last = channel.samples.begin() + end;
        if (std::any_of(first, last, [&](int k) { return isBehind[static_cast<std::size_t>(k)]; })) continue;
        spikes.samples.insert(spikes.samples.end(), first, last);
    }
    if (spikes.samples.size() > std::max(mostAnyway, static_cast<std::size_t>(mostOfSamples * rows)))
        spikes.samples.clear();
    return spikes;
}

/// What several outputs do at once, the component does.
bool isShared(const std::vector<Spikes>& all, const Spikes& own, int sample) {
    return std::any_of(all.begin(), all.end(), [&](const Spikes& other) {
        return &other != &own && other.channel->experiment == own.channel->experiment &&
               std::any_of(other.samples.begin(), other.samples.end(),
                           [&](int k) { return std::abs(k - sample) <= 1; });
    });
}

/// The first sample of a reading that stuck is right.
void addStuck(const Recording& recording, int index, std::vector<FaultySamples>& faults) {
    for (Eigen::Index o = 0; o < recording.outputs.rows(); ++o) {
        const Eigen::VectorXd y = recording.outputs.row(o).transpose();
        for (const auto& [begin, end] : runsAlike(y))
            // a component that rests may do so at 0, and goes on from where it was
            if (y[begin] != 0 && end < y.size() && std::abs(y[end] - y[begin]) > allClear * noiseOf(y))
                faults.push_back({index, recording.outputNames[static_cast<std::size_t>(o)], begin + 1, end, true});
    }
}

}  // namespace

std::vector<std::pair<int, int>> runsAlike(const Eigen::VectorXd& values) {
    Runs runs;
    int elsewhere = 0;
    for (int begin = 0, end = 1; begin < values.size(); begin = end++) {
        while (end < values.size() && values[end] == values[begin]) ++end;
        if (end - begin < fewestAlike)
            elsewhere += end - begin - 1;
        else
            runs.emplace_back(begin, end);
    }
    if (values.size() < fewestSamples || elsewhere > mostAlike * static_cast<double>(values.size())) runs.clear();
    return runs;
}

std::vector<FaultySamples> faultySamples(const NullModel& model) {
    const EstimationTask& task = model.variant.task;
    std::vector<FaultySamples> faults;
    const std::vector<int> recordings = recordingsOf(task, Role::Fit);
    const auto indexOf = [&](const ResidualChannel& c) { return recordings[static_cast<std::size_t>(c.experiment)]; };
    const auto recordingOf = [&](const ResidualChannel& c) -> const Recording& {
        return task.recordings[static_cast<std::size_t>(indexOf(c))];
    };
    std::optional<Outcome<PreparedTask>> held;  // names the outputs; most recordings have no fault to name
    const auto add = [&](const ResidualChannel& c, int begin, int end, bool isMoving) {
        if (!held) held = prepareHeld(model.variant, {}, model.noise);
        if (!*held) return;
        const auto& outputs = (*held)->system->outputs();
        faults.push_back({indexOf(c), outputs[static_cast<std::size_t>(c.output)].name, begin, end, false, isMoving});
    };
    std::vector<Spikes> spikes;
    for (const ResidualChannel& channel : model.channels)
        spikes.push_back(spikesOf(model, channel, recordingOf(channel)));
    for (const Spikes& s : spikes)
        for (const int sample : s.samples)
            if (!isShared(spikes, s, sample)) add(*s.channel, sample, sample + 1, false);
    for (const ResidualChannel& channel : model.channels)
        if (const int late = samplesToCatchUp(model, channel, recordingOf(channel)); late > 0)
            add(channel, 0, channel.samples[static_cast<std::size_t>(late)], true);
    for (const int index : recordings) addStuck(task.recordings[static_cast<std::size_t>(index)], index, faults);
    return faults;
}

void leaveOut(EstimationTask& task, const std::vector<FaultySamples>& faults) {
    for (const FaultySamples& f : faults) {
        Recording& recording = task.recordings[static_cast<std::size_t>(f.recording)];
        const auto row = std::find(recording.outputNames.begin(), recording.outputNames.end(), f.output);
        if (row != recording.outputNames.end())
            recording.outputs.row(row - recording.outputNames.begin())
                .segment(f.begin, f.end - f.begin)
                .setConstant(std::nan(""));
    }
}

std::vector<Text> faultRemarks(const EstimationTask& task, const std::vector<FaultySamples>& faults) {
    std::vector<Text> remarks;
    for (auto begin = faults.begin(); begin != faults.end();) {
        const Recording& recording = task.recordings[static_cast<std::size_t>(begin->recording)];
        const auto timeOf = [&](int sample) { return recording.time[static_cast<std::size_t>(sample)]; };
        if (begin->isMoving) {
            remarks.push_back(
                phrase("'{}' begins in motion: the model of output '{}' begins at rest and has caught up at {:.5g} s, "
                       "what is before is left out",
                       recording.name, begin->output, timeOf(begin->end)));
            ++begin;
            continue;
        }
        if (begin->isStuck) {
            remarks.push_back(
                phrase("output '{}' of '{}' reads exactly the same from {:.5g} s to {:.5g} s and jumps when it goes "
                       "on: the sensor or the logger stuck, and this is left out",
                       begin->output, recording.name, timeOf(begin->begin - 1), timeOf(begin->end - 1)));
            ++begin;
            continue;
        }
        const auto end = std::find_if(begin, faults.end(), [&](const FaultySamples& f) {
            return f.isStuck || f.isMoving || f.recording != begin->recording || f.output != begin->output;
        });
        const auto count = static_cast<std::size_t>(end - begin);
        Text when;
        for (auto f = begin; f != begin + static_cast<std::ptrdiff_t>(std::min(count, mostTold)); ++f) {
            if (!when.empty()) when += ", ";
            when += phrase("{:.5g} s", timeOf(f->begin));
        }
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
