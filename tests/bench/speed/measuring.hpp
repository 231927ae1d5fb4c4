#pragma once

#include <functional>
#include <string>

namespace analogon::speed {

/// Time of this process on a processor [s]: the machine may be busy with other things.
double now();

/// Least time of some repeats [s].
double timed(double budget, const std::function<void()>& work);

/// A line of /proc/self/status [MB]; 0 where there is none.
double memory(const std::string& name);

/// How far the work rises above the memory in use before it [MB].
double peakMemory(const std::function<void()>& work);

}  // namespace analogon::speed
