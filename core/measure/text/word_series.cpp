#include "core/measure/text/word_series.hpp"

#include <utility>

namespace analogon {

const std::string* WordSeries::at(std::size_t row) const {
    return places_[row] == empty ? nullptr : &words_[places_[row]];
}

void WordSeries::push(std::string word) {
    constexpr std::size_t mostKnown = 10'000;
    const auto next = static_cast<std::uint32_t>(words_.size());
    if (const auto known = known_.find(word); known != known_.end()) {
        places_.push_back(known->second);
        return;
    }
    if (known_.size() < mostKnown) known_.emplace(word, next);
    words_.push_back(std::move(word));
    places_.push_back(next);
}

void WordSeries::pushEmpty() {
    places_.push_back(empty);
    hasEmptyCells_ = true;
}

WordSeries WordSeries::only(const std::vector<std::size_t>& rows) const {
    WordSeries chosen;
    chosen.places_.reserve(rows.size());
    for (const std::size_t row : rows)
        if (const std::string* const word = at(row))
            chosen.push(*word);
        else
            chosen.pushEmpty();
    return chosen;
}

}  // namespace analogon
