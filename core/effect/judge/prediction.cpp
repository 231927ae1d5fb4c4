#include "core/effect/judge/prediction.hpp"

#include <algorithm>
#include <cmath>

#include "core/effect/model/held_out.hpp"
#include "core/effect/thresholds.hpp"

namespace analogon {

using namespace threshold::prediction;

namespace {

/// What a row counts in percent of the range of its channel's measurement.
Eigen::VectorXd percentOfRange(const std::vector<ResidualChannel>& channels, Eigen::Index rows) {
    Eigen::VectorXd scale = Eigen::VectorXd::Zero(rows);
    for (const ResidualChannel& c : channels) {
        if (c.measured.size() == 0) continue;
        const double range = c.measured.maxCoeff() - c.measured.minCoeff();
        if (range > 0) scale.segment(c.begin, c.end - c.begin).setConstant(100 / range);
    }
    return scale;
}

int recordingsOf(const std::vector<ResidualChannel>& channels) {
    int last = -1;
    for (const ResidualChannel& c : channels) last = std::max(last, c.experiment);
    return last + 1;
}

}  // namespace

std::vector<std::vector<Eigen::Index>> partsLeftOut(const std::vector<ResidualChannel>& channels) {
    const int recordings = recordingsOf(channels);
    const bool areWhole = recordings >= fewestRecordings;
    const int parts = std::min(areWhole ? recordings : recordings * partsOfARecording, mostParts);
    std::vector<std::vector<Eigen::Index>> rows(static_cast<std::size_t>(std::max(parts, 0)));
    for (const ResidualChannel& c : channels) {
        const long last = c.samples.back() + 1;
        for (int row = c.begin; row < c.end; ++row) {
            const long sample = c.samples[static_cast<std::size_t>(row - c.begin)];
            const long own = sample * partsOfARecording / last;
            const long part = areWhole ? c.experiment : c.experiment * partsOfARecording + own;
            rows[static_cast<std::size_t>(part % parts)].push_back(row);
        }
    }
    std::erase_if(rows, [](const auto& part) { return part.empty(); });
    return rows;
}

Prediction predict(const NullModel& without, const FitResult& with) {
    const Linearisation &before = without.fit.optimum, &after = with.optimum;
    const HeldOut heldOut(before, after);
    const Eigen::VectorXd scale = percentOfRange(without.channels, before.residuals.size());
    Prediction prediction;
    prediction.areRecordings = recordingsOf(without.channels) >= fewestRecordings;
    double squaresBefore = 0, squaresAfter = 0;
    for (const std::vector<Eigen::Index>& rows : partsLeftOut(without.channels)) {
        const LeftOutPart part = heldOut.part(rows);
        const Eigen::VectorXd percent = scale(rows);
        const double errorBefore = part.without.cwiseProduct(percent).squaredNorm(),
                     errorAfter = part.with.cwiseProduct(percent).squaredNorm();
        squaresBefore += errorBefore;
        squaresAfter += errorAfter;
        ++prediction.blocks;
        prediction.betterIn += errorAfter < errorBefore ? 1 : 0;
    }
    const double rows = std::max<double>(1, static_cast<double>(before.residuals.size()));
    prediction.errorPercentBefore = std::sqrt(squaresBefore / rows);
    prediction.errorPercentAfter = std::sqrt(squaresAfter / rows);
    return prediction;
}

bool isClearlyBetter(const Prediction& prediction) {
    const double most = prediction.areRecordings ? mostOfRecordings : mostOfParts;
    return prediction.removed() > leastRemoved && prediction.betterIn >= most * prediction.blocks;
}

}  // namespace analogon
