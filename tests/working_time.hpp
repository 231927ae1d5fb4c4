#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <ctime>

namespace analogon::test {

/// Processor time that this thread has taken [ms]: what others do on the machine meanwhile is not in it.
inline double workedMilliseconds() {
    timespec spent{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &spent);
    return 1e3 * static_cast<double>(spent.tv_sec) + 1e-6 * static_cast<double>(spent.tv_nsec);
}

/// What has passed for this thread [ms]: its work and what it waited for, without the time in which it was ready and
/// other programs had the processor. Only this is what a stall is made of, however busy the machine is. Of one thread
/// of a program: the first that asks.
inline double ownMilliseconds() {
    static const int schedule = open("/proc/thread-self/schedstat", O_RDONLY);
    timespec passed{};
    clock_gettime(CLOCK_MONOTONIC, &passed);
    char text[128] = "";
    double run = 0, queued = 0;  // [ns]
    if (pread(schedule, text, sizeof text - 1, 0) > 0) std::sscanf(text, "%lf %lf", &run, &queued);
    return 1e3 * static_cast<double>(passed.tv_sec) + 1e-6 * (static_cast<double>(passed.tv_nsec) - queued);
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
