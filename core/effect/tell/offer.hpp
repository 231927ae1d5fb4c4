#pragma once

#include <vector>

#include "core/effect/judge/remainder.hpp"
#include "core/effect/model/null_model.hpp"

/// What is proposed, among what is left.
namespace analogon {

/// Puts proposals first among what is left; the strongest channel tells when it shows and what it moves with.
void offer(std::vector<Remainder> proposed, const std::vector<ColouredNoise>& noise, const ModelState& state,
           std::vector<Remainder>& left);

/// The same for a parameter that changes, where anything is left at all: what it accounts for may else pass for noise
/// with a memory.
void offerAlone(Remainder change, const std::vector<ColouredNoise>& noise, const ModelState& state,
                std::vector<Remainder>& left);

/// The proposals, first among what is left, account for what is not there any more beside them.
void keepWhatIsLeft(const NullModel& with, std::size_t proposals, const SimulationOptions& simulation,
                    std::vector<Remainder>& left);

}  // namespace analogon
