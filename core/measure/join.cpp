#include "core/measure/join.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace analogon {

namespace {

constexpr double gap = std::numeric_limits<double>::quiet_NaN();

/// Without the samples that were not measured.
struct Measured {
    std::vector<double> stamps, values;
};

Measured measuredOf(const Trace& trace) {
    Measured measured;
    for (std::size_t i = 0; i < trace.stamps.size(); ++i) {
        if (!std::isfinite(trace.values[i]) || !std::isfinite(trace.stamps[i])) continue;
        measured.stamps.push_back(trace.stamps[i]);
        measured.values.push_back(trace.values[i]);
    }
    return measured;
}

}  // namespace

std::vector<double> unitedStamps(std::span<const Trace> traces) {
    std::vector<double> all;
    for (const Trace& trace : traces) {
        const Measured measured = measuredOf(trace);
        all.insert(all.end(), measured.stamps.begin(), measured.stamps.end());
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

std::vector<double> courseAt(const Trace& input, std::span<const double> stamps, Course course) {
    const Measured measured = measuredOf(input);
    std::vector<double> values(stamps.size(), gap);
    std::size_t behind = 0;  // the first sample after the stamp
    for (std::size_t i = 0; i < stamps.size(); ++i) {
        while (behind < measured.stamps.size() && measured.stamps[behind] <= stamps[i]) ++behind;
        if (behind == 0) continue;
        const double left = measured.values[behind - 1], at = measured.stamps[behind - 1];
        if (course == Course::Held || at == stamps[i]) {
            values[i] = left;
        } else if (behind < measured.stamps.size()) {
            const double share = (stamps[i] - at) / (measured.stamps[behind] - at);
            values[i] = left + share * (measured.values[behind] - left);
        }
    }
    return values;
}

}  // namespace analogon
