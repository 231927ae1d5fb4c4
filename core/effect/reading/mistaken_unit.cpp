#include "core/effect/reading/mistaken_unit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "core/base/unit.hpp"
#include "core/effect/reading/misread.hpp"

namespace analogon {
namespace {

/// What test benches record in, by kind, the commoner first: every other one of the same kind may be meant.
constexpr std::array<const char*, 27> commonUnits{"K",   "degC", "degF", "rad/s", "rpm", "deg/s", "rad", "deg", "A",
                                                  "mA",  "V",    "mV",   "W",     "kW",  "Nm",    "mNm", "N",   "kN",
                                                  "m/s", "km/h", "m",    "mm",    "Pa",  "kPa",   "hPa", "bar", "g/s"};

bool isSame(const UnitConversion& a, const UnitConversion& b) {
    return std::abs(a.factor - b.factor) < 1e-9 * std::abs(b.factor) && std::abs(a.offset - b.offset) < 1e-9;
}

/// What turns a value that was read in one unit into what it is in another.
std::optional<UnitConversion> rereading(const ChannelUnit& given, const std::string& likely) {
    const Outcome<UnitConversion> asGiven = convertUnit(given.unit, given.modelUnit),
                                  asLikely = convertUnit(likely, given.modelUnit);
    if (!asGiven || !asLikely || isSame(*asGiven, *asLikely)) return std::nullopt;
    const double factor = asLikely->factor / asGiven->factor;
    return UnitConversion{factor, asLikely->offset - factor * asGiven->offset};
}

bool isAmong(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

void readAsLikely(Recording& recording, const MistakenUnit& mistake) {
    std::set<std::string> columns;  // whose start values are done: several channels may be read from one
    for (const ChannelUnit& given : recording.units) {
        if (!mistake.concerns(given)) continue;
        const std::optional<UnitConversion> again = rereading(given, mistake.likely);
        if (!again) continue;
        if (const std::optional<ChannelRow> channel = channelRow(recording, given.channel))
            channel->of(recording) = channel->of(recording).unaryExpr(*again).eval();
        if (!columns.insert(given.column).second) continue;
        for (RecordingStart& start : recording.starts)
            if (start.column == given.column) start.value = (*again)(start.value);
    }
}

/// Every column, and all of one unit together, in every other common unit: in all recordings that say so, and, where
/// several are fitted, in each alone.
std::vector<MistakenUnit> possibleMistakes(const EstimationTask& task) {
    std::vector<MistakenUnit> mistakes;
    const auto add = [&](const std::vector<int>& recordings, const std::vector<const ChannelUnit*>& given) {
        MistakenUnit mistake;
        mistake.recordings = recordings;
        mistake.unit = given.front()->unit;
        for (const ChannelUnit* each : given) {
            if (!isAmong(mistake.columns, each->column)) mistake.columns.push_back(each->column);
            mistake.channels.push_back(each->channel);
        }
        for (const char* likely : commonUnits) {
            if (!rereading(*given.front(), likely)) continue;
            mistakes.push_back(mistake);
            mistakes.back().likely = likely;
        }
    };
    for (const std::vector<int>& recordings : whereMisread(task)) {
        std::map<std::pair<std::string, std::string>, std::vector<const ChannelUnit*>> byColumn;
        std::map<std::string, std::vector<const ChannelUnit*>> byUnit;
        for (const int r : recordings)
            for (const ChannelUnit& given : task.recordings[static_cast<std::size_t>(r)].units) {
                std::vector<const ChannelUnit*>& same = byColumn[{given.unit, given.column}];
                const auto isKnown = [&](const ChannelUnit* each) { return each->channel == given.channel; };
                if (std::any_of(same.begin(), same.end(), isKnown)) continue;
                same.push_back(&given);
                byUnit[given.unit].push_back(&given);
            }
        for (const auto& [name, given] : byColumn) add(recordings, given);
        for (const auto& [unit, given] : byUnit)
            if (byColumn[{unit, given.front()->column}].size() < given.size()) add(recordings, given);
    }
    return mistakes;
}

/// The noise of the outputs in the likely unit: where a reading is another one by a factor, so is its noise.
std::vector<Eigen::VectorXd> noiseRead(const NullModel& null, const MistakenUnit& mistake) {
    std::vector<Eigen::VectorXd> noise = null.noise;
    const Outcome<PreparedTask> prepared = prepareHeld(null.variant, {}, null.noise);
    if (!prepared) return noise;
    for (const int r : mistake.recordings)
        for (const ChannelUnit& given : null.variant.task.recordings[static_cast<std::size_t>(r)].units) {
            if (!mistake.concerns(given)) continue;
            const std::optional<UnitConversion> again = rereading(given, mistake.likely);
            const int output = prepared->system->outputIndex(given.channel);
            Eigen::VectorXd& own = noise[static_cast<std::size_t>(r)];
            if (again && output >= 0 && output < own.size()) own[output] *= std::abs(again->factor);
        }
    return noise;
}

std::size_t rarity(const std::string& unit) {
    return static_cast<std::size_t>(std::find(commonUnits.begin(), commonUnits.end(), unit) - commonUnits.begin());
}

/// Whether both are about the same numbers.
bool isOfSameNumbers(const MistakenUnit& a, const MistakenUnit& b) {
    return a.recordings == b.recordings && a.columns == b.columns;
}

/// The first, which leaves least; of units for the same numbers that leave as little, the commonest, with the others.
std::optional<MistakenUnit> likeliest(std::vector<MistakenUnit> found) {
    if (found.empty()) return std::nullopt;
    std::vector<MistakenUnit> alike;
    for (MistakenUnit& each : found)
        if (alike.empty() || (isOfSameNumbers(each, alike.front()) && leavesAsLittle(each.read, alike.front().read)))
            alike.push_back(std::move(each));
    std::stable_sort(alike.begin(), alike.end(),
                     [](const MistakenUnit& a, const MistakenUnit& b) { return rarity(a.likely) < rarity(b.likely); });
    MistakenUnit first = std::move(alike.front());
    for (std::size_t i = 1; i < alike.size(); ++i) first.asLikely.push_back(alike[i].likely);
    return first;
}

}  // namespace

bool MistakenUnit::concerns(const ChannelUnit& given) const {
    return given.unit == unit && isAmong(columns, given.column);
}

EstimationTask readAsLikely(EstimationTask task, const MistakenUnit& mistake) {
    for (const int r : mistake.recordings) readAsLikely(task.recordings.edit()[static_cast<std::size_t>(r)], mistake);
    return task;
}

Text channelWords(const EstimationTask& task, const MistakenUnit& mistake) {
    const Recording& first = task.recordings[static_cast<std::size_t>(mistake.recordings.front())];
    std::vector<std::string> names;
    for (const std::string& channel : mistake.channels)
        if (!columnBehind(first, channel).empty()) names.push_back(nameWithColumn(first, channel));
    if (mistake.recordings.size() == task.recordings.size()) return listed(names);
    return phrase("{} in '{}'", listed(names), first.name);
}

std::optional<MistakenUnit> mistakenUnit(const NullModel& null, const Variant& given, const FitOptions& options,
                                         const Progress& progress) {
    if (!mayBeMisread(null)) return std::nullopt;
    std::vector<MistakenUnit> possible = possibleMistakes(given.task);
    const auto reread = [&](std::size_t number) {
        const MistakenUnit& mistake = possible[number];
        Reread as{given, noiseRead(null, mistake)};
        as.variant.task = readAsLikely(given.task, mistake);
        return as;
    };
    std::vector<PromisingReading> promising;
    for (std::size_t i = 0; i < possible.size(); ++i) {
        if (progress.stopRequested()) return std::nullopt;
        promising.push_back({i, promisedLeft(reread(i), options.simulation, progress)});
    }
    std::vector<MistakenUnit> found;
    for (FittedReading& fitted : readingsThatExplain(null, std::move(promising), reread, options, progress)) {
        found.push_back(std::move(possible[fitted.number]));
        found.back().read = std::move(fitted.read);
    }
    return likeliest(std::move(found));
}

}  // namespace analogon
