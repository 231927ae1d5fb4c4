#include "core/measure/channel_place.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>

namespace analogon {

std::vector<const Table*> tablesOf(const Table& file) {
    std::vector<const Table*> tables{&file};
    for (const std::shared_ptr<const Table>& other : file.others) tables.push_back(other.get());
    return tables;
}

std::vector<ChannelPlace> placesOf(const Table& file, const ChannelName& name) {
    std::vector<ChannelPlace> places;
    for (const Table* const group : tablesOf(file))
        if (const Column* const column = group->find(name.column, name.group)) places.push_back({group, column});
    return places;
}

std::vector<std::string> namesIn(const Table& file) {
    std::vector<std::string> names;
    std::set<std::string_view> known;
    for (const Table* const group : tablesOf(file))
        for (const Column& column : group->columns)
            if (known.insert(column.name).second) names.push_back(column.name);
    return names;
}

ChannelLabels::ChannelLabels(const Table& file) {
    for (const Table* const group : tablesOf(file)) {
        std::set<std::string_view> known;
        for (const Column& column : group->columns)
            if (known.insert(column.name).second) ++groups_[column.name];
    }
}

bool ChannelLabels::isAlone(const Column& column) const {
    const auto found = groups_.find(column.name);
    return found == groups_.end() || found->second < 2;
}

std::string ChannelLabels::of(const Column& column) const {
    return isAlone(column) ? column.name : fmt::format("{} ({})", column.name, groupLabel(column));
}

ChannelName ChannelLabels::nameOf(const Column& column) const {
    return isAlone(column) ? ChannelName{column.name, {}} : ChannelName{column.name, column.groupName()};
}

std::string groupLabel(const Column& column) {
    return column.group.empty() ? std::to_string(column.groupNumber) : column.group;
}

std::string labelOf(const Table& file, const Column& column) {
    const std::vector<const Table*> tables = tablesOf(file);
    const auto count = std::count_if(tables.begin(), tables.end(),
                                     [&](const Table* table) { return table->find(column.name) != nullptr; });
    return count < 2 ? column.name : fmt::format("{} ({})", column.name, groupLabel(column));
}

ChannelName channelOf(const Table& file, const std::string& label) {
    for (const Table* const group : tablesOf(file))
        for (const Column& column : group->columns) {
            if (!label.starts_with(column.name) || labelOf(file, column) != label) continue;
            if (label == column.name) return {label, {}};
            return {column.name, column.groupName()};
        }
    return {label, {}};
}

}  // namespace analogon
