#include "core/effect/reading/mistaken_wiring.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/effect/reading/misread.hpp"

namespace analogon {
namespace {

/// Start values that were read from the first cell of a channel's column, beside what that holds now.
void moveStarts(Recording& recording, const std::string& channel, double before, double after) {
    const std::string column = columnBehind(recording, channel);
    if (column.empty() || !std::isfinite(after - before)) return;
    for (RecordingStart& start : recording.starts)
        if (start.column == column) start.value += after - before;
}

void takeAsMeant(Recording& recording, const MistakenWiring& mistake) {
    const std::string &one = mistake.channels.front(), &other = mistake.channels.back();
    const std::optional<ChannelRow> first = channelRow(recording, one), last = channelRow(recording, other);
    if (!first || !last || recording.time.empty()) return;
    const double ofFirst = first->of(recording)[0], ofLast = last->of(recording)[0];
    if (mistake.isOfSign()) {
        first->of(recording) *= -1;
    } else {
        first->of(recording).swap(last->of(recording));
        moveStarts(recording, other, ofLast, ofFirst);
    }
    moveStarts(recording, one, ofFirst, first->of(recording)[0]);
}

/// Whether two channels may be exchanged in a recording: each can stand in for the other, and they are not the same.
bool canBeExchanged(const Recording& recording, const std::string& one, const std::string& other) {
    const std::optional<ChannelRow> first = channelRow(recording, one), last = channelRow(recording, other);
    if (!first || !last || recording.isHeld(one) != recording.isHeld(other)) return false;
    const auto hasClock = [&](const RecordingClock& c) { return c.output == one || c.output == other; };
    if (std::any_of(recording.clocks.begin(), recording.clocks.end(), hasClock)) return false;
    bool isOther = false;
    for (std::size_t k = 0; k < recording.time.size(); ++k) {
        const auto sample = static_cast<Eigen::Index>(k);
        const double a = first->of(recording)[sample], b = last->of(recording)[sample];
        if (std::isnan(a) != std::isnan(b)) return false;
        isOther = isOther || std::abs(a - b) > 0;
    }
    return isOther;
}

/// Channels of the model that recordings have in common, with their units.
std::vector<std::pair<std::string, std::string>> channelsIn(const EstimationTask& task, const System& system,
                                                            const std::vector<int>& recordings) {
    std::vector<std::pair<std::string, std::string>> channels;
    for (const std::vector<SignalInfo>* signals : {&system.inputs(), &system.outputs()})
        for (const SignalInfo& signal : *signals) {
            const auto isIn = [&](int r) {
                return channelRow(task.recordings[static_cast<std::size_t>(r)], signal.name).has_value();
            };
            if (std::all_of(recordings.begin(), recordings.end(), isIn))
                channels.emplace_back(signal.name, signal.unit);
        }
    return channels;
}

/// Every channel with the other sign, and every two of one unit exchanged: in all recordings, and, where several are
/// fitted, in each alone.
std::vector<MistakenWiring> possibleWirings(const EstimationTask& task, const System& system) {
    std::vector<MistakenWiring> wirings;
    for (const std::vector<int>& recordings : whereMisread(task)) {
        const auto channels = channelsIn(task, system, recordings);
        for (auto one = channels.begin(); one != channels.end(); ++one) {
            wirings.push_back({recordings, {one->first}, {}});
            for (auto other = one + 1; other != channels.end(); ++other) {
                const auto canBe = [&](int r) {
                    return canBeExchanged(task.recordings[static_cast<std::size_t>(r)], one->first, other->first);
                };
                if (one->second == other->second && std::all_of(recordings.begin(), recordings.end(), canBe))
                    wirings.push_back({recordings, {one->first, other->first}, {}});
            }
        }
    }
    return wirings;
}

/// The noise of the outputs as they are meant: it belongs to what was measured.
std::vector<Eigen::VectorXd> noiseAsMeant(const NullModel& null, const System& system, const MistakenWiring& mistake) {
    std::vector<Eigen::VectorXd> noise = null.noise;
    const int one = system.outputIndex(mistake.channels.front()), other = system.outputIndex(mistake.channels.back());
    if (one < 0 || other < 0) return noise;
    for (const int r : mistake.recordings)
        if (Eigen::VectorXd& own = noise[static_cast<std::size_t>(r)]; own.size() > std::max(one, other))
            std::swap(own[one], own[other]);
    return noise;
}

/// The model at the start values of the study against the recordings as they are given. Where outputs alone are meant
/// otherwise, it need not be simulated again: of twenty of them there are hundreds of pairs.
class SimulatedAsGiven {
public:
    SimulatedAsGiven(const PreparedTask& prepared, const SimulationOptions& simulation, const Progress& progress)
        : prepared_(prepared), channels_(residualChannels(prepared.problem)) {
        const Linearisation at =
            linearise(prepared.problem, prepared.problem.startValues(), true, {}, simulation, progress);
        if (!at.ok || !at.jacobian.allFinite()) return;
        residuals_ = at.residuals;
        beside_.emplace(at.jacobian);
    }

