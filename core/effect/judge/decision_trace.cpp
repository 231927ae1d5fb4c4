#include "core/effect/judge/decision_trace.hpp"

namespace analogon {

void DecisionTrace::add(Decision decision) {
    const std::lock_guard lock(guard_);
    decisions_.push_back(std::move(decision));
}

std::vector<Decision> DecisionTrace::decisions() const {
    const std::lock_guard lock(guard_);
    return decisions_;
}

}  // namespace analogon
