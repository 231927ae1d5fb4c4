#include "core/effect/judge/prediction.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/range.hpp"
#include "core/effect/judge/disturbance.hpp"
#include "core/effect/model/held_out.hpp"
#include "core/effect/model/model_state.hpp"
#include "core/effect/thresholds.hpp"

namespace analogon {

using namespace threshold::prediction;
using threshold::acceptance::clearEvidence;
using threshold::acceptance::heldOutFolds;

namespace {

constexpr int fewestRecordings = 3;  // from which on whole ones are left out: two may tell different parameters

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

/// Sums of squares [% squared] of a part that was left out: of what its own mean leaves, and of what each model does.
struct PartErrors {
    double rows{}, aboutMean{}, before{}, after{};
};

/// Sums up what is found of one part after the other.
class PredictionSum {
public:
    void add(const PartErrors& part) {
        const auto [rows, aboutMean, before, after] = part;
        parts_.push_back(part);
        ++found_.blocks;
        found_.betterIn += after < before ? 1 : 0;
        found_.clearlyIn += std::sqrt(after) < (1 - leastRemoved) * std::sqrt(before) ? 1 : 0;
    }
    Prediction of(bool areRecordings) {
        // What neither foretells better than its own mean would, as the one recording of a sign of the torque, is large
        // by chance in the one or the other, and would decide alone.
        const auto isForetold = [](const PartErrors& p) { return std::min(p.before, p.after) < p.aboutMean; };
        const bool isAny = areRecordings && std::any_of(parts_.begin(), parts_.end(), isForetold);
        PartErrors sum;
        for (const PartErrors& p : parts_) {
            if (isAny && !isForetold(p)) continue;
            sum.rows += p.rows;
            sum.before += p.before;
            sum.after += p.after;
        }
        found_.errorPercentBefore = std::sqrt(sum.before / std::max(1.0, sum.rows));
        found_.errorPercentAfter = std::sqrt(sum.after / std::max(1.0, sum.rows));
        found_.areRecordings = areRecordings;
        return found_;
    }

private:
    std::vector<PartErrors> parts_;
    Prediction found_;
};

/// Sum of squares about their mean.
double squaresAboutMean(const std::vector<double>& values) {
    double sum = 0, squares = 0;
    for (const double v : values) sum += v;
    const double mean = values.empty() ? 0 : sum / static_cast<double>(values.size());
    for (const double v : values) squares += (v - mean) * (v - mean);
    return squares;
}

/// What its own mean leaves of a part, each channel with its own. [% squared]
double aboutMeanOf(const std::vector<ResidualChannel>& channels, const std::vector<Eigen::Index>& rows,
                   const Eigen::VectorXd& percent) {
    double squares = 0;
    for (const ResidualChannel& c : channels) {
        std::vector<double> values;
        for (std::size_t i = 0; i < rows.size(); ++i)
            if (rows[i] >= c.begin && rows[i] < c.end && c.measured.size() > 0)
                values.push_back(c.measured[rows[i] - c.begin] * percent[static_cast<Eigen::Index>(i)]);
        squares += squaresAboutMean(values);
    }
    return squares;
}

int recordingsIn(const std::vector<ResidualChannel>& channels) {
    int last = -1;
    for (const ResidualChannel& c : channels) last = std::max(last, c.experiment);
    return last + 1;
}

/// The parts into which recordings are cut, and which a sample is of.
struct Cut {
    explicit Cut(int count) : recordings(count), areWhole(count >= fewestRecordings) {}

