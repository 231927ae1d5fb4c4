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

constexpr double bytesOfNumber = sizeof(double);

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

Outcome<Done> checkMemory(const Text& what, double bytes, const Text& remedy) {
    constexpr double share = 0.75;
    const double available = static_cast<double>(memory());
    if (bytes <= share * available) return Done{};
    constexpr double gigabyte = 1073741824.0;
    return fileError(phrase("{} would take {:.3g} GB of memory, of {:.3g} GB that the machine has", what,
                            bytes / gigabyte, available / gigabyte),
                     {}, 0, 0, remedy);
}

Outcome<Done> checkTable(double rowCount, std::size_t columnCount, double cells, double textBytes) {
    return checkMemory(phrase("the table of {:.3g} rows and {} columns", rowCount, columnCount),
                       bytesOfNumber * cells + textBytes, phrase("Export fewer channels, or a part of the recording."));
}

Outcome<Done> checkTraces(double samples, std::size_t inputs, std::size_t outputs) {
    const std::size_t signals = inputs + 3 * outputs;
    return checkMemory(
        phrase("the traces of {} inputs and {} outputs over {:.3g} samples", inputs, outputs, samples),
        bytesOfNumber * samples * static_cast<double>(signals),
        phrase("Use a part of the recordings (\"range\"), fewer of their rows, or fewer outputs of the model."));
}

Outcome<Done> checkSlopes(double values, std::size_t parameters) {
    return checkMemory(
        phrase("the slopes of {:.3g} measured values along {} parameters", values, parameters),
        bytesOfNumber * values * static_cast<double>(parameters + 1),
        phrase("Use a part of the recordings (\"range\"), fewer of their rows, or fit fewer parameters."));
}

Outcome<Done> checkExpressions(std::size_t count, std::size_t nodeBytes) {
    return checkMemory(phrase("the {} expressions of the model", count),
                       static_cast<double>(count) * static_cast<double>(nodeBytes), shorterEquations());
}

Text shorterEquations() {
    return phrase("Shorten the longest equations and loops, or give intermediate results names of their own.");
}

}  // namespace analogon::limits
