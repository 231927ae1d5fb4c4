#pragma once

#include <atomic>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <utility>
#include <vector>

#include "core/fit/recording.hpp"

namespace analogon {

/// The recordings of a task. Copies share them until one is edited: a search keeps hundreds of models of the same
/// recordings.
class Recordings {
public:
    using value_type = Recording;
    using const_iterator = std::vector<Recording>::const_iterator;
    using iterator = const_iterator;

    Recordings() = default;
    Recordings(std::vector<Recording> all) : all_(std::make_shared<std::vector<Recording>>(std::move(all))) {}
    Recordings(std::initializer_list<Recording> all) : Recordings(std::vector<Recording>(all)) {}

    const std::vector<Recording>& all() const;
    operator const std::vector<Recording>&() const { return all(); }
    const_iterator begin() const { return all().begin(); }
    const_iterator end() const { return all().end(); }
    std::size_t size() const { return all().size(); }
    bool empty() const { return all().empty(); }
    const Recording& operator[](std::size_t index) const { return all()[index]; }
    const Recording& front() const { return all().front(); }
    const Recording& back() const { return all().back(); }

    /// Those of this task alone, to be changed; what was referred to before stays with the copies.
    std::vector<Recording>& edit();
    void push_back(Recording recording) { edit().push_back(std::move(recording)); }
    void clear() { all_.reset(); }

private:
    std::shared_ptr<std::vector<Recording>> all_;  // null: none
};

}  // namespace analogon
