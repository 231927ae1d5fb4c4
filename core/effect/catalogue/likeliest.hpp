#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "core/base/parallel.hpp"
#include "core/base/progress.hpp"
#include "core/effect/thresholds.hpp"

namespace analogon {

/// Of what was sorted by what it explains to first order, that which is worth a fit: not far behind the likeliest, and
/// not many.
template <class Likely>
void keepLikeliest(std::vector<Likely>& likely) {
    if (likely.empty()) return;
    using threshold::likely::mostFitted, threshold::rounds::rivalShare;
    const double least = rivalShare * likely.front().explained;
    std::erase_if(likely, [&](const Likely& each) { return each.explained < least; });
    if (likely.size() > mostFitted) likely.resize(mostFitted);
}

/// Replaces `best` by what `fitted` makes of one of these, where that explains more; they are fitted side by side.
template <class Likely, class Fitted, class Fit>
void takeBest(const std::vector<Likely>& likely, std::optional<Fitted>& best, int threads, const Progress& progress,
              const Fit& fitted) {
    std::vector<std::optional<Fitted>> tried(likely.size());
    parallelFor(static_cast<int>(likely.size()), threads, [&](int i) {
        const auto k = static_cast<std::size_t>(i);
        if (!progress.stopRequested()) tried[k] = fitted(likely[k]);
    });
    for (std::optional<Fitted>& one : tried)
        if (one && (!best || one->explained > best->explained)) best = std::move(one);
}

}  // namespace analogon
