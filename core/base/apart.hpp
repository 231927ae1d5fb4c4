#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <string>

#include "core/base/outcome.hpp"
#include "core/base/progress.hpp"

namespace analogon {

/// What a process apart may take: seconds of a processor, and bytes beside what this program has already.
struct ApartLimits {
    double seconds, bytes;
    ApartLimits(double mostSeconds, double mostBytes = std::numeric_limits<double>::infinity())
        : seconds(mostSeconds), bytes(mostBytes) {}
};

/// Work of a library that damaged input can bring down, in a process of its own: a copy of this one, whose end costs
/// nothing here. `work` gives bytes; it must take no lock that another thread may hold at this moment.
/// Faults: the process ended by a signal, at one of the `limits` (the input is
/// damaged; that is `whenItEnds`), `progress` asked to stop ("reading was stopped"), no process can be made: in the
/// file of `whenItEnds`.
Outcome<std::string> runApart(const std::function<std::string()>& work, const ApartLimits& limits,
                              const Diagnostic& whenItEnds, const Progress& progress = {});

/// [s] of processor time that reading a file may take: far more than it does.
double mostReadingTime(const std::filesystem::path& file);
/// [byte] that reading a file may take, be it packed as well as can be.
double mostReadingMemory(const std::filesystem::path& file);

}  // namespace analogon
