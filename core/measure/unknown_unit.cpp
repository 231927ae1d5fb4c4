#include "core/measure/unknown_unit.hpp"

#include <algorithm>
#include <cctype>

#include "core/base/unit.hpp"
#include "core/base/unit_alike.hpp"
#include "core/measure/cited.hpp"

namespace analogon {

namespace {

bool isUnknown(const std::string& unit) {
    const bool hasLetter =
        std::any_of(unit.begin(), unit.end(), [](unsigned char c) { return std::isalpha(c) || c >= 0x80; });
    return hasLetter && !isKnownUnit(unit);
}

/// What stands behind a name in round brackets; empty: nothing does.
std::string bracketed(const std::string& name) {
    const std::size_t open = name.rfind('(');
    if (open == std::string::npos || open == 0 || name.back() != ')') return {};
    return name.substr(open + 1, name.size() - open - 2);
}

}  // namespace

std::string unknownUnitOf(const std::string& name, const std::string& unit) {
    if (!unit.empty()) return isUnknown(unit) ? unit : std::string();
    const std::string behind = bracketed(name);
    return isUnknown(behind) && !unitsAlike(behind).empty() ? behind : std::string();
}

namespace {

void addUnit(std::vector<UnknownUnit>& units, const std::string& name, const std::string& unit, int line) {
    const std::string text = unknownUnitOf(name, unit);
    if (text.empty()) return;
    auto known = std::find_if(units.begin(), units.end(), [&](const UnknownUnit& u) { return u.text == text; });
    if (known == units.end()) known = units.insert(units.end(), {text, {}, line});
    known->columns.push_back(name);
}

Text columnNames(const UnknownUnit& unknown) {
    constexpr std::size_t shown = 4;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < std::min(shown, unknown.columns.size()); ++i)
        names.push_back(cited(unknown.columns[i]));
    if (unknown.columns.size() <= shown) return listed(names);
    return phrase("{} and {} more", listed(names), unknown.columns.size() - shown);
}

}  // namespace

std::vector<UnknownUnit> unknownUnits(const Table& table) {
    std::vector<UnknownUnit> units;
    for (const Column& column : table.columns) addUnit(units, column.name, column.unit, column.line);
    for (const auto& other : table.others)
        for (const Column& column : other->columns) addUnit(units, column.name, column.unit, column.line);
    return units;
}

std::vector<UnknownUnit> unknownUnits(const RecordedGroup& group) {
    std::vector<UnknownUnit> units;
    for (const RecordedChannel& channel : group.channels)
        if (channel.kind == ChannelKind::Number) addUnit(units, channel.name, channel.unit, 0);
    return units;
}

Text told(const UnknownUnit& unknown) {
    Text text = phrase("the unit '{}' of {} is not known here", cited(unknown.text), columnNames(unknown));
    const std::vector<std::string> near = unitsAlike(unknown.text);
    if (near.size() == 1) text += phrase(": did you mean '{}'?", near[0]);
    if (near.size() > 1) text += phrase(": did you mean '{}' or '{}'?", near[0], near[1]);
    text +=
        (near.empty() ? ". " : " ") + phrase("Say it in the study: \"read\": {{\"unit_names\": {{\"{}\": \"{}\"}}}}.",
                                             cited(unknown.text), near.empty() ? "…" : near[0]);
    return text;
}

Question askedUnit(const UnknownUnit& unknown, const ReadOptions& options) {
    Question question{Question::Kind::Unit,
                      phrase("Which unit is '{}', of {}?", cited(unknown.text), columnNames(unknown)), unknown.line};
    question.unit = unknown.text;
    const auto addReading = [&](Text label, const std::string& unit) {
        question.readings.push_back({std::move(label), options});
        question.readings.back().options.unitNames[unknown.text] = unit;
    };
    for (const std::string& near : unitsAlike(unknown.text)) addReading(near, near);
    addReading(phrase("no unit, numbers alone"), "1");
    return question;
}

std::string unitMeant(const std::string& name, const std::string& unit, const ReadOptions& options) {
    if (options.unitNames.empty()) return unit;
    const auto told = options.unitNames.find(unit.empty() ? bracketed(name) : unit);
    return told == options.unitNames.end() ? unit : told->second;
}

void nameUnits(Table& table, const ReadOptions& options) {
    for (Column& column : table.columns) column.unit = unitMeant(column.name, column.unit, options);
    for (auto& other : table.others) {
        Table named = *other;
        nameUnits(named, options);
        other = std::make_shared<const Table>(std::move(named));
    }
}

void nameUnits(MeasurementFile& recording, const ReadOptions& options) {
    for (RecordedGroup& group : recording.groups)
        for (RecordedChannel& channel : group.channels) channel.unit = unitMeant(channel.name, channel.unit, options);
}

}  // namespace analogon
