#include "core/base/limits.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <limits>

namespace analogon::limits {

namespace {

/// What a file holds in its first line as a number; the largest one where it holds none ("max").
std::uint64_t numberIn(const char* file) {
    std::ifstream stream(file);
    std::uint64_t number = 0;
    return stream >> number ? number : std::numeric_limits<std::uint64_t>::max();
}

std::uint64_t memoryOfMachine() {
    const auto pages = static_cast<std::uint64_t>(std::max(1L, sysconf(_SC_PHYS_PAGES)));
    const auto page = static_cast<std::uint64_t>(std::max(1L, sysconf(_SC_PAGESIZE)));
    // control groups, versions 2 and 1
    return std::min(
        {pages * page, numberIn("/sys/fs/cgroup/memory.max"), numberIn("/sys/fs/cgroup/memory/memory.limit_in_bytes")});
}

}  // namespace

std::uint64_t memory() {
    if (const char* told = std::getenv("ANALOGON_MEMORY"); told && std::atof(told) > 0)
        return static_cast<std::uint64_t>(std::atof(told) * 1048576.0);
    static const std::uint64_t machine = memoryOfMachine();
    return machine;
}

Outcome<Done> checkMemory(const Text& what, double bytes) {
    constexpr double share = 0.75;
    const double available = static_cast<double>(memory());
    if (bytes <= share * available) return Done{};
    constexpr double gigabyte = 1073741824.0;
    return fileError(phrase("{} would take {:.3g} GB of memory, of {:.3g} GB that the machine has", what,
                            bytes / gigabyte, available / gigabyte),
                     {}, 0, 0,
                     phrase("Use a part of the recordings (\"range\"), fewer of their rows, or fit fewer parameters."));
}

}  // namespace analogon::limits
