#include "core/effect/search/held_values.hpp"

#include <algorithm>

#include "core/effect/search/conclude.hpp"
#include "core/effect/search/context.hpp"
#include "core/effect/search/without.hpp"

namespace analogon {
namespace {

Text otherValue(const HeldInstead& held) { return phrase("another value of {} is the better account", held.parameter); }

/// The best of them, and what the data do not tell from it.
std::vector<HeldInstead> equalToFirst(std::vector<HeldInstead> values) {
    std::erase_if(values, [best = values.empty() ? 0 : values.front().gain](const HeldInstead& h) {
        return h.gain < best - equivalenceMargin;
    });
    return values;
}

}  // namespace

HeldValues heldValues(SearchContext& search, const Node& node) {
    HeldValues values;
    for (std::size_t i = 0; i < node.steps.size() && !search.progress.stopRequested(); ++i) {
        const PlacedEffect& own = node.null.variant.effects[i];
        search.say("reconsider", phrase("{} at {}", own.effect.kind, own.place.at), -1);
        if (const std::optional<NullModel> rest = without(search, node.null, i)) {
            values[node.steps[i].order] = heldInstead(*rest, node.null, search.fit, search.progress);
            search.journal.heldValues(keyOf(own.effect, own.place), values[node.steps[i].order], "as good");
        }
    }
    return values;
}

std::vector<HeldInstead> takeOutForHeld(SearchContext& search, Node& node, const HeldValues& held) {
    if (node.steps.size() > 1 || !search.courses.areEmpty() || search.progress.stopRequested()) return {};
    if (node.steps.empty()) {
        if (isNoise(node.null)) return {};
        const std::vector<HeldInstead> alone =
            equalToFirst(heldInstead(node.null, node.null, search.fit, search.progress));
        const bool explains = !alone.empty() && alone[0].leavesNoise && alone[0].gain > 3 * equivalenceMargin;
        search.journal.heldValues("", alone, explains ? "taken" : "set aside");
        return explains ? alone : std::vector<HeldInstead>();
    }
    const auto known = held.find(node.steps[0].order);
    if (known == held.end() || known->second.empty()) return {};
    const HeldInstead& best = known->second.front();
    // what the effect leaves may be correlated just because it is not the cause: noise beside the value speaks for
    // itself
    const double share = best.leavesNoise && !isNoise(node.null) ? 1 : independentShare(node.null, node.null.fit);
    if (!(share * best.gain > 3 * equivalenceMargin) || !takeOut(search, node, 0, otherValue(best))) return {};
    search.journal.heldValues("", equalToFirst(known->second), "taken");
    return equalToFirst(known->second);
}

std::vector<HeldInstead> takeOutAllForHeld(SearchContext& search, Node& node, const NullModel& base) {
    const bool isOneAccount = node.steps.size() < 2 && search.readings.drawn.asRecorded.empty();
    if (isOneAccount || !search.courses.areEmpty() || search.progress.stopRequested()) return {};
    Variant given = base.variant;
    if (!search.readings.drawn.asRecorded.empty()) given.task.recordings = search.readings.recordingsAsGiven();
    Outcome<NullModel> without = fitNull(given, node.null.noise, NoiseLevel::Keep, search.fit, search.progress);
    if (!without || search.progress.stopRequested()) return {};
    std::vector<HeldInstead> alone = equalToFirst(heldInstead(*without, node.null, search.fit, search.progress));
    if (alone.empty() || !(alone[0].leavesNoise || !isNoise(node.null))) return {};
    if (node.steps.empty() && !(alone[0].gain > 3 * equivalenceMargin)) return {};
    search.journal.heldValues("", alone, "taken");
    takeOutAll(search, node, *without, otherValue(alone[0]));
    if (!search.readings.drawn.asRecorded.empty()) search.readings.takeRecordingsAsGiven();
    return alone;
}

}  // namespace analogon
