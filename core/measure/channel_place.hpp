#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "core/measure/table.hpp"

/// Where the channels lie that a study names, in a file of one or of several groups.
namespace analogon {

struct ChannelPlace {
    const Table* group{};
    const Column* column{};
};

/// The groups of a file, the first one first.
std::vector<const Table*> tablesOf(const Table& file);

/// The channels of this name: one, none, or several that differ in their groups.
std::vector<ChannelPlace> placesOf(const Table& file, const ChannelName& name);

/// The names of all channels of a file, each once.
std::vector<std::string> namesIn(const Table& file);

/// "Torque", or, where a file has several of that name, "Torque (XCP 1ms)".
std::string labelOf(const Table& file, const Column& column);

/// The channel of such a label.
ChannelName channelOf(const Table& file, const std::string& label);

/// How all channels of a file are called, found out once for files of thousands.
class ChannelLabels {
public:
    explicit ChannelLabels(const Table& file);
    /// As labelOf.
    std::string of(const Column& column) const;
    /// As a study names it.
    ChannelName nameOf(const Column& column) const;

private:
    bool isAlone(const Column& column) const;
    std::unordered_map<std::string, std::size_t> groups_;  // with a channel of this name
};

/// A group as it is called in a message: its name, or its number.
std::string groupLabel(const Column& column);

}  // namespace analogon
