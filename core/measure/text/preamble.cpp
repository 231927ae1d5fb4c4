#include "core/measure/text/preamble.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "core/base/unit.hpp"
#include "core/measure/column_header.hpp"
#include "core/measure/text/stamp.hpp"

namespace analogon {

namespace {

template <std::size_t N>
bool isOneOf(const std::string& key, const std::array<std::string_view, N>& keys) {
    return !key.empty() && std::find(keys.begin(), keys.end(), key) != keys.end();
}

constexpr std::array<std::string_view, 27> intervalKeys{"sample interval",
                                                        "sampling interval",
                                                        "interval",
                                                        "increment",
                                                        "x increment",
                                                        "xincrement",
                                                        "xinc",
                                                        "x inc",
                                                        "tinc",
                                                        "t inc",
                                                        "delta x",
                                                        "delta t",
                                                        "dx",
                                                        "dt",
                                                        "sample period",
                                                        "sampling period",
                                                        "sample time",
                                                        "sampling time",
                                                        "time increment",
                                                        "time step",
                                                        "abtastintervall",
                                                        "abtastzeit",
                                                        "hresolution",
                                                        "h resolution",
                                                        "x resolution",
                                                        "time per sample",
                                                        "sampletime"};
constexpr std::array<std::string_view, 15> rateKeys{
    "sample rate",        "sampling rate",    "samplerate", "rate",      "sampling frequency",
    "sample frequency",   "abtastrate",       "scan rate",  "fs",        "abtastfrequenz",
    "samples per second", "acquisition rate", "messrate",   "data rate", "logging rate"};
constexpr std::array<std::string_view, 14> startKeys{"start",   "x0",       "x origin", "xorigin", "t0",
                                                     "hoffset", "h offset", "x start",  "xstart",  "first sample time",
                                                     "start x", "tstart",   "t start",  "x offset"};
constexpr std::array<std::string_view, 11> timeUnitKeys{
    "horizontal units", "horizontal unit", "x unit",    "x units",    "xunit", "xunits", "hunit",
    "h unit",           "x unit label",    "time unit", "zeiteinheit"};
constexpr std::array<std::string_view, 16> unitKeys{"vertical units", "vertical unit", "unit",          "units",
                                                    "y unit label",   "y unit",        "y units",       "yunit",
                                                    "vunit",          "v unit",        "symbolunit",    "symbol unit",
                                                    "einheit",        "einheiten",     "channel units", "channel unit"};
constexpr std::array<std::string_view, 20> commentKeys{
    "source",      "label",        "labels",      "comment",   "comments",   "description",  "descriptions",
    "kommentar",   "beschreibung", "bezeichnung", "name",      "names",      "channel name", "channel names",
    "signal name", "signal",       "trace name",  "tracename", "messstelle", "channel label"};
constexpr std::array<std::string_view, 22> dateKeys{
    "date",           "datum",        "start date",   "test date",       "date time",
    "datetime",       "trigger time", "trigger date", "start time",      "startzeit",
    "time",           "uhrzeit",      "zeit",         "timestamp",       "messbeginn",
    "beginn",         "startdatum",   "recorded",     "recording start", "start of recording",
    "start datetime", "start"};

bool namesFact(const std::string& key) {
    return isOneOf(key, intervalKeys) || isOneOf(key, startKeys) || isOneOf(key, rateKeys);
}

/// Values of another kind that begin with the same words ("10 kSa/s").
std::string usualUnit(std::string_view unit) {
    const std::string text(withoutBlanks(unit));
    for (const std::string_view samples : {"Sa/s", "S/s", "Samples/s", "samples/s", "SPS", "sps", "samples/second"})
        if (text.ends_with(samples) && text.size() <= samples.size() + 1)
            return text.substr(0, text.size() - samples.size()) + "Hz";
    return text;
}

}  // namespace

std::string plainKey(std::string_view text) {
    std::string key;
    const std::string name = readColumnHeader(withoutBlanks(text)).name;
    for (const char c : inLowerCase(name)) {
        const bool isMark = !std::isalnum(static_cast<unsigned char>(c)) && (c & 0x80) == 0;
        if (!isMark)
            key += c;
        else if (!key.empty() && key.back() != ' ')
            key += ' ';
    }
    if (key.ends_with(' ')) key.pop_back();
    return key;
}

bool isKeyOfNames(std::string_view text) {
    constexpr std::array<std::string_view, 14> keys{
        "name",      "names", "channel name", "channel names", "signal",    "signal name", "trace name",
        "tracename", "kanal", "channel",      "channels",      "parameter", "messstelle",  "channel label"};
    return isOneOf(plainKey(text), keys);
}

bool isFactKey(std::string_view text) { return namesFact(plainKey(text)); }

bool isKeyOfPreamble(const SampleRow& row) {
    if (row.filled < 2) return false;
    const std::string key = plainKey(row.cells[0].text);
    const bool isValue = row.kinds[1] == CellKind::Number || row.kinds[1] == CellKind::Quantity;
    if (namesFact(key)) return isValue;
    if (isOneOf(key, dateKeys)) return row.kinds[1] == CellKind::Stamp;
    if (isOneOf(key, timeUnitKeys)) return true;
    return isOneOf(key, unitKeys);
}

std::optional<std::pair<std::string_view, std::string_view>> keyAndValue(std::string_view text) {
    std::size_t mark = text.find('=');
    if (mark == std::string_view::npos) mark = text.find(':');
    if (mark == std::string_view::npos || mark == 0) return std::nullopt;
    return std::pair{withoutBlanks(text.substr(0, mark)), withoutBlanks(text.substr(mark + 1))};
}

std::optional<ToldNumber> PreambleReader::number(std::string_view key, std::string_view value) const {
    value = withoutBlanks(value);
    std::size_t end = std::min(value.find_first_not_of("0123456789.,+-eE"), value.size());
    if (end > 0 && end < value.size() && (value[end - 1] == 'e' || value[end - 1] == 'E')) --end;
    for (const char decimal : {decimal_, '.', ','}) {
        const CellValue read = readCell(value.substr(0, end), decimal);
        if (read.kind != CellValue::Kind::Number) continue;
        std::string unit = usualUnit(value.substr(end));
        if (unit.empty()) unit = usualUnit(readColumnHeader(withoutBlanks(key)).unit);
        return ToldNumber{read.value, unit};
    }
    return std::nullopt;
}

bool PreambleReader::addNumber(std::string_view key, std::string_view value) {
    const std::string plain = plainKey(key);
    const bool isInterval = isOneOf(plain, intervalKeys), isRate = isOneOf(plain, rateKeys);
    if (!isInterval && !isRate && !isOneOf(plain, startKeys)) return false;
    const std::optional<ToldNumber> told = number(key, value);
    if (!told) return false;
    if (!isInterval && !isRate) {
        if (!facts_.start) facts_.start = told;
        return true;
    }
    if (!(told->value > 0)) return true;
    // "Interval: 100 Hz" is a rate, "rate: 10 ms" an interval
    const bool isPerTime = told->unit.empty() ? isRate : areConvertible(told->unit, "Hz");
    std::optional<ToldNumber>& fact = isPerTime ? facts_.rate : facts_.interval;
    if (fact && fact->value != told->value) facts_.hasSeveralIntervals = true;
    if (!fact) fact = told;
    return true;
}

bool PreambleReader::addStart(const std::string& key, std::string_view value) {
    if (!isOneOf(key, dateKeys)) return false;
    const std::optional<Stamp> stamp = readStamp(value);
    if (!stamp) return false;
    const std::optional<Stamp> known = readStamp(facts_.startText);
    if (known && ((known->hasDate() && stamp->hasDate()) || (known->hasClock && stamp->hasClock))) return true;
    if (facts_.startText.size() < 60) facts_.startText += (facts_.startText.empty() ? "" : " ") + std::string(value);
    return true;
}

bool PreambleReader::addPair(std::string_view key, std::string_view value) {
    if (addNumber(key, value)) return true;
    const std::string plain = plainKey(key);
    if (addStart(plain, withoutBlanks(value))) return true;
    if (!isOneOf(plain, timeUnitKeys) || value.empty()) return false;
    facts_.timeUnit = readUnitCell(value);
    return true;
}

void PreambleReader::addByColumn(const SampleRow& row, std::vector<std::string>& texts) const {
    const bool isPaired = columns_ >= 4 && row.filled >= 3 && row.cells[0].text == row.cells[2].text;
    const std::size_t shift = row.filled == columns_ + 1 ? 1 : 0;
    // one value for several columns tells nothing of any ("unit,ms")
    if (columns_ > 2 && row.filled == 2) return;
    texts.resize(columns_);
    for (std::size_t i = isPaired ? 1 : 1 - shift; i < columns_; i += isPaired ? 2 : 1)
        if (i + shift < row.cells.size() && texts[i].empty()) {
            const auto pair = keyAndValue(row.cells[i + shift].text);  // "CH1:V"
            texts[i] = pair ? std::string(pair->second) : row.cells[i + shift].text;
        }
}

void PreambleReader::add(const SampleRow& row) {
    if (row.filled == 0) return;
    const std::string_view first = row.cells[0].text;
    const std::string key = plainKey(first);
    if (row.filled == 1) {
        if (const auto pair = keyAndValue(first)) addPair(pair->first, pair->second);
        return;
    }
    if (isOneOf(key, unitKeys)) return addByColumn(row, facts_.units);
    if (isOneOf(key, commentKeys)) return addByColumn(row, facts_.comments);
    if (addNumber(first, row.cells[1].text)) {
        for (std::size_t i = 2; i < row.filled; ++i) addNumber(first, row.cells[i].text);
        return;
    }
    if (addPair(first, row.cells[1].text)) return;
    for (const CsvCell& cell : row.cells)
        if (const auto pair = keyAndValue(cell.text)) addPair(pair->first, pair->second);
}

void PreambleReader::addComment(std::string_view line) {
    const std::size_t first = line.find_first_not_of(" \t#%/;");
    if (first == std::string_view::npos) return;
    if (const auto pair = keyAndValue(line.substr(first))) addPair(pair->first, pair->second);
}

}  // namespace analogon
