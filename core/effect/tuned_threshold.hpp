#pragma once

#include <cstdlib>
#include <string_view>

/// For a build that asks which tests guard a threshold (-DANALOGON_TUNABLE_THRESHOLDS=ON): one of them is scaled by the
/// environment, ANALOGON_THRESHOLD="GROUP.NAME=FACTOR". No program that is delivered is built so.
namespace analogon::threshold {

template <class T>
T tunedThreshold(std::string_view name, T value) {
    const char* asked = std::getenv("ANALOGON_THRESHOLD");
    if (asked == nullptr) return value;
    const std::string_view text(asked);
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos || text.substr(0, equals) != name) return value;
    const double scaled = static_cast<double>(value) * std::atof(asked + equals + 1);
    return static_cast<T>(scaled);
}

}  // namespace analogon::threshold
