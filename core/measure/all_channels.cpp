#include "core/measure/all_channels.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/unit.hpp"
#include "core/measure/channel_place.hpp"
#include "core/measure/common_raster.hpp"

namespace analogon {

namespace {

double spanOf(const Table& group) {
    if (!group.time || group.rows() < 2) return 0;
    const Column& time = group.columns[*group.time];
    if (time.values.empty()) return 0;
    const Outcome<UnitConversion> seconds = convertUnit(time.unit.empty() ? "s" : time.unit, "s");
    return seconds ? (*seconds)(time.values.back()) - (*seconds)(time.values.front()) : 0.0;
}

/// The groups that were recorded for as long as the longest one.
std::vector<const Table*> longGroups(const Table& file) {
    constexpr double share = 0.9;
    double longest = 0;
    for (const Table* const group : tablesOf(file)) longest = std::max(longest, spanOf(*group));
    std::vector<const Table*> groups = tablesOf(file);
    std::erase_if(groups, [&](const Table* group) { return longest == 0 || spanOf(*group) < share * longest; });
    return groups;
}

}  // namespace

Outcome<std::shared_ptr<const Table>> allOnOneRaster(const std::shared_ptr<const Table>& file) {
    if (isOnOneRaster(*file)) return file;
    RasterRequest request;
    for (const Table* const group : longGroups(*file)) {
        const Column& time = group->columns[*group->time];
        if (request.time.column.empty()) request.time.column = time.name;
        for (const Column& column : group->columns) {
            const bool hasNumber =
                std::any_of(column.values.begin(), column.values.end(), [](double v) { return std::isfinite(v); });
            if (&column == &time || !hasNumber) continue;
            request.inputs.push_back(
                {{column.name, column.groupName()}, column.isHeld ? Interpolation::Hold : Interpolation::Linear});
        }
    }
    return onCommonRaster(file, request);
}

Table namesOfAll(const Table& file) {
    Table names;
    names.file = file.file;
    for (const Table* const group : longGroups(file))
        for (const Column& from : group->columns) {
            if (&from == &group->columns[*group->time]) continue;
            Column column{from.name, from.unit, {}, {}, from.header, from.line, from.position};
            column.isHeld = from.isHeld;
            column.isOnOtherRaster = true;
            column.group = from.group;
            column.groupNumber = from.groupNumber;
            names.columns.push_back(std::move(column));
        }
    return names;
}

Table onlyChannels(const Table& file, const std::set<std::string>& names) {
    std::vector<Table> kept;
    for (const Table* const group : tablesOf(file)) {
        Table table;
        table.file = group->file;
        table.lines = group->lines;
        table.source = group->source;
        bool isAny = false;
        for (std::size_t i = 0; i < group->columns.size(); ++i) {
            const bool isTime = group->time == i, isNamed = names.contains(group->columns[i].name);
            if (isTime) table.time = table.columns.size();
            if (isTime || isNamed) table.columns.push_back(group->columns[i]);
            isAny = isAny || (isNamed && !isTime);
        }
        if (isAny) kept.push_back(std::move(table));
    }
    if (kept.empty()) return {};
    Table first = std::move(kept.front());
    for (std::size_t i = 1; i < kept.size(); ++i)
        first.others.push_back(std::make_shared<const Table>(std::move(kept[i])));
    return first;
}

}  // namespace analogon
