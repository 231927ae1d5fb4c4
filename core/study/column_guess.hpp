#pragma once

#include <string>
#include <vector>

#include "core/measure/channel.hpp"

/// What the columns of a measurement are likely to be, from their units and names.
namespace analogon {

enum class Quantity { Time, Voltage, Current, Temperature, Speed, Angle, Torque, HeatFlow, Other };

/// SI unit in which a model carries the quantity; "1" for Other.
const char* unitOf(Quantity quantity);

struct GuessedColumn {
    std::string name;
    std::string unit;      // as used; empty: none known
    bool isUnitAssumed{};  // the header gives none: taken from the name
    Quantity quantity{Quantity::Other};
    bool isSurroundings{};       // a temperature named after a medium: exhaust, ambient, coolant …
    bool isBody{};               // a temperature named after a part: element, housing, winding …
    bool isSupply{};             // of the board net or battery
    std::vector<double> values;  // in unitOf(quantity)
    GroupName group{};           // of a file that has several

    /// Column and, where assumed, unit.
    ChannelMapping mapping() const;
    /// "'T_exhaust' [degC]"
    std::string label() const;
};

/// One entry per column that can be read (complete, with a unit that fits), in the order of the file. Exactly one has
/// Quantity::Time, the first, unless no column rises strictly.
std::vector<GuessedColumn> guessColumns(const Table& table);

}  // namespace analogon
