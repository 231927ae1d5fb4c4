#pragma once

#include <cstdint>
#include <vector>

namespace analogon {

/// From a node's index to a number: open addressing, so that a walk over a small expression in a large pool
/// costs what the expression costs.
class NodeMap {
public:
    /// Whether the key is new; the value of a known key stays.
    bool insert(std::uint32_t key, std::uint32_t value) {
        if (2 * (count_ + 1) > slots_.size()) grow();
        Slot& slot = slots_[locate(key)];
        if (slot.key == key) return false;
        slot = {key, value};
        ++count_;
        return true;
    }
    const std::uint32_t* find(std::uint32_t key) const {
        if (slots_.empty()) return nullptr;
        const Slot& slot = slots_[locate(key)];
        return slot.key == key ? &slot.value : nullptr;
    }

private:
    static constexpr std::uint32_t empty = 0xffffffffu;
    struct Slot {
        std::uint32_t key{empty};
        std::uint32_t value{};
    };

    std::size_t locate(std::uint32_t key) const {
        const std::size_t mask = slots_.size() - 1;
        std::size_t at = (key * 2654435769u) & mask;
        while (slots_[at].key != key && slots_[at].key != empty) at = (at + 1) & mask;
        return at;
    }
    void grow() {
        std::vector<Slot> old(slots_.empty() ? 32 : slots_.size() * 2);
        old.swap(slots_);
        for (const Slot& slot : old)
            if (slot.key != empty) slots_[locate(slot.key)] = slot;
    }

    std::vector<Slot> slots_;
    std::size_t count_{};
};

}  // namespace analogon
