#include "core/effect/search/journal.hpp"

#include <cmath>
#include <set>

#include "core/effect/model/model_state.hpp"

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

void Journal::add(const std::string& step, const std::string& key, Decision::Figures figures,
                  const std::string& verdict, const Text& reason) const {
    if (!trace_) return;
    trace_->add({step, key, path, round, std::move(figures), verdict, reason.english()});
}

void Journal::test(const std::string& step, const std::string& key, const Acceptance& test, const std::string& verdict,
                   const Text& reason) const {
    add(step, key,
        {{"explained", test.explained},
         {"evidence", test.evidence},
         {"effective", test.effective},
         {"least_evidence", test.asked.evidence},
         {"held_out", test.heldOut},
         {"least_held_out", test.asked.heldOut},
         {"share", test.share}},
        verdict, reason);
}

void Journal::model(const std::string& step, const NullModel& model, const std::string& verdict,
                    const Text& reason) const {
    if (!trace_) return;
    add(step, joined(keysOf(model.variant.effects)),
        {{"sum_of_squares", model.sumOfSquares()},
         {"samples", static_cast<double>(model.fit.optimum.residuals.size())},
         {"parameters", model.parameterCount()},
         {"level", reducedChi(model.fit)},
         {"leaves_noise", isNoise(model) ? 1 : 0}},
        verdict, reason);
}

void Journal::screening(const std::vector<Screened>& screened) const {
    if (!trace_) return;
    for (const Screened& s : screened)
        add("screen", keyOf(s.candidate.effect, s.candidate.place),
            {{"score", s.probes.empty() ? std::nan("") : s.score()},
             {"whitened_score", s.probes.empty() ? std::nan("") : s.whitenedScore()},
             {"strength", s.probes.empty() ? std::nan("") : s.probes.front().strength()}},
            verdictOf(s), s.failure);
}

void Journal::trials(const std::string& step, const NullModel& null, const std::vector<Trial>& trials) const {
    if (!trace_) return;
    for (const Trial& t : trials) {
        const std::string key = keyOf(t.screened.candidate.effect, t.screened.candidate.place);
        if (!t.ok)
            add(step, key, {}, "failed", t.failure);
        else
            add(step, key,
                {{"fall", null.sumOfSquares() - t.sumOfSquares()},
                 {"evidence", t.evidence},
                 {"freed", t.freed()},
                 {"level", reducedChi(t.fit)}},
                "refitted");
    }
}

void Journal::tried(const NullModel& null, const Round& tried) const {
    model("beside", null, "searched");
    screening(tried.screened);
    add("threshold", "", {{"evidence", tried.threshold}, {"least_score", tried.least.score}}, "asked");
    trials("trial", null, tried.trials);
}

void Journal::heldValues(const std::string& key, const std::vector<HeldInstead>& values,
                         const std::string& verdict) const {
    for (const HeldInstead& h : values)
        add("held value", key.empty() ? h.parameter : h.parameter + " for " + key,
            {{"held", h.held}, {"value", h.value}, {"gain", h.gain}, {"explained", h.explained}}, verdict);
}

void Journal::finding(const Finding& finding) const {
    if (!trace_) return;
    for (const AddedEffect& e : finding.effects)
        add("found", e.className + "@" + e.at,
            {{"strength", e.parameters.empty() ? std::nan("") : e.parameters.front().value},
             {"delta_bic", e.evidence.deltaBic}},
            "reported");
    for (const Remainder& r : finding.unexplained.remainders)
        add("left", r.node, {{"evidence", r.evidence}}, "reported", r.proposal.equation);
    add("finding", "",
        {{"error_before", errorPercentOf(finding.baseline, Role::Fit)},
         {"error_after", errorPercentOf(finding.final, Role::Fit)}},
        name(finding.kind), finding.end.interrupted ? Text("interrupted") : finding.end.notSearched);
}

}  // namespace analogon
