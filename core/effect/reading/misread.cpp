#include "core/effect/reading/misread.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "core/effect/model/evidence.hpp"
#include "core/effect/thresholds.hpp"

namespace analogon {

using namespace threshold::mistakenUnit;

std::optional<ChannelRow> channelRow(const Recording& recording, const std::string& channel) {
    for (const bool isInput : {true, false}) {
        const std::vector<std::string>& names = isInput ? recording.inputNames : recording.outputNames;
        if (const auto at = std::find(names.begin(), names.end(), channel); at != names.end())
            return ChannelRow{isInput, at - names.begin()};
    }
    return std::nullopt;
}

std::string columnBehind(const Recording& recording, const std::string& channel) {
    const auto at = std::find_if(recording.units.begin(), recording.units.end(),
                                 [&](const ChannelUnit& given) { return given.channel == channel; });
    return at == recording.units.end() ? std::string() : at->column;
}

std::string nameWithColumn(const Recording& recording, const std::string& channel) {
    const std::string column = columnBehind(recording, channel);
    return column.empty() ? channel : fmt::format("{} ('{}')", channel, column);
}

std::vector<std::vector<int>> whereMisread(const EstimationTask& task) {
    std::vector<int> all;
    for (std::size_t r = 0; r < task.recordings.size(); ++r) all.push_back(static_cast<int>(r));
    std::vector<std::vector<int>> where{all};
    if (const std::vector<int> fitted = recordingsOf(task, Role::Fit); fitted.size() > 1)
        for (const int one : fitted) where.push_back({one});
    return where;
}

bool mayBeMisread(const NullModel& null) { return !isNoise(null) && excess(null) > leastEvidence; }

bool explainsAll(const NullModel& null, const FitResult& read) {
    const Acceptance gain = examine(null, read, 0, 0);
    if (!gain.accepted() || !(gain.share > leastShare)) return false;
    if (!isNoise(null.channels, read) && !(read.optimum.residuals.squaredNorm() < mostLeft * null.sumOfSquares()))
        return false;
    return std::max(gain.evidence, gain.effective) > leastEvidence;
}

double promisedLeft(const Reread& reread, const SimulationOptions& simulation, const Progress& progress) {
    constexpr double cannotBe = std::numeric_limits<double>::infinity();
    const Outcome<PreparedTask> prepared = prepareAt(reread.variant, reread.noise);
    if (!prepared) return cannotBe;
    const Linearisation at =
        linearise(prepared->problem, prepared->problem.startValues(), true, {}, simulation, progress);
    if (!at.ok || !at.jacobian.allFinite()) return cannotBe;
    return OrthogonalProjector(at.jacobian)(at.residuals).squaredNorm();
}

std::vector<FittedReading> readingsThatExplain(const NullModel& null, std::vector<PromisingReading> promising,
                                               const std::function<Reread(std::size_t)>& reread,
                                               const FitOptions& options, const Progress& progress) {
    std::erase_if(promising, [&](const PromisingReading& p) { return !(p.left < null.sumOfSquares()); });
    std::stable_sort(promising.begin(), promising.end(),
                     [](const PromisingReading& a, const PromisingReading& b) { return a.left < b.left; });
    if (promising.size() > mostFitted) promising.resize(mostFitted);
    std::vector<FittedReading> found;
    for (const PromisingReading& each : promising) {
        const Reread start = reread(each.number);
        Outcome<NullModel> read = fitNull(start.variant, start.noise, NoiseLevel::Keep, options, progress);
        if (!read || progress.stopRequested()) continue;
        if (!explainsAll(null, read->fit)) continue;
        found.push_back({each.number, std::move(*read)});
    }
    std::stable_sort(found.begin(), found.end(), [](const FittedReading& a, const FittedReading& b) {
        return a.read.sumOfSquares() < b.read.sumOfSquares();
    });
    return found;
}

bool leavesAsLittle(const NullModel& read, const NullModel& best) {
    const double rows = static_cast<double>(best.fit.optimum.residuals.size());
    const double variance = best.sumOfSquares() / std::max(1.0, rows - best.parameterCount());
    return independentShare(best, best.fit) * (read.sumOfSquares() - best.sumOfSquares()) <
           equivalenceMargin * variance;
}

}  // namespace analogon
