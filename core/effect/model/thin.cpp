#include "core/effect/model/thin.hpp"

#include <cmath>

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

}  // namespace

EstimationTask thinned(const EstimationTask& task, int factor) {
    EstimationTask shorter = task;
    if (factor < 2) return shorter;
    for (Recording& r : shorter.recordings.edit())
        if (r.role == Role::Fit) thin(r, factor);
    return shorter;
}

int thinningFor(const EstimationTask& task, long mostSamples) {
    long samples = 0;
    for (const Recording& r : task.recordings)
        if (r.role == Role::Fit) samples += static_cast<long>(r.time.size());
    const auto factor = static_cast<int>((samples + mostSamples - 1) / mostSamples);
    return factor < 2 ? factor : factor | 1;
}

}  // namespace analogon
