#include "core/effect/search/storage.hpp"

#include <algorithm>

#include "core/effect/judge/reason.hpp"
#include "core/effect/model/sampling.hpp"
#include "core/effect/search/contenders.hpp"
#include "core/effect/search/context.hpp"
#include "core/effect/search/refine.hpp"
#include "core/effect/search/trials.hpp"
#include "core/effect/search/verdicts.hpp"
#include "core/effect/search/without.hpp"

namespace analogon {

namespace {

/// Of what the data cannot tell from it: a lag, or a mass upstream.
bool isStorage(const Alternative& a) {
    return a.equivalent && (a.kind.ends_with(".lag") || a.kind.ends_with(".source_mass"));
}

bool hasStorageInItsClass(const Step& step) {
    return std::any_of(step.alternatives.begin(), step.alternatives.end(), isStorage);
}

/// The best of the trials that stores and is in the class of an established dead time, established as that is; nothing
/// where it cannot be fitted or tells less.
std::optional<Node> withItsStorage(SearchContext& search, const Node& base, const Step& deadTime, Round& round) {
    const auto isOfClass = [&](const Trial& t) {
        const Candidate& c = t.screened.candidate;
        return t.ok && std::any_of(deadTime.alternatives.begin(), deadTime.alternatives.end(), [&](const auto& a) {
                   return isStorage(a) && a.kind == c.effect.kind && a.at == c.place.at;
               });
    };
    const auto best = std::find_if(round.trials.begin(), round.trials.end(), isOfClass);  // they stand best first
    if (best == round.trials.end()) return std::nullopt;
    round.choose(base.null, static_cast<std::size_t>(best - round.trials.begin()),
                 examine(search, base.null, *best, round.threshold));
    Node next = base;
    Step step = stepOf(search, base.null, round);
    Outcome<NullModel> fitted =
        fitNull(step.winner.variant, base.null.noise, NoiseLevel::Estimate, search.fit, search.progress);
    if (!fitted || search.progress.stopRequested()) return std::nullopt;
    next.null = std::move(*fitted);
    next.steps.push_back(std::move(step));
    sharpen(search, next);
    noteAll(search, next, round);
    return next;
}

/// The node with another effect in the place of a dead time; nothing where none predicts nearly as well.
std::optional<Node> withoutDeadTime(SearchContext& search, const Node& node, std::size_t effect) {
    std::optional<NullModel> rest = without(search, node.null, effect);
    if (!rest) return std::nullopt;
    seekFromTheStart(search, search.readings.searched, *rest);
    Node base = node;
    base.null = std::move(*rest);
    base.steps.erase(base.steps.begin() + static_cast<std::ptrdiff_t>(effect));
    Round round = tryAll(search, base.null);
    const auto isBetter = [&](const Node& found) {
        const bool is = predictsBetter(search, found, node);
        search.journal.model("storage", found.null, is ? "taken" : "set aside");
        return is;
    };
    std::optional<Node> next;
    if (node.steps[effect].prediction) {
        std::vector<Contender> contenders = contendersOf(search, base.null, round.trials);
        std::erase_if(contenders,
                      [&](const Contender& c) { return faultOf(round.candidate(c.trial).effect) == "delay"; });
        next = firstThatHolds(search, base, std::move(contenders), round, isBetter);
    } else {
        next = withItsStorage(search, base, node.steps[effect], round);
        if (next && !isBetter(*next)) next.reset();
    }
    if (next)
        setVerdict(search, *next, node.null.variant.effects[effect], Verdict::Weaker,
                   phrase("with {} in its place the model predicts nearly as well: what is stored comes late, too",
                          nameOf(round.candidate(*round.chosen))));
    return next;
}

}  // namespace

bool storageForDeadTimes(SearchContext& search, Node& node) {
    const double interval = samplingInterval(node.null.variant.task);
    bool isExchanged = false;
    for (std::size_t i = 0; i < node.steps.size() && !search.progress.stopRequested(); ++i) {
        const bool isOpen = node.steps[i].prediction.has_value() || hasStorageInItsClass(node.steps[i]);
        if (!isOpen || !isLongDeadTime(node.null.variant.effects[i], node.null.fit, interval)) continue;
        search.checkWork();
        std::optional<Node> next = withoutDeadTime(search, node, i);
        if (!next) continue;
        node = std::move(*next);
        isExchanged = true;
        --i;  // the next effect stands there now; what has come in stands at the end and is no dead time
    }
    return isExchanged;
}

}  // namespace analogon
