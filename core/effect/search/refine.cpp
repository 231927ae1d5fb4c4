#include "core/effect/search/refine.hpp"

#include <algorithm>

#include "core/effect/block/twin.hpp"
#include "core/effect/search/context.hpp"
#include "core/effect/search/without.hpp"
#include "core/effect/thresholds.hpp"

namespace analogon {

using namespace threshold::refine;

bool isBetterSharp(double before, double sharper) { return before - sharper > leastSharpening; }

void sharpen(SearchContext& search, Node& node) {
    for (int pass = 0; pass < mostSharpenings && !search.progress.stopRequested(); ++pass) {
        std::vector<PlacedEffect> effects = node.null.variant.effects;
        if (!drawSharper(effects.back())) return;
        std::optional<NullModel> sharper = refittedWith(search, node.null, effects);
        if (!sharper || !isBetterSharp(node.null.sumOfSquares(), sharper->sumOfSquares())) return;
        if (sharper->fit.takesDifferences) return;  // too sharp for the steps: nothing could be screened beside it
        search.journal.model("sharpen", *sharper, "drawn sharper");
        node.null = std::move(*sharper);
    }
}

void treatAlike(SearchContext& search, Node& node) {
    for (std::size_t i = 0; i < node.null.variant.effects.size() && !search.progress.stopRequested(); ++i) {
        if (!(reducedChi(node.null.fit) > largeResidual)) return;
        const PlacedEffect& placed = node.null.variant.effects[i];
        if (placed.effect.placement.signalSide.empty() || !placed.effect.proposal.empty() || !placed.twins.empty())
            continue;
        const std::vector<EffectPlace> like = likePlaces(node.null.variant, placed, search.catalogue);
        if (like.empty()) continue;
        search.say("reconsider", phrase("{} at every channel like {}", placed.effect.kind, placed.place.at), -1);
        std::vector<PlacedEffect> effects = node.null.variant.effects;
        effects[i].twins = like;
        std::optional<NullModel> tied = refittedWith(search, node.null, effects);
        if (!tied) continue;
        const double rows = static_cast<double>(node.null.fit.optimum.residuals.size());
        const double least = std::min(node.null.sumOfSquares(), tied->sumOfSquares());
        const double worse = (tied->sumOfSquares() - node.null.sumOfSquares()) / least *
                             (rows - node.null.parameterCount()) * independentShare(node.null, node.null.fit);
        const bool isTaken = worse < equivalenceMargin;
        search.journal.model("alike", *tied, isTaken ? "taken" : "set aside");
        if (isTaken) node.null = std::move(*tied);
    }
}

}  // namespace analogon
