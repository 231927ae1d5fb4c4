#include "core/study/practice_recording.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "core/base/fnv.hpp"

namespace analogon {

namespace {

constexpr double mostSamples = 1e7;

/// Normal numbers that are the same on every machine, which those of the standard library need not be (Box and Muller).
class Noise {
public:
    explicit Noise(std::uint64_t seed) : engine_(seed) {}
    double next() {
        const double radius = std::sqrt(-2 * std::log(uniform()));
        return radius * std::cos(2 * std::numbers::pi * uniform());
    }

private:
    double uniform() { return (static_cast<double>(engine_() >> 11) + 0.5) * 0x1p-53; }  // in (0, 1)
    std::mt19937_64 engine_;
};

std::vector<double> sampled(const std::vector<double>& time, const Eigen::VectorXd& values,
                            const std::vector<double>& raster) {
    std::vector<double> result;
    result.reserve(raster.size());
    for (const double t : raster) {
        const auto behind = std::upper_bound(time.begin(), time.end(), t);
        const auto k = static_cast<Eigen::Index>(behind - time.begin()) - 1;  // the last point that is not later
        if (behind == time.end() || time[static_cast<std::size_t>(k)] == t) {
            result.push_back(values[k]);
            continue;
        }
        const double begin = time[static_cast<std::size_t>(k)];
        result.push_back(values[k] + (values[k + 1] - values[k]) * (t - begin) / (*behind - begin));
    }
    return result;
}

Diagnostics faultsOf(const ExperimentState& run, const PracticeOptions& options) {
    if (run.time.empty() || run.outputs.empty()) return {error(phrase("the run has no values to record"))};
    const double span = run.time.back() - run.time.front();
    if (!(options.sampleTime > 0) || options.sampleTime > span)
        return {error(phrase("a sample time of {} s does not fit into a run of {} s", options.sampleTime, span), {},
                      phrase("Choose one above 0 that is shorter than the run."))};
    if (span / options.sampleTime > mostSamples)
        return {error(phrase("a sample time of {} s gives more than ten million samples", options.sampleTime), {},
                      phrase("Choose a longer one."))};
    for (const auto& [output, deviation] : options.noise)
        if (!(deviation >= 0) || !std::isfinite(deviation))
            return {error(phrase("the noise of '{}' cannot have the standard deviation {}", output, deviation), {},
                          phrase("Give 0 or more, in the unit of the output."))};
    return {};
}

}  // namespace

Outcome<Table> practiceRecording(const ExperimentState& run, const PracticeOptions& options) {
    if (Diagnostics faults = faultsOf(run, options); !faults.empty()) return faults;
    const double begin = run.time.front();
    // the last sample is not lost to rounding
    const auto count = static_cast<std::size_t>((run.time.back() - begin) / options.sampleTime * (1 + 1e-12)) + 1;
    Column time;
    time.name = "time";
    time.unit = "s";
    for (std::size_t k = 0; k < count; ++k) time.values.push_back(begin + static_cast<double>(k) * options.sampleTime);
    Table table;
    table.columns.push_back(std::move(time));
    for (const OutputState& output : run.outputs) {
        Column column;
        column.name = output.name;
        column.unit = output.unit;
        column.values = sampled(run.time, output.simulated, table.columns.front().values);
        const auto noise = options.noise.find(output.name);
        if (noise != options.noise.end() && noise->second > 0) {
            Noise draw(options.seed ^ fnv1a(output.name));  // each output has noise of its own
            for (double& value : column.values) value += noise->second * draw.next();
        }
        table.columns.push_back(std::move(column));
    }
    return table;
}

}  // namespace analogon
