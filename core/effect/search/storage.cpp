#include "core/effect/search/storage.hpp"

#include <algorithm>

#include "core/effect/judge/reason.hpp"
#include "core/effect/model/sampling.hpp"
#include "core/effect/search/contenders.hpp"
#include "core/effect/search/context.hpp"
#include "core/effect/search/verdicts.hpp"
#include "core/effect/search/without.hpp"

namespace analogon {

namespace {

/// The node with another effect in the place of a dead time; nothing where none predicts nearly as well.
std::optional<Node> withoutDeadTime(SearchContext& search, const Node& node, std::size_t effect) {
    std::optional<NullModel> rest = without(search, node.null, effect);
    if (!rest) return std::nullopt;
    seekFromTheStart(search, search.readings.searched, *rest);
    Node base = node;
    base.null = std::move(*rest);
    base.steps.erase(base.steps.begin() + static_cast<std::ptrdiff_t>(effect));
    Round round = tryAll(search, base.null);
    std::vector<Contender> contenders = contendersOf(search, base.null, round.trials);
    std::erase_if(contenders, [&](const Contender& c) { return faultOf(round.candidate(c.trial).effect) == "delay"; });
    std::optional<Node> next = firstThatHolds(search, base, std::move(contenders), round, [&](const Node& found) {
        const bool isBetter = predictsBetter(search, found, node);
        search.journal.model("storage", found.null, isBetter ? "taken" : "set aside");
        return isBetter;
    });
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
        const bool isIndicated = node.steps[i].prediction.has_value();
        if (!isIndicated || !isLongDeadTime(node.null.variant.effects[i], node.null.fit, interval)) continue;
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
