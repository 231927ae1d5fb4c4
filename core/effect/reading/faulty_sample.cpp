#include "core/effect/reading/faulty_sample.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "core/base/median.hpp"
#include "core/base/range.hpp"
#include "core/effect/model/model_state.hpp"
#include "core/effect/thresholds.hpp"

namespace analogon {

using namespace threshold::faultySample;
using threshold::inputEdge::mostAside;
using threshold::noise::clearOfNoise;
using threshold::noise::outlier;

namespace {

const int fewestNeighbours = neighbours / 2;  // of those on a side, that are sound
const int longest = neighbours / 2;           // of samples in a row that may stand alone
constexpr std::size_t mostTold = 4;           // of them, one by one

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
    if (!(first > clearOfNoise * noise)) return 0;
    int count = 1;
    while (count <= longestStart && std::abs(beyond[count]) > outlier * noise) {
        if (beyond[count] * beyond[0] < 0 || std::abs(beyond[count]) > leastDecay * std::abs(beyond[count - 1]))
            return 0;
        ++count;
    }
    // what is slower has been pushed a little meanwhile
    const double least = std::max(outlier * noise, mostAside * first);
    const bool isOver = count <= longestStart && beyond.segment(count, neighbours).cwiseAbs().maxCoeff() < least;
    const double own = rangeOf(channel.measured.head(count + 1)).width();
    return isOver && own < ownPart * first && !behindJumps(recording).front() ? count : 0;
}

/// Where a channel was measured, what it read there, and what of that is beyond the model.
struct Measured {
    int recording{};  // of the task
    int output{};     // among those of the recording's channels
    std::vector<int> samples;
    Eigen::VectorXd values, beyond;
};

/// Of the samples of a channel, those that stand alone.
std::vector<int> spikesOf(const Measured& channel, const Recording& recording) {
    const Runs runs = runsThatStandAlone(channel.beyond, channel.values, clearOfNoise);
    if (runs.empty() ||
        runsThatStandAlone(channel.beyond, channel.values, outlier).size() > mostHalfClear * runs.size())
        return {};
    std::vector<int> spikes;
    const std::vector<bool> isBehind = behindJumps(recording);
    for (const auto& [begin, end] : runs) {
        const auto first = channel.samples.begin() + begin, last = channel.samples.begin() + end;
        if (std::any_of(first, last, [&](int k) { return isBehind[static_cast<std::size_t>(k)]; })) continue;
        spikes.insert(spikes.end(), first, last);
    }
    const auto most = static_cast<std::size_t>(mostOfSamples * static_cast<double>(channel.samples.size()));
    if (spikes.size() > std::max(mostAnyway, most)) spikes.clear();
    return spikes;
}

/// Index of a channel, and a sample of it that stands alone. What several outputs do at once, the component does.
std::vector<std::pair<std::size_t, int>> spikesOfOneAlone(const std::vector<Measured>& channels,
                                                          const std::vector<Recording>& recordings) {
    std::vector<std::vector<int>> all;
    for (const Measured& c : channels) all.push_back(spikesOf(c, recordings[static_cast<std::size_t>(c.recording)]));
    const auto isShared = [&](std::size_t own, int sample) {
        for (std::size_t other = 0; other < all.size(); ++other)
            if (other != own && channels[other].recording == channels[own].recording &&
                std::any_of(all[other].begin(), all[other].end(), [&](int k) { return std::abs(k - sample) <= 1; }))
                return true;
        return false;
    };
    std::vector<std::pair<std::size_t, int>> spikes;
    for (std::size_t c = 0; c < channels.size(); ++c)
        for (const int sample : all[c])
            if (!isShared(c, sample)) spikes.emplace_back(c, sample);
    return spikes;
}

/// Readings that stuck, of which the first sample is right. A component that rests may do so at 0, and goes on from
/// where it was; what sticks to the end of a recording is told by a model that moves on.
void addStuck(int recording, const std::string& output, const Eigen::VectorXd& values, const Eigen::VectorXd& simulated,
              std::vector<FaultySamples>& faults) {
    for (const auto& [begin, end] : runsAlike(values)) {
        const double moved = end < values.size()    ? std::abs(values[end] - values[begin])
                             : simulated.size() > 0 ? rangeOf(simulated.segment(begin, end - begin)).width()
                                                    : 0;
        if (values[begin] != 0 && moved > clearOfNoise * noiseOf(values))
            faults.push_back({recording, output, begin + 1, end, true});
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
    std::optional<Outcome<PreparedTask>> held;  // names the outputs; most recordings have no fault to name
    const auto add = [&](int recording, int output, int begin, int end, bool isMoving) {
        if (!held) held = prepareHeld(model.variant, {}, model.noise);
        if (!*held) return;
        const auto& outputs = (*held)->system->outputs();
        faults.push_back({recording, outputs[static_cast<std::size_t>(output)].name, begin, end, false, isMoving});
    };
    std::vector<Measured> channels;
    for (const ResidualChannel& c : model.channels)
        channels.push_back({indexOf(c), c.output, c.samples, c.measured,
                            -model.fit.optimum.residuals.segment(c.begin, c.end - c.begin)});
    for (const auto& [c, sample] : spikesOfOneAlone(channels, task.recordings))
        add(channels[c].recording, channels[c].output, sample, sample + 1, false);
    for (const ResidualChannel& c : model.channels)
        if (const int late = samplesToCatchUp(model, c, task.recordings[static_cast<std::size_t>(indexOf(c))]);
            late > 0)
            add(indexOf(c), c.output, 0, c.samples[static_cast<std::size_t>(late)], true);
    for (const int index : recordings) {
        const Recording& recording = task.recordings[static_cast<std::size_t>(index)];
        for (std::size_t o = 0; o < recording.outputNames.size(); ++o)
            addStuck(index, recording.outputNames[o], recording.outputs.row(static_cast<Eigen::Index>(o)).transpose(),
                     {}, faults);
    }
    return faults;
}

std::vector<FaultySamples> faultySamples(const std::vector<Recording>& recordings, const ModelState& state) {
    std::vector<FaultySamples> faults;
    if (recordings.size() != state.experiments.size()) return faults;  // of a search that was stopped
    for (std::size_t r = 0; r < recordings.size(); ++r) {
        const ExperimentState& e = state.experiments[r];
        const auto count = static_cast<Eigen::Index>(recordings[r].time.size());
        if (e.role != Role::Validate || e.failure.failed || static_cast<Eigen::Index>(e.time.size()) != count) continue;
        std::vector<Measured> channels;
        for (std::size_t o = 0; o < e.outputs.size(); ++o) {
            Measured channel{static_cast<int>(r), static_cast<int>(o), {}, {}, {}};
            const OutputState& output = e.outputs[o];
            for (Eigen::Index k = 0; k < count; ++k)
                if (std::isfinite(output.measured[k])) channel.samples.push_back(static_cast<int>(k));
            channel.values = output.measured(channel.samples);
            channel.beyond = channel.values - output.simulated(channel.samples);
            channels.push_back(std::move(channel));
        }
        for (const auto& [c, sample] : spikesOfOneAlone(channels, recordings))
            faults.push_back({static_cast<int>(r), e.outputs[c].name, sample, sample + 1});
        for (const OutputState& o : e.outputs) addStuck(static_cast<int>(r), o.name, o.measured, o.simulated, faults);
    }
    return faults;
}

void leaveOut(EstimationTask& task, const std::vector<FaultySamples>& faults) {
    for (const FaultySamples& f : faults) {
        Recording& recording = task.recordings.edit()[static_cast<std::size_t>(f.recording)];
        const auto row = std::find(recording.outputNames.begin(), recording.outputNames.end(), f.output);
        if (row != recording.outputNames.end())
            recording.outputs.row(row - recording.outputNames.begin())
                .segment(f.begin, f.end - f.begin)
                .setConstant(std::nan(""));
    }
}

ModelState withoutFaults(ModelState state, const std::vector<FaultySamples>& faults) {
    for (const FaultySamples& f : faults) {
        ExperimentState& e = state.experiments[static_cast<std::size_t>(f.recording)];
        for (OutputState& o : e.outputs) {
            if (o.name != f.output) continue;
            o.measured.segment(f.begin, f.end - f.begin).setConstant(std::nan(""));
            o.figures = errorFigures(o.simulated.transpose(), o.measured.transpose());
        }
        e.errorPercent = errorPercentOf(e.outputs);
    }
    return state;
}

namespace {

/// What the fault is of which `begin` is the first part, up to `end`.
Text wordsOf(const Recording& recording, std::vector<FaultySamples>::const_iterator begin,
             std::vector<FaultySamples>::const_iterator end) {
    const auto timeOf = [&](int sample) { return recording.time[static_cast<std::size_t>(sample)]; };
    if (begin->isMoving)
        return phrase("'{}' begins in motion: the model of output '{}' begins at rest and has caught up at {:.5g} s",
                      recording.name, begin->output, timeOf(begin->end));
    if (begin->isStuck && begin->end == static_cast<int>(recording.time.size()))
        return phrase(
            "output '{}' of '{}' reads exactly the same from {:.5g} s to its end, where the model moves on: the sensor "
            "or the logger stuck",
            begin->output, recording.name, timeOf(begin->begin - 1));
    if (begin->isStuck)
        return phrase(
            "output '{}' of '{}' reads exactly the same from {:.5g} s to {:.5g} s and jumps when it goes on: the "
            "sensor or the logger stuck",
            begin->output, recording.name, timeOf(begin->begin - 1), timeOf(begin->end - 1));
    const auto count = static_cast<std::size_t>(end - begin);
    Text when;
    for (auto f = begin; f != begin + static_cast<std::ptrdiff_t>(std::min(count, mostTold)); ++f) {
        if (!when.empty()) when += ", ";
        when += phrase("{:.5g} s", timeOf(f->begin));
    }
    if (count > mostTold) when += ", …";
    return phrase(
        "output '{}' of '{}': single samples far from their neighbours and from the model are taken for faults of the "
        "measurement ({} of them: {})",
        begin->output, recording.name, count, when);
}

/// What each fault is, of one recording after the other; single samples of an output are one.
std::vector<std::pair<int, Text>> faultWords(const std::vector<Recording>& recordings,
                                             const std::vector<FaultySamples>& faults) {
    std::vector<std::pair<int, Text>> words;
    for (auto begin = faults.begin(); begin != faults.end();) {
        const auto isAnother = [&](const FaultySamples& f) {
            return begin->isStuck || begin->isMoving || f.isStuck || f.isMoving || f.recording != begin->recording ||
                   f.output != begin->output;
        };
        const auto end = std::find_if(begin + 1, faults.end(), isAnother);
        words.emplace_back(begin->recording,
                           wordsOf(recordings[static_cast<std::size_t>(begin->recording)], begin, end));
        begin = end;
    }
    return words;
}

}  // namespace

std::vector<Text> faultRemarks(const std::vector<Recording>& recordings, const std::vector<FaultySamples>& faults) {
    std::vector<Text> remarks;
    for (const auto& [recording, words] : faultWords(recordings, faults))
        remarks.push_back(phrase("{}; these samples are left out", words));
    return remarks;
}

std::vector<Text> faultRemarks(const std::vector<Recording>& recordings, const std::vector<FaultySamples>& faults,
                               const ModelState& state, const ModelState& sound) {
    std::vector<Text> remarks;
    for (const auto& [recording, words] : faultWords(recordings, faults)) {
        const auto r = static_cast<std::size_t>(recording);
        remarks.push_back(
            phrase("{}; the error that is reported of '{}' is over all samples, {:.3g} %: without those at fault it is "
                   "{:.3g} %",
                   words, recordings[r].name, state.experiments[r].errorPercent, sound.experiments[r].errorPercent));
    }
    return remarks;
}

}  // namespace analogon
