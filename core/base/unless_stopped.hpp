#pragma once

#include "core/base/outcome.hpp"
#include "core/base/progress.hpp"
#include "core/base/stop.hpp"

namespace analogon {

/// Work that may be stopped wherever it is before there is anything to tell: "cancelled" then.
template <class Work>
auto unlessStopped(const Progress& progress, const Work& work) -> decltype(work()) {
    try {
        const StopScope scope(progress.stopToken());
        return work();
    } catch (const Stopped&) {
        return error(phrase("cancelled"));
    }
}

}  // namespace analogon
