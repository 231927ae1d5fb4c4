#pragma once

#include <algorithm>
#include <ctime>

namespace analogon::test {

/// Processor time that this thread has taken [ms]: what others do on the machine meanwhile is not in it.
inline double workedMilliseconds() {
    timespec spent{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &spent);
    return 1e3 * static_cast<double>(spent.tv_sec) + 1e-6 * static_cast<double>(spent.tv_nsec);
}

/// Least processor time of this thread over several tries [ms]. A busy machine makes the same work slower, up to
/// several times (shared caches and cores, a host that takes the processor away), never faster.
template <typename Work>
double leastMilliseconds(int tries, Work&& work) {
    double least = 1e300;
    for (int i = 0; i < tries; ++i) {
        const double begin = workedMilliseconds();
        work();
        least = std::min(least, workedMilliseconds() - begin);
    }
    return least;
}

}  // namespace analogon::test
