#include "core/effect/judge/prediction.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/range.hpp"
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

/// Sums up what is found of one part after the other.
class PredictionSum {
public:
    /// Sums of squares [% squared] of a part.
    void add(double before, double after) {
        before_ += before;
        after_ += after;
        ++found_.blocks;
        found_.betterIn += after < before ? 1 : 0;
    }
    Prediction of(Eigen::Index rows, bool areRecordings) {
        const double count = std::max<double>(1, static_cast<double>(rows));
        found_.errorPercentBefore = std::sqrt(before_ / count);
        found_.errorPercentAfter = std::sqrt(after_ / count);
        found_.areRecordings = areRecordings;
        return found_;
    }

private:
    double before_{}, after_{};
    Prediction found_;
};

int recordingsIn(const std::vector<ResidualChannel>& channels) {
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
    const Cut cut(recordingsIn(channels));
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
    PredictionSum sum;
    for (const std::vector<Eigen::Index>& rows : partsLeftOut(without.channels)) {
        const LeftOutPart part = heldOut.part(rows);
        const Eigen::VectorXd percent = scale(rows);
        sum.add(part.without.cwiseProduct(percent).squaredNorm(), part.with.cwiseProduct(percent).squaredNorm());
    }
    return sum.of(before.residuals.size(), Cut(recordingsIn(without.channels)).areWhole);
}

namespace {

/// A model on its fitted recordings alone, with the noise of each.
struct FittedAlone {
    explicit FittedAlone(const NullModel& model) : variant(model.variant) {
        variant.task.recordings.clear();
        for (const int r : recordingsOf(model.variant.task, Role::Fit)) {
            variant.task.recordings.push_back(model.variant.task.recordings[static_cast<std::size_t>(r)]);
            if (!model.noise.empty()) noise.push_back(model.noise[static_cast<std::size_t>(r)]);
        }
    }

    Variant variant;
    std::vector<Eigen::VectorXd> noise;
};

/// Without the samples of a part.
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
double squaresLeftOut(const FittedAlone& model, const Cut& cut, int part, const FitOptions& options,
                      const Progress& progress) {
    const Outcome<NullModel> rest =
        fitNull(withoutPart(model.variant, cut, part), model.noise, NoiseLevel::Keep, options, progress);
    if (!rest) return -1;
    Variant whole = model.variant;
    whole.values = rest->variant.values;
    const Outcome<ModelState> state = stateOf(whole, rest->fit, options.simulation, progress, Detail::Errors);
    if (!state) return -1;
    double squares = 0;
    for (std::size_t e = 0; e < state->experiments.size(); ++e)
        for (const OutputState& o : state->experiments[e].outputs) {
            const double range = rangeOf(o.measured).width();
            for (Eigen::Index k = 0; range > 0 && k < o.measured.size(); ++k)
                if (!std::isnan(o.measured[k]) && cut.partOf(static_cast<int>(e), k, o.measured.size()) == part)
                    squares += std::pow(100 * (o.measured[k] - o.simulated[k]) / range, 2);
        }
    return std::isfinite(squares) ? squares : -1;
}

}  // namespace

std::optional<Prediction> predictByRefits(const NullModel& without, const NullModel& with, const FitOptions& options,
                                          const Progress& progress) {
    const FittedAlone before(without), after(with);
    const Cut cut(static_cast<int>(before.variant.task.recordings.size()));
    PredictionSum sum;
    for (int part = 0; part < cut.parts(); ++part) {
        const double squaresBefore = squaresLeftOut(before, cut, part, options, progress),
                     squaresAfter = squaresLeftOut(after, cut, part, options, progress);
        if (squaresBefore < 0 || squaresAfter < 0) return std::nullopt;
        sum.add(squaresBefore, squaresAfter);
    }
    return sum.of(without.fit.optimum.residuals.size(), cut.areWhole);
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
