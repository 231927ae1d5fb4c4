#include "core/base/work.hpp"

#include <cmath>

namespace analogon {

namespace {

thread_local WorkCount* inForce = nullptr;

}  // namespace

WorkCount::WorkCount() : outer_(inForce) { inForce = this; }

WorkCount::~WorkCount() { inForce = outer_; }

WorkScope::WorkScope(WorkCount* count) : outer_(inForce) { inForce = count; }

WorkScope::~WorkScope() { inForce = outer_; }

WorkCount* workInForce() { return inForce; }

void countWork(double steps) {
    const auto whole = std::isfinite(steps) ? std::llround(steps) : 0;
    for (WorkCount* each = inForce; each != nullptr; each = each->outer_)
        each->done_.fetch_add(whole, std::memory_order_relaxed);
}

}  // namespace analogon
