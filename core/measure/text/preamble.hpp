#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/measure/text/dialect.hpp"

/// What the lines in front of a table say about it: lines of a key and its values, whoever wrote them.
namespace analogon {

/// A number as it is told, in the unit that stands beside it.
struct ToldNumber {
    double value{};
    std::string unit;  // empty: none given
};

struct PreambleFacts {
    std::optional<ToldNumber> interval;        // from one row to the next
    std::optional<ToldNumber> rate;            // rows in a second
    std::optional<ToldNumber> start;           // time of the first row
    bool hasSeveralIntervals{};                // channels differ in it
    std::string timeUnit;                      // of the first column or of what is counted
    std::vector<std::string> units, comments;  // by column; may be shorter
    std::string startText;                     // date and clock of the start as they stand, one behind the other
};

/// A key without its marks and in small letters: "Delta_X" and "delta x:" are one.
std::string plainKey(std::string_view text);

/// Whether a cell of the header is the name of a fact and not of a column ("Increment", "Start").
bool isFactKey(std::string_view text);

/// The key of a row of names ("Name", "Kanal").
bool isKeyOfNames(std::string_view text);

/// A key of the preamble with its values, though it is as long as the rows of the table.
bool isKeyOfPreamble(const SampleRow& row);

class PreambleReader {
public:
    PreambleReader(std::size_t columns, char decimal) : columns_(columns), decimal_(decimal) {}

    void add(const SampleRow& row);
    void addComment(std::string_view line);
    /// One key with one value: "t0 = -0.002". False where the key says nothing about the table.
    bool addPair(std::string_view key, std::string_view value);
    const PreambleFacts& facts() const { return facts_; }

private:
    bool addNumber(std::string_view key, std::string_view value);
    bool addStart(const std::string& key, std::string_view value);
    void addByColumn(const SampleRow& row, std::vector<std::string>& texts) const;
    std::optional<ToldNumber> number(std::string_view key, std::string_view value) const;

    std::size_t columns_;
    char decimal_;
    PreambleFacts facts_;
};

/// "key = value" or "key: value" in one cell; none where there is no such mark.
std::optional<std::pair<std::string_view, std::string_view>> keyAndValue(std::string_view text);

}  // namespace analogon
