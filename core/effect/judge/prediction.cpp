#include "core/effect/judge/prediction.hpp"

#include <algorithm>
#include <cmath>

#include "core/effect/model/held_out.hpp"
#include "core/effect/model/model_state.hpp"
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

/// The parts into which recordings are cut, and which a sample is of.
struct Cut {
    explicit Cut(int count) : recordings(count), areWhole(count >= fewestRecordings) {}

    int parts() const { return std::min(areWhole ? recordings : recordings * partsOfARecording, mostParts); }
    int partOf(int recording, long sample, long samples) const {
        const long own = areWhole ? recording : recording * partsOfARecording + sample * partsOfARecording / samples;
        return static_cast<int>(own % parts());
    }

    int recordings;
    bool areWhole;
};

}  // namespace

std::vector<std::vector<Eigen::Index>> partsLeftOut(const std::vector<ResidualChannel>& channels) {
    const Cut cut(recordingsOf(channels));
    std::vector<std::vector<Eigen::Index>> rows(static_cast<std::size_t>(cut.parts()));
    for (const ResidualChannel& c : channels)
        for (int row = c.begin; row < c.end; ++row) {
            const long sample = c.samples[static_cast<std::size_t>(row - c.begin)];
            rows[static_cast<std::size_t>(cut.partOf(c.experiment, sample, c.samples.back() + 1))].push_back(row);
        }
    std::erase_if(rows, [](const auto& part) { return part.empty(); });
    return rows;
}

Prediction predict(const NullModel& without, const FitResult& with) {
    const Linearisation &before = without.fit.optimum, &after = with.optimum;
    const HeldOut heldOut(before, after);
    const Eigen::VectorXd scale = percentOfRange(without.channels, before.residuals.size());
    Prediction prediction;
    prediction.areRecordings = Cut(recordingsOf(without.channels)).areWhole;
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

namespace {

/// A model of the fitted recordings alone, without the samples of a part.
Variant withoutPart(const Variant& variant, const Cut& cut, int part) {
    Variant rest = variant;
    std::vector<Recording>& recordings = rest.task.recordings;
    for (int e = 0; e < static_cast<int>(recordings.size()); ++e) {
        Recording& r = recordings[static_cast<std::size_t>(e)];
        for (Eigen::Index k = 0; k < r.outputs.cols(); ++k)
            if (cut.partOf(e, k, r.outputs.cols()) == part) r.outputs.col(k).setConstant(std::nan(""));
    }
    return rest;
}

/// Sum of squares, in percent of the range of each output, of a part that the model is fitted without; negative: it
/// cannot be.
double squaresLeftOut(const NullModel& model, const Variant& whole, const Cut& cut, int part, const FitOptions& options,
                      const Progress& progress) {
    const Outcome<NullModel> rest =
        fitNull(withoutPart(whole, cut, part), model.noise, NoiseLevel::Keep, options, progress);
    if (!rest) return -1;
    Variant there = whole;
    there.values = rest->variant.values;
    const Outcome<ModelState> state = stateOf(there, rest->fit, options.simulation, progress, Detail::Errors);
    if (!state) return -1;
    double squares = 0;
    for (std::size_t e = 0; e < state->experiments.size(); ++e)
        for (const OutputState& o : state->experiments[e].outputs) {
            const auto isMeasured = o.measured.array().isFinite();
            if (!isMeasured.any()) continue;
            const double range = isMeasured.select(o.measured.array(), -1e300).maxCoeff() -
                                 isMeasured.select(o.measured.array(), 1e300).minCoeff();
            for (Eigen::Index k = 0; range > 0 && k < o.measured.size(); ++k)
                if (isMeasured[k] && cut.partOf(static_cast<int>(e), k, o.measured.size()) == part)
                    squares += std::pow(100 * (o.measured[k] - o.simulated[k]) / range, 2);
        }
    return std::isfinite(squares) ? squares : -1;
}

Variant fittedAlone(const Variant& variant) {
    Variant alone = variant;
    std::erase_if(alone.task.recordings, [](const Recording& r) { return r.role != Role::Fit; });
    return alone;
}

}  // namespace

std::optional<Prediction> predictByRefits(const NullModel& without, const NullModel& with, const FitOptions& options,
                                          const Progress& progress) {
    const Variant before = fittedAlone(without.variant), after = fittedAlone(with.variant);
    const Cut cut(static_cast<int>(before.task.recordings.size()));
    Prediction prediction;
    prediction.areRecordings = cut.areWhole;
    double squaresBefore = 0, squaresAfter = 0;
    for (int part = 0; part < cut.parts(); ++part) {
        const double errorBefore = squaresLeftOut(without, before, cut, part, options, progress),
                     errorAfter = squaresLeftOut(with, after, cut, part, options, progress);
        if (errorBefore < 0 || errorAfter < 0) return std::nullopt;
        squaresBefore += errorBefore;
        squaresAfter += errorAfter;
        ++prediction.blocks;
        prediction.betterIn += errorAfter < errorBefore ? 1 : 0;
    }
    const double rows = std::max<double>(1, static_cast<double>(without.fit.optimum.residuals.size()));
    prediction.errorPercentBefore = std::sqrt(squaresBefore / rows);
    prediction.errorPercentAfter = std::sqrt(squaresAfter / rows);
    return prediction;
}

bool isClearlyBetter(const Prediction& prediction) {
    const double most = prediction.areRecordings ? mostOfRecordings : mostOfParts;
    // parts of one recording hang together: as in a sign test, half a part is taken off (5 of 5, 8 of 10)
    const double better = prediction.areRecordings ? prediction.betterIn : prediction.betterIn - 0.5;
    const double least =
        prediction.blocks > partsOfARecording || prediction.areRecordings ? leastRemoved : leastRemovedOfOne;
    return prediction.removed() > least && better >= most * prediction.blocks;
}

}  // namespace analogon
