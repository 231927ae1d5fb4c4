#include "core/effect/model/evidence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/effect/model/held_out.hpp"
#include "core/effect/model/input_edge.hpp"
#include "core/effect/thresholds.hpp"

namespace analogon {

using namespace threshold::acceptance;

namespace {

/// Whether a decrease of chi-square happens right behind changes of an input that is sampled too slowly for them,
/// and hardly elsewhere: how the input ran there is not known.
bool happensAtEdges(const NullModel& null, const FitResult& with) {
    std::vector<std::vector<bool>> isBehind;  // by recording and sample
    for (const Recording& r : null.variant.task.recordings) isBehind.emplace_back(r.time.size(), false);
    for (const InputEdge& e : inputEdges(null.variant.task)) {
        std::vector<bool>& samples = isBehind[static_cast<std::size_t>(e.recording)];
        for (int k = e.sample + 1; k <= e.sample + samplesBehindEdge && k < static_cast<int>(samples.size()); ++k)
            samples[static_cast<std::size_t>(k)] = true;
    }
    const std::vector<int> fitted = recordingsOf(null.variant.task, Role::Fit);
    double chi2Decrease = 0, there = 0, rows = 0;
    for (const ResidualChannel& c : null.channels)
        for (int row = c.begin; row < c.end; ++row) {
            const double before = null.fit.optimum.residuals[row], after = with.optimum.residuals[row];
            const auto recording = static_cast<std::size_t>(fitted[static_cast<std::size_t>(c.experiment)]);
            const bool isHere =
                isBehind[recording][static_cast<std::size_t>(c.samples[static_cast<std::size_t>(row - c.begin)])];
            chi2Decrease += before * before - after * after;
            if (isHere) there += before * before - after * after;
            rows += isHere ? 1 : 0;
        }
    return there > mostAtEdges * chi2Decrease && rows < fewAtEdges * static_cast<double>(with.optimum.residuals.size());
}

}  // namespace

EvidenceScale::EvidenceScale(const NullModel& null, const FitResult& best)
    : without_(null.sumOfSquares()),
      variance_(best.optimum.residuals.squaredNorm() /
                std::max(1.0, static_cast<double>(null.fit.optimum.residuals.size()) -
                                  static_cast<double>(best.estimates.size()))),
      logCount_(std::log(effectiveCount(null.channels, best.optimum.residuals))) {}

double EvidenceScale::of(double sumOfSquares, int freed) const {
    return (without_ - sumOfSquares) / variance_ - freed * logCount_;
}

int heldOutBlocks(double independentSamples) {
    return std::clamp(static_cast<int>(independentSamples / samplesPerBlock), heldOutFolds, mostBlocks);
}

Acceptance examine(const NullModel& null, const FitResult& with, int freed, double threshold) {
    const Whitener whiten(null.channels, with.optimum.residuals);
    const auto whiteSum = [&](const Linearisation& l) {
        return OrthogonalProjector(whiten(l.jacobian))(whiten(l.residuals)).squaredNorm();
    };
    Acceptance a;
    a.explained = whiteSum(null.fit.optimum) - whiteSum(with.optimum);
    a.evidence = a.explained - freed * std::log(static_cast<double>(null.fit.optimum.residuals.size()));
    // An autoregressive model of a residual that still holds other slow effects takes their slow part for noise. What
    // counts the same residual as noise of its own correlation time is the more patient judge of slow effects.
    const double rows = static_cast<double>(null.fit.optimum.residuals.size());
    const double count = effectiveCount(null.channels, with.optimum.residuals);
    const double variance =
        with.optimum.residuals.squaredNorm() / std::max(1.0, rows - static_cast<double>(with.estimates.size()));
    a.effective = (null.sumOfSquares() - with.optimum.residuals.squaredNorm()) / variance * count / rows -
                  freed * std::log(count);
    a.heldOut = heldOutGain(null.channels, null.fit.optimum, with.optimum, heldOutBlocks(count), heldOutFolds);
    // What leaves noise has explained all there was. What leaves structure must show more, and show it against chance.
    const bool leavesStructure = !isNoise(null.channels, with);
    const bool isFirst = null.variant.effects.empty();
    const double least = !isFirst ? leastBesideOthers : leavesStructure ? clearEvidence : leastEvidence;
    a.asked.evidence = std::max(least, threshold * (leavesStructure ? structureFactor : 1));
    const double best = std::max(a.evidence, a.effective);
    a.isAtEdges = best > a.asked.evidence && best < farMore && happensAtEdges(null, with);
    a.isSignificant = best > a.asked.evidence && !a.isAtEdges;
    const double left = with.optimum.residuals.squaredNorm(), unexplained = left - rows;
    const bool explainsAll = !leavesStructure && std::min(a.evidence, a.effective) > farMore;
    a.asked.heldOut = explainsAll                                   ? leastHeldOutOfAll
                      : left > largeResidual * largeResidual * rows ? leastHeldOutOfMuch
                                                                    : leastHeldOut;
    a.holdsOut = a.heldOut > a.asked.heldOut;
    a.share = unexplained > 0 ? (null.sumOfSquares() - left) / unexplained : std::numeric_limits<double>::infinity();
    a.isWorthwhile = a.share > leastShare;
    return a;
}

}  // namespace analogon
