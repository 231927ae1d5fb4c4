#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

namespace analogon {

/// The words of one column. Words that come again are kept once.
class WordSeries {
public:
    std::size_t size() const { return places_.size(); }
    /// Null: an empty cell.
    const std::string* at(std::size_t row) const;
    /// Each word at least once.
    const std::vector<std::string>& distinct() const { return words_; }
    bool hasEmptyCells() const { return hasEmptyCells_; }

    void push(std::string word);
    void pushEmpty();
    void clear() { *this = {}; }
    void reverse() { std::reverse(places_.begin(), places_.end()); }
    /// The rows that are named alone.
    WordSeries only(const std::vector<std::size_t>& rows) const;

private:
    static constexpr std::uint32_t empty = UINT32_MAX;
    std::vector<std::uint32_t> places_;  // in words_, by row
    std::vector<std::string> words_;
    std::unordered_map<std::string, std::uint32_t> known_;  // of the first words: where there are many, few come again
    bool hasEmptyCells_{};
};

}  // namespace analogon
