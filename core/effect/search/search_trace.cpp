/// What the search decides, told to whoever asks for it (DiscoverOptions::trace).
#include <cmath>

#include "core/effect/model/model_state.hpp"
#include "core/effect/search/search.hpp"

namespace analogon {
namespace {

std::string joined(const std::set<std::string>& keys) {
    std::string text;
    for (const std::string& key : keys) text += (text.empty() ? "" : " + ") + key;
    return text;
}

const char* verdictOf(const Screened& s) {
    return !s.failure.empty() ? "failed" : s.isAbsorbed() ? "absorbed" : s.isWrongSign() ? "wrong sign" : "visible";
}

}  // namespace

void Search::trace(const std::string& step, const std::string& key, Decision::Figures figures,
                   const std::string& verdict, const Text& reason) const {
    if (!options_.trace) return;
    options_.trace->add({step, key, paths_, round_, std::move(figures), verdict, reason.english()});
}

void Search::traceTest(const std::string& step, const std::string& key, const Acceptance& test,
                       const std::string& verdict, const Text& reason) const {
    trace(step, key,
          {{"explained", test.explained},
           {"evidence", test.evidence},
           {"effective", test.effective},
           {"least_evidence", test.leastEvidence},
           {"held_out", test.heldOut},
           {"least_held_out", test.leastHeldOutAsked},
           {"share", test.share}},
          verdict, reason);
}

void Search::traceModel(const std::string& step, const NullModel& model, const std::string& verdict,
                        const Text& reason) const {
    if (!options_.trace) return;
    trace(step, joined(keysOf(model.variant.effects)),
          {{"sum_of_squares", model.sumOfSquares()},
           {"samples", static_cast<double>(model.fit.optimum.residuals.size())},
           {"parameters", model.parameterCount()},
           {"level", levelOf(model.fit)},
           {"leaves_noise", isNoise(model) ? 1 : 0}},
          verdict, reason);
}

void Search::traceScreening(const std::vector<Screened>& screened) const {
    if (!options_.trace) return;
    for (const Screened& s : screened)
        trace("screen", keyOf(s.candidate.effect, s.candidate.place),
              {{"score", s.probes.empty() ? std::nan("") : s.score()},
               {"whitened_score", s.probes.empty() ? std::nan("") : s.whitenedScore()},
               {"strength", s.probes.empty() ? std::nan("") : s.probes.front().strength()}},
              verdictOf(s), s.failure);
}

void Search::traceTrials(const std::string& step, const NullModel& null, const std::vector<Trial>& trials) const {
    if (!options_.trace) return;
    for (const Trial& t : trials) {
        const std::string key = keyOf(t.screened.candidate.effect, t.screened.candidate.place);
        if (!t.ok)
            trace(step, key, {}, "failed", t.failure);
        else
            trace(step, key,
                  {{"fall", null.sumOfSquares() - t.sumOfSquares()},
                   {"evidence", t.evidence},
                   {"freed", t.freed()},
                   {"level", levelOf(t.fit)}},
                  "refitted");
    }
}

/// What was screened and refitted beside a model.
void Search::traceRound(const NullModel& null, const Round& round) const {
    traceModel("beside", null, "searched");
    traceScreening(round.screened);
    trace("threshold", "", {{"evidence", round.threshold}, {"least_score", round.leastScore}}, "asked");
    traceTrials("trial", null, round.trials);
}

void Search::traceHeld(const std::string& key, const std::vector<HeldInstead>& values,
                       const std::string& verdict) const {
    for (const HeldInstead& h : values)
        trace("held value", key.empty() ? h.parameter : h.parameter + " for " + key,
              {{"held", h.held}, {"value", h.value}, {"gain", h.gain}, {"explained", h.explained}}, verdict);
}

void Search::traceFinding(const Finding& finding) const {
    if (!options_.trace) return;
    for (const AddedEffect& e : finding.effects)
        trace("found", e.className + "@" + e.at,
              {{"strength", e.parameters.empty() ? std::nan("") : e.parameters.front().value},
               {"delta_bic", e.evidence.deltaBic}},
              "reported");
    for (const Remainder& r : finding.remainders)
        trace("left", r.node, {{"evidence", r.evidence}}, "reported", r.proposedEquation);
    trace("finding", "",
          {{"error_before", errorPercentOf(finding.baseline, Role::Fit)},
           {"error_after", errorPercentOf(finding.final, Role::Fit)}},
          name(finding.kind), finding.interrupted ? Text("interrupted") : finding.notSearched);
}

}  // namespace analogon
