#pragma once

#include <gtest/gtest.h>

#include <algorithm>

#include "core/effect/block/screen.hpp"

namespace analogon {

/// A model fitted to its recordings.
inline NullModel fittedModel(const EstimationTask& task) {
    Outcome<NullModel> null = fitNull({task, {}, {}}, {}, NoiseLevel::Estimate, {}, {});
    EXPECT_TRUE(null) << format(null.diagnostics());
    return null ? std::move(*null) : NullModel{};
}

/// The first place of an effect of this kind in a model, of all that are in its libraries.
inline Candidate firstCandidate(const Variant& variant, const std::string& kind) {
    const Outcome<std::vector<EffectClass>> catalogue = effectCatalogue(variant.task.library);
    const Outcome<std::vector<Candidate>> candidates = candidatesFor(variant, *catalogue);
    const auto found =
        std::find_if(candidates->begin(), candidates->end(), [&](const Candidate& c) { return c.effect.kind == kind; });
    EXPECT_TRUE(found != candidates->end()) << "no place for " << kind;
    return found != candidates->end() ? *found : Candidate{};
}

}  // namespace analogon
