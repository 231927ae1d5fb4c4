#pragma once

#include "core/effect/block/trial.hpp"

/// Why a candidate was not taken, or was taken out again: each says a decision that was made, none is guessed
/// afterwards.
namespace analogon {

/// "friction.coulomb at gear.flange_b".
Text nameOf(const Candidate& candidate);

/// The first test that it fails, where so much of it must hold on the blocks left out; empty: it passes.
Text whyRefused(const Acceptance& acceptance, double heldOutAsked);

/// That evidence is no more than chance may bring.
Text withinChance(double evidence, double asked);

Text atBound();                // see isAtBound
Text followsOthers();          // see mayFollowOthers
Text indistinct();             // see isTold
Text fights();                 // see fightsAnother
Text explainsLittle();         // see outweighsRest
Text noMoreThanDisturbance();  // see isBorneOut

/// Of an effect with which the model does not predict clearly better, see isClearlyBetter.
Text predictsNoBetter(const Prediction& prediction);

/// Of a candidate that was screened and not refitted; what promises less than `least` was not.
Text whyNotRefitted(const Screened& screened, const LeastPromise& least);

/// "taken out again: {}"
Text takenOut(const Text& why);

}  // namespace analogon
