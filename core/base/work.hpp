#pragma once

#include <atomic>
#include <cstdint>

namespace analogon {

/// Counts what is simulated while it lives, in steps of the explicit method over all columns that are carried along (a
/// trajectory and its tangents): the same on a busy machine, and with any number of threads. parallelFor passes it on.
class WorkCount {
public:
    WorkCount();
    ~WorkCount();
    WorkCount(const WorkCount&) = delete;
    WorkCount& operator=(const WorkCount&) = delete;

    /// What was done so far. The same in every run where it is asked outside of a parallel pass.
    double done() const { return static_cast<double>(done_.load(std::memory_order_relaxed)); }

private:
    friend class WorkScope;
    friend void countWork(double);

    std::atomic<std::int64_t> done_{};
    WorkCount* outer_;
};

/// Counts what another thread does for the work that `count` belongs to; null: for none.
class WorkScope {
public:
    explicit WorkScope(WorkCount* count);
    ~WorkScope();
    WorkScope(const WorkScope&) = delete;
    WorkScope& operator=(const WorkScope&) = delete;

private:
    WorkCount* outer_;
};

/// The innermost count of this thread; null where there is none.
WorkCount* workInForce();

/// Adds to it, and to those around it.
void countWork(double steps);

}  // namespace analogon
