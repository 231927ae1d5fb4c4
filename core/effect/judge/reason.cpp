#include "core/effect/judge/reason.hpp"

#include <algorithm>

#include "core/effect/thresholds.hpp"

namespace analogon {

Text nameOf(const Candidate& candidate) { return phrase("{} at {}", candidate.effect.kind, candidate.place.at); }

Text withinChance(double evidence, double asked) {
    return phrase("does not lower the error by more than chance may: evidence {:.3g}, and {:.3g} is asked for",
                  evidence, asked);
}

Text whyRefused(const Acceptance& acceptance, double heldOutAsked) {
    if (acceptance.isAtEdges)
        return phrase(
            "what it explains lies right behind changes of an input, and how that ran between its samples may be all "
            "there is to it");
    if (!acceptance.isSignificant)
        return withinChance(std::max(acceptance.evidence, acceptance.effective), acceptance.asked.evidence);
    if (!(acceptance.heldOut > heldOutAsked))
        return phrase(
            "held-out blocks contradict it: they bear out {:.0f} % of what it explains, and more than {:.0f} % is "
            "asked for",
            100 * acceptance.heldOut, 100 * heldOutAsked);
    if (!acceptance.isWorthwhile)
        return phrase("explains {:.2g} % of what stays unexplained beside it, which is too little to count",
                      100 * acceptance.share);
    return {};
}

Text whyNotRefitted(const Screened& screened, const LeastPromise& least) {
    if (!screened.failure.empty()) return phrase("could not be tried: {}", screened.failure);
    if (screened.isAbsorbed())
        return screened.absorbedBy.empty()
                   ? phrase("the data cannot show it: it only shifts parameters")
                   : phrase("the data cannot show it: it only shifts {}", listed(screened.absorbedBy));
    if (screened.isWrongSign()) return phrase("would need a strength of the wrong physical sign");
    if (!(screened.score() > 0)) return phrase("explains nothing of what is left");
    if (!least.isMetBy(screened))
        return phrase("promises no more than chance may bring (score {:.3g}), and was not refitted",
                      least.of(screened));
    return phrase("others promise more and were refitted instead (score {:.3g})", screened.score());
}

Text atBound() { return phrase("its strength, or what shapes it, rests at a bound: it stands for something else"); }

Text indistinct() { return phrase("its strength is not distinguishable from 0"); }

Text fights() { return phrase("grows against an effect of the model: two that cancel explain what neither does"); }

Text explainsLittle() { return phrase("explains little against what is left beside it"); }

Text noMoreThanDisturbance() {
    return phrase("a flow that nobody measured, and that varies slowly, accounts for as much");
}

Text predictsNoBetter(const Prediction& prediction) {
    if (prediction.besideFlow && !(*prediction.besideFlow > threshold::acceptance::clearEvidence))
        return noMoreThanDisturbance();
    return phrase(
        "what was left out is not predicted clearly better with it: the error goes from {:.3g} to {:.3g} %, "
        "lower in {} of {} parts",
        prediction.errorPercentBefore, prediction.errorPercentAfter, prediction.betterIn, prediction.blocks);
}

Text followsOthers() { return phrase("its form may follow what other effects do, and with it structure remains"); }

Text takenOut(const Text& why) { return phrase("taken out again: {}", why); }

}  // namespace analogon
