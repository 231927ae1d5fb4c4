#include "core/effect/model/thin.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/effect/model/sampling.hpp"
#include "core/fit/held_input.hpp"

namespace analogon {
namespace {

/// Mean over what is there of [begin, end); NaN when nothing is.
template <typename At>
double meanOf(const At& at, long begin, long end) {
    double sum = 0;
    long count = 0;
    for (long k = begin; k < end; ++k)
        if (const double x = at(k); !std::isnan(x)) {
            sum += x;
            ++count;
        }
    return count > 0 ? sum / static_cast<double>(count) : std::nan("");
}

void thin(Recording& recording, int factor) {
    const Recording from = recording;
    const auto count = static_cast<long>(from.time.size());
    // the middle of the first block lies as far behind the first sample as the others lie apart: a linear model may
    // take exact steps, which must all be as long
    std::vector<std::pair<long, long>> blocks{{0, 1}};
    for (long k = (factor + 1) / 2; k + factor <= count; k += factor) blocks.emplace_back(k, k + factor);
    const auto samples = static_cast<Eigen::Index>(blocks.size());
    recording.time.resize(blocks.size());
    recording.inputs.resize(from.inputs.rows(), samples);
    recording.outputs.resize(from.outputs.rows(), samples);
    for (SpareChannel& s : recording.spares) s.values.resize(blocks.size());
    for (Eigen::Index b = 0; b < samples; ++b) {
        const auto [begin, end] = blocks[static_cast<std::size_t>(b)];
        const auto column = [&](const Eigen::MatrixXd& values, Eigen::Index row) {
            return meanOf([&](long k) { return values(row, k); }, begin, end);
        };
        const auto entry = [&](const std::vector<double>& values) {
            return meanOf([&](long k) { return values[static_cast<std::size_t>(k)]; }, begin, end);
        };
        recording.time[static_cast<std::size_t>(b)] = entry(from.time);
        for (Eigen::Index i = 0; i < from.inputs.rows(); ++i) recording.inputs(i, b) = column(from.inputs, i);
        for (Eigen::Index o = 0; o < from.outputs.rows(); ++o) recording.outputs(o, b) = column(from.outputs, o);
        for (std::size_t s = 0; s < from.spares.size(); ++s)
            recording.spares[s].values[static_cast<std::size_t>(b)] = entry(from.spares[s].values);
    }
    for (Eigen::Index i = 0; i < from.inputs.rows(); ++i)
        if (from.isHeld(from.inputNames[static_cast<std::size_t>(i)]))
            recording.inputs.row(i) = heldMeans(from.time, from.inputs.row(i), recording.time);
}

void keepFirst(Recording& recording, Eigen::Index samples) {
    const auto count = static_cast<std::size_t>(samples);
    recording.time.resize(count);
    recording.inputs = recording.inputs.leftCols(samples).eval();
    recording.outputs = recording.outputs.leftCols(samples).eval();
    for (SpareChannel& s : recording.spares) s.values.resize(count);
}

}  // namespace

EstimationTask thinned(const EstimationTask& task, const Thinning& thinning, long mostSamples) {
    EstimationTask shorter = task;
    if (thinning.isWhole()) return shorter;
    for (Recording& r : shorter.recordings.edit())
        if (r.role == Role::Fit && thinning.factor > 1) thin(r, thinning.factor);
    const auto samples = static_cast<long>(fittedSamples(shorter));
    if (!thinning.isFirstPart || samples <= mostSamples) return shorter;
    for (Recording& r : shorter.recordings.edit())
        if (r.role == Role::Fit)
            keepFirst(
                r, std::max<long>(std::min<long>(2, std::ssize(r.time)), std::ssize(r.time) * mostSamples / samples));
    return shorter;
}

Thinning thinningFor(const EstimationTask& task, long mostSamples) {
    const auto factor = static_cast<int>((static_cast<long>(fittedSamples(task)) + mostSamples - 1) / mostSamples);
    return {factor < 2 ? 1 : factor | 1, false};
}

Thinning finer(const Thinning& thinning) { return {thinning.factor < 4 ? 1 : (thinning.factor / 3) | 1, true}; }

}  // namespace analogon
