#pragma once

#include <functional>

namespace analogon {

/// As many as are asked for; of 0, as many as the machine has.
int threadCount(int threads);

/// Runs body(0) … body(count - 1) on up to `threads` threads (as threadCount). Tasks are taken in
/// order; a result must depend on the index alone, never on the thread. An exception of a task is rethrown here
/// once all threads have ended.
void parallelFor(int count, int threads, const std::function<void(int)>& body);

}  // namespace analogon