    int parts() const { return std::min(areWhole ? recordings : recordings * partsOfARecording, heldOutFolds); }
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
        sum.add({static_cast<double>(rows.size()), aboutMeanOf(without.channels, rows, percent),
                 part.without.cwiseProduct(percent).squaredNorm(), part.with.cwiseProduct(percent).squaredNorm()});
    }
    return sum.of(Cut(recordingsIn(without.channels)).areWhole);
}

Prediction predictAsChosen(const Prediction& chosen, const NullModel& without, const NullModel& with, int more,
                           const SimulationOptions& simulation, const Progress& progress) {
    Prediction found = predict(without, with.fit);
    if (!chosen.besideFlow) return found;
    const BesideDisturbance alone = besideDisturbance(without, simulation, progress);
    found.besideFlow = evidenceBeside(alone, besideDisturbanceAlso(alone, with, simulation, progress),
                                      with.fit.optimum.residuals.size(), more);
    return found;
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
    std::vector<Recording>& recordings = rest.task.recordings.edit();
    for (int e = 0; e < static_cast<int>(recordings.size()); ++e) {
        Recording& r = recordings[static_cast<std::size_t>(e)];
        for (Eigen::Index k = 0; k < r.outputs.cols(); ++k)
            if (cut.partOf(e, k, r.outputs.cols()) == part) r.outputs.col(k).setConstant(std::nan(""));
    }
    return rest;
}

/// A part of the simulated outputs, in percent of the range of each.
struct PartLeftOut {
    double rows{}, aboutMean{}, squares{};
};

PartLeftOut partOf(const ModelState& state, const Cut& cut, int part) {
    PartLeftOut found;
    for (std::size_t e = 0; e < state.experiments.size(); ++e)
        for (const OutputState& o : state.experiments[e].outputs) {
            const double range = rangeOf(o.measured).width();
            std::vector<double> measured;
            for (Eigen::Index k = 0; range > 0 && k < o.measured.size(); ++k) {
                if (std::isnan(o.measured[k]) || cut.partOf(static_cast<int>(e), k, o.measured.size()) != part)
                    continue;
                measured.push_back(100 * o.measured[k] / range);
                found.squares += std::pow(100 * (o.measured[k] - o.simulated[k]) / range, 2);
            }
            found.rows += static_cast<double>(measured.size());
            found.aboutMean += squaresAboutMean(measured);
        }
    return found;
}

/// A part that the model is fitted without; nothing where it cannot be.
std::optional<PartLeftOut> leftOutByRefit(const FittedAlone& model, const Cut& cut, int part, const FitOptions& options,
                                          const Progress& progress) {
    const Outcome<NullModel> rest =
        fitNull(withoutPart(model.variant, cut, part), model.noise, NoiseLevel::Keep, options, progress);
    if (!rest) return std::nullopt;
    Variant whole = model.variant;
    whole.values = rest->variant.values;
    const Outcome<ModelState> state = stateOf(whole, rest->fit, options.simulation, progress, Detail::Errors);
    if (!state) return std::nullopt;
    const PartLeftOut found = partOf(*state, cut, part);
    return std::isfinite(found.squares) ? std::optional(found) : std::nullopt;
}

}  // namespace

std::optional<Prediction> predictByRefits(const NullModel& without, const NullModel& with, const FitOptions& options,
                                          const Progress& progress) {
    const FittedAlone before(without), after(with);
    const Cut cut(static_cast<int>(before.variant.task.recordings.size()));
    PredictionSum sum;
    for (int part = 0; part < cut.parts(); ++part) {
        const auto left = leftOutByRefit(before, cut, part, options, progress),
                   leftWith = leftOutByRefit(after, cut, part, options, progress);
        if (!left || !leftWith) return std::nullopt;
        sum.add({left->rows, left->aboutMean, left->squares, leftWith->squares});
    }
    return sum.of(cut.areWhole);
}

bool isClearlyBetter(const Prediction& prediction) {
    if (prediction.besideFlow) return *prediction.besideFlow > clearEvidence && prediction.removed() > 0;
    const double most = prediction.areRecordings ? mostOfRecordings : mostOfParts;
    // Of whole recordings each must bear it out by itself: where one cannot be foretold without the others (its sign of
    // a torque is in no other), that one alone would decide. Parts of one recording hang together: as in a sign test,
    // half a part is taken off (5 of 5, 8 of 10).
    const double better = prediction.areRecordings ? prediction.clearlyIn : prediction.betterIn - 0.5;
    const double least =
        prediction.blocks > partsOfARecording || prediction.areRecordings ? leastRemoved : leastRemovedOfOne;
    return prediction.removed() > least && better >= most * prediction.blocks;
}

}  // namespace analogon
