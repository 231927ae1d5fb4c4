#pragma once

#include <QString>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace analogon {
struct ChannelMapping;
struct ChannelName;
struct Column;
struct Table;
}  // namespace analogon

/// How the list of recordings shows channels, clocks and ranges, and how they are typed there.
namespace analogon::ui {

/// What a row of the list holds: its recording, what it is, its signal, its channel, whether it says how long it is.
inline constexpr int experimentRole = Qt::UserRole, kindRole = Qt::UserRole + 1, signalRole = Qt::UserRole + 2,
                     columnRole = Qt::UserRole + 3, extentRole = Qt::UserRole + 4;

/// The column of that name; null: the file has none, or several.
const Column* columnOf(const Table* file, const ChannelName& name);
/// How a channel is called where the file may have several of its name.
QString labelText(const Table* file, const ChannelName& name);
/// The channels of a file that are no stamps.
std::vector<const Column*> channelsOf(const Table& file);
QString withUnit(const std::string& label, const std::string& unit);
QString columnText(const Table* table, const ChannelMapping& mapping);
QString mappingTip(const ChannelMapping& mapping, const QString& file);

QString clockTip(bool isOutput);
QString clockText(const ChannelMapping& mapping);
bool hasOwnClock(const ChannelMapping& mapping);
/// "0.25", "-0,25 s", "37 ms" in seconds; empty: 0.
std::optional<double> readSeconds(const QString& typed);
/// "0.5 … 2.5 s", "0,5 - 2,5", "0.5 2.5". A comma is a decimal sign and divides nothing: "1,5,3" is no range.
std::optional<std::pair<double, double>> readRange(const QString& typed);

}  // namespace analogon::ui
