#include "core/study/column_guess.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "core/base/unit.hpp"
#include "core/measure/column_header.hpp"

namespace analogon {

namespace {

using Words = std::vector<std::string>;

/// "T1_exhaustGas" as t, exhaust, gas: lower case, split at digits, marks and capitals.
Words wordsOf(const std::string& name) {
    Words words;
    std::string word;
    const auto close = [&] {
        if (!word.empty()) words.push_back(std::exchange(word, {}));
    };
    for (std::size_t i = 0; i < name.size(); ++i) {
        const auto c = static_cast<unsigned char>(name[i]);
        if (!std::isalpha(c) && c < 0x80) {
            close();
            continue;
        }
        if (std::isupper(c) && i > 0 && std::islower(static_cast<unsigned char>(name[i - 1]))) close();
        word += static_cast<char>(std::tolower(c));
    }
    close();
    return words;
}

bool hasAny(const Words& words, std::initializer_list<const char*> hints) {
    return std::any_of(words.begin(), words.end(), [&](const std::string& word) {
        return std::any_of(hints.begin(), hints.end(), [&](const char* hint) { return word == hint; });
    });
}

/// The unit that a bare name stands for, as "u" or "current".
std::string unitOfWord(const Words& words, const Column& column) {
    if (words.empty()) return {};
    const std::string& first = words.front();
    if (hasAny(words, {"voltage", "volt", "spannung"}) || first == "u" || first == "v") return "V";
    if (hasAny(words, {"current", "strom"}) || first == "i") return "A";
    if (hasAny(words, {"rpm", "drehzahl"})) return "rpm";
    if (hasAny(words, {"omega", "speed"}) || first == "w") return "rad/s";
    if (hasAny(words, {"temp", "temperature", "temperatur"})) {
        // Above 200 a temperature of everyday parts is more likely in kelvin at its lowest value.
        const double lowest = *std::min_element(column.values.begin(), column.values.end());
        return lowest > 200 ? "K" : "degC";
    }
    return {};
}

Quantity quantityOf(const std::string& unit) {
    if (unit.empty() || unit == "1" || unit == "%" || unit == "-") return Quantity::Other;
    constexpr std::array quantities{Quantity::Time,        Quantity::Voltage, Quantity::Current,
                                    Quantity::Temperature, Quantity::Torque,  Quantity::HeatFlow};
    for (const Quantity quantity : quantities)
        if (const auto convert = convertUnit(unit, unitOf(quantity)); convert && std::isfinite(convert->factor))
            return quantity;
    // Angles have no dimension, speeds that of a frequency: only the usual units count.
    for (const char* const angle : {"rad", "deg", "°", "rev", "turn"})
        if (unit == angle) return Quantity::Angle;
    for (const char* const speed : {"rad/s", "rpm", "1/min", "U/min", "rev/min", "deg/s", "°/s", "r/min"})
        if (unit == speed) return Quantity::Speed;
    return Quantity::Other;
}

bool risesStrictly(const std::vector<double>& values) {
    for (std::size_t i = 1; i < values.size(); ++i)
        if (!(values[i] > values[i - 1])) return false;
    return values.size() > 1;
}

bool moves(const std::vector<double>& values) {
    return !values.empty() && std::any_of(values.begin(), values.end(), [&](double v) { return v != values.front(); });
}

bool isTimeName(const Words& words) { return hasAny(words, {"t", "time", "zeit", "timestamp"}); }

/// Index of the time column: rising, and by unit and name; else by name alone; the first rising one when nothing says
/// so.
std::size_t timeColumn(const std::vector<GuessedColumn>& columns) {
    const auto find = [&](const auto& accepts) {
        for (std::size_t i = 0; i < columns.size(); ++i)
            if (risesStrictly(columns[i].values) && accepts(columns[i])) return i;
        return columns.size();
    };
    std::size_t found =
        find([](const GuessedColumn& c) { return c.quantity == Quantity::Time && isTimeName(wordsOf(c.name)); });
    if (found == columns.size()) found = find([](const GuessedColumn& c) { return c.quantity == Quantity::Time; });
    if (found == columns.size())
        found = find([](const GuessedColumn& c) { return c.unit.empty() && isTimeName(wordsOf(c.name)); });
    // What says to be the time and repeats is still the time: a counter beside it would be taken for it otherwise.
    for (std::size_t i = 0; found == columns.size() && i < columns.size(); ++i)
        if (isTimeName(wordsOf(columns[i].name)) &&
            (columns[i].quantity == Quantity::Time || columns[i].unit.empty()) && moves(columns[i].values))
            found = i;
    if (found == columns.size()) found = find([](const GuessedColumn& c) { return c.quantity == Quantity::Other; });
    return found;
}

}  // namespace

const char* unitOf(Quantity quantity) {
    switch (quantity) {
        case Quantity::Time:
            return "s";
        case Quantity::Voltage:
            return "V";
        case Quantity::Current:
            return "A";
        case Quantity::Temperature:
            return "K";
        case Quantity::Speed:
            return "rad/s";
        case Quantity::Angle:
            return "rad";
        case Quantity::Torque:
            return "N.m";
        case Quantity::HeatFlow:
            return "W";
        case Quantity::Other:
            return "1";
    }
    return "1";
}

ChannelMapping GuessedColumn::mapping() const {
    ChannelMapping mapping;
    mapping.column = name;
    if (isUnitAssumed) mapping.unit = unit;
    mapping.group = group;
    return mapping;
}

std::string GuessedColumn::label() const { return fmt::format("'{}'{}", name, unit.empty() ? "" : " [" + unit + "]"); }

std::vector<GuessedColumn> guessColumns(const Table& table) {
    std::vector<GuessedColumn> columns;
    for (const Column& column : table.columns) {
        if (column.values.empty() || !column.blanks.empty()) continue;
        const Words words = wordsOf(column.name);
        GuessedColumn guess;
        guess.name = column.name;
        guess.unit = column.unit;
        if (column.isOnOtherRaster && &column != &table.columns.front()) guess.group = column.groupName();
        if (guess.unit.empty()) {
            guess.unit = unitAtEnd(column.name);
            if (guess.unit.empty()) guess.unit = unitOfWord(words, column);
            guess.isUnitAssumed = !guess.unit.empty();
        }
        guess.quantity = quantityOf(guess.unit);
        guess.isSurroundings =
            hasAny(words, {"exhaust", "ambient", "amb", "air", "coolant", "cool", "water", "gas", "fluid", "oil",
                           "inlet", "env", "surroundings", "medium", "stream", "abgas"});
        guess.isBody = hasAny(words, {"element", "housing", "winding", "wdg", "solid", "body", "plate", "ceramic",
                                      "case", "coil", "heater", "motor", "sensor", "rotor", "stator"});
        guess.isSupply = hasAny(words, {"bat", "batt", "battery", "supply", "board", "net"});
        const Outcome<std::vector<double>> values =
            readChannel(table, guess.mapping(), guess.quantity == Quantity::Other ? "" : unitOf(guess.quantity));
        if (!values) continue;
        guess.values = *values;
        columns.push_back(std::move(guess));
    }
    const std::size_t time = timeColumn(columns);
    for (std::size_t i = 0; i < columns.size(); ++i) {
        if (i == time) {
            if (columns[i].quantity != Quantity::Time) columns[i].isUnitAssumed = false;
            columns[i].quantity = Quantity::Time;
        } else if (columns[i].quantity == Quantity::Time) {
            columns[i].quantity = Quantity::Other;
        }
    }
    if (time < columns.size())
        std::rotate(columns.begin(), columns.begin() + static_cast<std::ptrdiff_t>(time),
                    columns.begin() + static_cast<std::ptrdiff_t>(time) + 1);
    return columns;
}

}  // namespace analogon