    bool isUsable() const { return beside_.has_value(); }

    /// As promisedLeft(), for outputs; in units of the noise of each as it is given.
    double left(const MistakenWiring& mistake) const {
        Eigen::VectorXd meant = residuals_;
        for (const ResidualChannel& one : channels_)
            if (const ResidualChannel* const other = takenBy(one, mistake)) {
                const double scale = (mistake.isOfSign() ? -1 : 1) * weightOf(one) / weightOf(*other);
                meant.segment(one.begin, one.end - one.begin) += one.measured - scale * other->measured;
            }
        return (*beside_)(meant).squaredNorm();
    }

private:
    /// The channel whose measurement one takes; null: it keeps its own.
    const ResidualChannel* takenBy(const ResidualChannel& one, const MistakenWiring& mistake) const {
        const int recording = prepared_.fitRecordings[static_cast<std::size_t>(one.experiment)];
        if (std::find(mistake.recordings.begin(), mistake.recordings.end(), recording) == mistake.recordings.end())
            return nullptr;
        const int first = prepared_.system->outputIndex(mistake.channels.front()),
                  last = prepared_.system->outputIndex(mistake.channels.back());
        if (one.output != first && one.output != last) return nullptr;
        const int wanted = one.output == first ? last : first;
        const auto at = std::find_if(channels_.begin(), channels_.end(), [&](const ResidualChannel& c) {
            return c.experiment == one.experiment && c.output == wanted;
        });
        return at == channels_.end() ? nullptr : &*at;
    }

    double weightOf(const ResidualChannel& channel) const {
        return prepared_.problem.experiments[static_cast<std::size_t>(channel.experiment)].weights[channel.output];
    }

    const PreparedTask& prepared_;
    std::vector<ResidualChannel> channels_;
    Eigen::VectorXd residuals_;
    std::optional<OrthogonalProjector> beside_;  // its parameters; empty: it cannot be simulated there
};

}  // namespace

EstimationTask readAsMeant(EstimationTask task, const MistakenWiring& mistake) {
    for (const int r : mistake.recordings) takeAsMeant(task.recordings.edit()[static_cast<std::size_t>(r)], mistake);
    return task;
}

Text wiringWords(const EstimationTask& task, const MistakenWiring& mistake) {
    const Recording& first = task.recordings[static_cast<std::size_t>(mistake.recordings.front())];
    const std::string one = nameWithColumn(first, mistake.channels.front()),
                      other = nameWithColumn(first, mistake.channels.back());
    const bool isEverywhere = mistake.recordings.size() == task.recordings.size();
    if (mistake.isOfSign())
        return isEverywhere ? phrase("{} seems to be recorded with the wrong sign", one)
                            : phrase("{} seems to be recorded with the wrong sign in '{}'", one, first.name);
    return isEverywhere ? phrase("{} and {} seem to be exchanged", one, other)
                        : phrase("{} and {} seem to be exchanged in '{}'", one, other, first.name);
}

std::vector<MistakenWiring> mistakenWirings(const NullModel& null, const Variant& given, const FitOptions& options,
                                            const Progress& progress) {
    if (!mayBeMisread(null)) return {};
    const Outcome<PreparedTask> prepared = prepareAt(given, null.noise);
    if (!prepared) return {};
    const System& system = *prepared->system;
    std::vector<MistakenWiring> possible = possibleWirings(given.task, system);
    const SimulatedAsGiven asGiven(*prepared, options.simulation, progress);
    const auto reread = [&](std::size_t number) {
        const MistakenWiring& mistake = possible[number];
        Reread as{given, noiseAsMeant(null, system, mistake)};
        as.variant.task = readAsMeant(given.task, mistake);
        return as;
    };
    const auto isOutput = [&](const std::string& channel) { return system.outputIndex(channel) >= 0; };
    std::vector<PromisingReading> promising;
    for (std::size_t i = 0; i < possible.size(); ++i) {
        if (progress.stopRequested()) return {};
        const std::vector<std::string>& channels = possible[i].channels;
        const bool areOutputs = asGiven.isUsable() && std::all_of(channels.begin(), channels.end(), isOutput);
        promising.push_back(
            {i, areOutputs ? asGiven.left(possible[i]) : promisedLeft(reread(i), options.simulation, progress)});
    }
    std::vector<MistakenWiring> found;
    for (FittedReading& fitted : readingsThatExplain(null, std::move(promising), reread, options, progress)) {
        if (!found.empty() && !leavesAsLittle(fitted.read, found.front().read)) break;
        found.push_back(std::move(possible[fitted.number]));
        found.back().read = std::move(fitted.read);
    }
    return found;
}

}  // namespace analogon
