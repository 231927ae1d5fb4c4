#include "tests/bench/speed/measuring.hpp"

#include <malloc.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <fstream>

namespace analogon::speed {

double now() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

double timed(double budget, const std::function<void()>& work) {
    double best = 1e300;
    const double end = now() + budget;
    for (int i = 0; i < 3 || now() < end; ++i) {
        const double begin = now();
        work();
        best = std::min(best, now() - begin);
        if (best > budget) break;
    }
    return best;
}

double memory(const std::string& name) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with(name + ":")) return std::atof(line.c_str() + name.size() + 1) / 1024;
    return 0;
}

double peakMemory(const std::function<void()>& work) {
    malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << "5";  // the peak starts again
    const double before = memory("VmRSS");
    work();
    return memory("VmHWM") - before;
}

}  // namespace analogon::speed
