#include "core/effect/search/verdicts.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/effect/judge/judgement.hpp"
#include "core/effect/judge/reason.hpp"
#include "core/effect/search/context.hpp"
#include "core/effect/search/exchange.hpp"
#include "core/effect/search/probe_twin.hpp"
#include "core/effect/search/trials.hpp"
#include "core/effect/thresholds.hpp"

namespace analogon {

using namespace threshold::rounds;

namespace {

constexpr std::size_t mostAlternatives = 6;  // that are told beside a choice

void note(const SearchContext& search, Node& node, const Screened& s, Verdict verdict, const Text& why,
          std::optional<double> deltaBic, const Text& failure) {
    CandidateResult c;
    c.kind = s.candidate.effect.kind;
    c.at = s.candidate.place.at;
    c.channel = s.candidate.place.spare;
    c.className = s.candidate.effect.className;
    c.screening.score = s.score();
    c.screening.strength = s.probes.empty() ? 0 : s.probes.front().strength();
    c.deltaBic = deltaBic;
    c.verdict = verdict;
    c.screening.absorbedBy = s.absorbedBy;
    c.round = search.journal.round;
    c.failure = failure;
    c.reason = why;
    search.journal.add("judge", keyOf(s.candidate.effect, s.candidate.place),
                       {{"score", c.screening.score}, {"delta_bic", deltaBic.value_or(std::nan(""))}}, name(verdict),
                       why);
    node.candidates.push_back(std::move(c));
}

}  // namespace

Step stepOf(SearchContext& search, const NullModel& null, const Round& round) {
    const std::vector<Trial>& trials = round.trials;
    const std::size_t chosen = *round.chosen;
    const auto isMember = [&](std::size_t i) {
        return std::find(round.members.begin(), round.members.end(), i) != round.members.end();
    };
    const auto alternative = [&](std::size_t i, bool isEquivalent) {
        const Candidate& c = trials[i].screened.candidate;
        return Alternative{c.effect.kind, c.place.at, trials[chosen].evidence - trials[i].evidence, isEquivalent};
    };
    Step s;
    s.order = ++search.journal.choices;
    s.winner = trials[chosen];
    s.acceptance = round.acceptance;
    s.tried = round.screened.size();
    for (const std::size_t m : round.members) {
        if (m == chosen) continue;
        s.alternatives.push_back(alternative(m, true));
        s.rivals.push_back(trials[m].screened.candidate);
    }
    const EffectPlace& place = trials[chosen].screened.candidate.place;
    const double weight = independentShare(null, trials[chosen].fit);
    // best first: what comes before the chosen one explains more, though not by enough to refute a name
    const auto explainsAsMuch = [&](std::size_t i) {
        const Trial &equation = trials[i], &name = trials[chosen];
        if (i < chosen) return true;
        return equation.freed() <= name.freed() && isLike(equation, name.evidence, weight) &&
               std::none_of(equation.screened.probes.begin(), equation.screened.probes.end(),
                            [&](const Probe& p) { return isTwin(p, name.screened); });
    };
    for (std::size_t i = 0; i < trials.size() && s.equation.empty() && !isProposal(trials[chosen]); ++i)
        if (trials[i].ok && isProposal(trials[i]) && trials[i].screened.candidate.place.connector == place.connector &&
            explainsAsMuch(i))
            s.equation = withValues(equationOf(trials[i].variant.effects.back()),
                                    estimatesOf(trials[i].variant.effects.back(), trials[i].fit));
    for (std::size_t i = 0; i < trials.size(); ++i) {
        if (!trials[i].ok || isMember(i) || i == chosen) continue;
        // what goes to the same place is taken for it most easily, however many places did better
        const bool isNear = trials[i].screened.candidate.place.connector == place.connector;
        if ((s.rivals.size() < mostRivals || isNear) && trials[i].evidence > rivalShare * trials[chosen].evidence)
            s.rivals.push_back(trials[i].screened.candidate);
        if (s.alternatives.size() < mostAlternatives) s.alternatives.push_back(alternative(i, false));
    }
    return s;
}

void noteAll(SearchContext& search, Node& node, const Round& round) {
    std::set<std::string> refitted;
    for (std::size_t i = 0; i < round.trials.size(); ++i) {
        const Trial& t = round.trials[i];
        refitted.insert(keyOf(t.screened.candidate.effect, t.screened.candidate.place));
        Verdict verdict = Verdict::NotSignificant;
        const auto refused = round.refused.why.find(i);
        Text why = refused != round.refused.why.end() ? refused->second
                   : t.evidence < equivalenceMargin   ? withinChance(t.evidence, equivalenceMargin)
                                                      : round.refused.behind;
        if (!t.ok) {
            verdict = Verdict::Failed;
            why =
                t.failure.empty() ? phrase("no fit with it could begin") : phrase("could not be fitted: {}", t.failure);
        } else if (round.chosen && i == *round.chosen) {
            verdict = Verdict::Chosen;
            why = {};
        } else if (std::find(round.members.begin(), round.members.end(), i) != round.members.end()) {
            verdict = Verdict::Equivalent;
            why = phrase("the data cannot tell it from {}", nameOf(round.candidate(*round.chosen)));
        } else if (round.refused.failsHeldOut.contains(i)) {
            verdict = Verdict::FailsHeldOut;
        } else if (round.chosen && t.evidence > equivalenceMargin) {
            verdict = Verdict::Weaker;
        }
        note(search, node, t.screened, verdict, why, t.ok ? std::optional<double>(-t.evidence) : std::nullopt,
             t.ok ? Text() : t.failure);
    }
    for (const Screened& s : round.screened) {
        if (refitted.contains(keyOf(s.candidate.effect, s.candidate.place))) continue;
        const Verdict verdict = !s.failure.empty()                                  ? Verdict::Failed
                                : s.isAbsorbed()                                    ? Verdict::Absorbed
                                : s.isWrongSign()                                   ? Verdict::WrongSign
                                : round.chosen && s.score() > 2 * equivalenceMargin ? Verdict::Weaker
                                                                                    : Verdict::NotSignificant;
        note(search, node, s, verdict, whyNotRefitted(s, round.least), std::nullopt, s.failure);
    }
    search.frontier.noted = node.candidates;
}

void setVerdict(const SearchContext& search, Node& node, const Candidate& candidate, Verdict verdict, const Text& why) {
    search.journal.add("revise", keyOf(candidate.effect, candidate.place), {}, name(verdict), why);
    const auto isIt = [&](const CandidateResult& c) {
        return c.className == candidate.effect.className && c.at == candidate.place.at;
    };
    auto line = node.candidates.rend();
    if (verdict != Verdict::Chosen)
        line = std::find_if(node.candidates.rbegin(), node.candidates.rend(),
                            [&](const CandidateResult& c) { return isIt(c) && c.verdict == Verdict::Chosen; });
    if (line == node.candidates.rend()) line = std::find_if(node.candidates.rbegin(), node.candidates.rend(), isIt);
    if (line == node.candidates.rend()) return;
    line->verdict = verdict;
    line->reason = why;
}

void setVerdict(const SearchContext& search, Node& node, const PlacedEffect& placed, Verdict verdict, const Text& why) {
    setVerdict(search, node, Candidate{placed.effect, placed.place}, verdict, why);
}

void settleVerdicts(const Finding& finding, std::vector<CandidateResult>& candidates) {
    const auto isAmong = [](const auto& all, const CandidateResult& c) {
        return std::any_of(all.begin(), all.end(), [&](const auto& x) { return x.kind == c.kind && x.at == c.at; });
    };
    const auto isThere = [&](const CandidateResult& c) {
        return isAmong(finding.effects, c) ||
               std::any_of(finding.unexplained.remainders.begin(), finding.unexplained.remainders.end(),
                           [&](const Remainder& r) { return r.proposal.className == c.className && r.node == c.at; });
    };
    const auto isEqual = [&](const CandidateResult& c) {
        return isAmong(finding.effects, c) ||
               std::any_of(finding.effects.begin(), finding.effects.end(),
                           [&](const AddedEffect& e) { return isAmong(e.instead.effects, c); }) ||
               std::any_of(finding.unexplained.remainders.begin(), finding.unexplained.remainders.end(),
                           [&](const Remainder& r) {
                               return r.proposal.className == c.className &&
                                      std::find(r.proposal.equalNodes.begin(), r.proposal.equalNodes.end(), c.at) !=
                                          r.proposal.equalNodes.end();
                           });
    };
    for (CandidateResult& c : candidates) {
        if (c.verdict == Verdict::Chosen && !isThere(c)) {
            c.verdict = Verdict::NotSignificant;
            c.reason = phrase("was not kept to the end of the search");
        }
        if (c.verdict == Verdict::Equivalent && !isEqual(c)) {
            c.verdict = Verdict::Weaker;
            c.reason = phrase("is no equal of anything that was kept: {}", c.reason);
        }
    }
}

}  // namespace analogon
