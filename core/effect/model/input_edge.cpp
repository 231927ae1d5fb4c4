#include "core/effect/model/input_edge.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/range.hpp"
#include "core/effect/model/sampling.hpp"
#include "core/effect/model/white_noise.hpp"
#include "core/effect/thresholds.hpp"

namespace analogon {

using namespace threshold::inputEdge;
using threshold::noise::clearOfNoise;

namespace {

constexpr double mostSamples = 1e5;  // that are simulated to look at each edge once
constexpr double sharpness = 1e-4;   // of an interval, that a jump takes

/// What an interval of a recording holds, by the input it happens to.
using Edges = std::map<int, const InputEdge*>;

/// Where in its interval a jump is drawn: it takes time, and stays clear of the samples.
double drawnPart(const InputEdge& edge) { return std::clamp(edge.part, nearestToSample, 1 - nearestToSample); }

double valueAt(const Eigen::MatrixXd& inputs, int input, const InputEdge& edge, double at) {
    const double before = inputs(input, edge.sample), after = inputs(input, edge.sample + 1);
    if (edge.bend == 0) return at < drawnPart(edge) ? before : after;
    const double line = (1 - at) * before + at * after;
    return line + (2 * edge.part - 1) * edge.bend * (1 - std::abs(2 * at - 1));
}

/// The moments to be added in an interval: before and behind each jump, and at the middle of each bend.
std::vector<double> momentsOf(const Edges& edges) {
    std::vector<double> moments;
    for (const auto& [input, edge] : edges)
        if (edge->bend != 0)
            moments.push_back(0.5);
        else
            for (const double side : {-0.5, 0.5}) moments.push_back(drawnPart(*edge) + side * sharpness);
    std::sort(moments.begin(), moments.end());
    // as many wherever the jumps are, none at the same time as another
    for (std::size_t i = 1; i < moments.size(); ++i)
        moments[i] = std::max(moments[i], moments[i - 1] + 0.1 * sharpness);
    return moments;
}

int rowOf(const Recording& recording, const std::string& input) {
    const auto found = std::find(recording.inputNames.begin(), recording.inputNames.end(), input);
    return static_cast<int>(found - recording.inputNames.begin());
}

}  // namespace

bool areHeld(const std::vector<InputEdge>& edges) {
    return std::all_of(edges.begin(), edges.end(), [](const InputEdge& e) { return e.bend == 0 && e.part > asHeld; });
}

std::vector<InputEdge> inputEdges(const EstimationTask& task) {
    struct Found {
        InputEdge edge;
        double size{};  // of the input's range
    };
    std::vector<Found> found;
    for (std::size_t r = 0; r < task.recordings.size(); ++r) {
        const Recording& recording = task.recordings[r];
        if (recording.role != Role::Fit) continue;
        for (Eigen::Index i = 0; i < recording.inputs.rows(); ++i) {
            if (recording.isHeld(recording.inputNames[static_cast<std::size_t>(i)]))
                continue;  // when it jumps is known
            const Eigen::VectorXd u = recording.inputs.row(i).transpose();
            const double range = rangeOf(u).width();
            const double least = std::max(leastJump * range, clearOfNoise * whiteNoise(u));
            for (Eigen::Index k = 1; k + 2 < u.size(); ++k) {
                const double before = u[k] - u[k - 1], change = u[k + 1] - u[k], behind = u[k + 2] - u[k + 1];
                InputEdge edge{static_cast<int>(r), recording.inputNames[static_cast<std::size_t>(i)],
                               static_cast<int>(k)};
                const double corner = std::max(std::abs(change - before), std::abs(behind - change));
                const bool isFlatAside = std::max(std::abs(before), std::abs(behind)) <= mostAside * std::abs(change);
                if (isFlatAside && std::abs(change) > least) {
                    found.push_back({edge, std::abs(change) / range});
                } else if (corner > 2 * least && std::abs(change) > mostAside * corner) {
                    edge.bend = corner / 4;
                    found.push_back({edge, 0.5 * corner / range});
                }
            }
        }
    }
    std::stable_sort(found.begin(), found.end(), [](const Found& a, const Found& b) { return a.size > b.size; });
    const double samples = 1 + static_cast<double>(fittedSamples(task));
    const auto most = std::clamp(static_cast<std::size_t>(mostSamples / samples), fewestEdges, mostEdges);
    std::vector<InputEdge> edges;
    for (std::size_t i = 0; i < std::min(found.size(), most); ++i) edges.push_back(found[i].edge);
    return edges;
}

void place(EstimationTask& task, const std::vector<InputEdge>& edges) {
    for (std::size_t r = 0; r < task.recordings.size(); ++r)
        place(task.recordings.edit()[r], static_cast<int>(r), edges);
}

void place(Recording& recording, int index, const std::vector<InputEdge>& edges) {
    std::map<int, Edges> bySample;
    for (const InputEdge& e : edges)
        if (e.recording == index) bySample[e.sample][rowOf(recording, e.input)] = &e;
    if (bySample.empty()) return;
    const Recording from = recording;
    std::vector<double> time;
    std::vector<Eigen::VectorXd> inputs;
    std::vector<std::pair<int, double>> origin;  // of each new sample: that before it, and the part passed since
    for (int k = 0; k < static_cast<int>(from.time.size()); ++k) {
        time.push_back(from.time[static_cast<std::size_t>(k)]);
        inputs.emplace_back(from.inputs.col(k));
        origin.emplace_back(k, 0.0);
        const auto here = bySample.find(k);
        if (here == bySample.end()) continue;
        const double width = from.time[static_cast<std::size_t>(k) + 1] - from.time[static_cast<std::size_t>(k)];
        for (const double at : momentsOf(here->second)) {
            time.push_back(from.time[static_cast<std::size_t>(k)] + at * width);
            Eigen::VectorXd& then = inputs.emplace_back((1 - at) * from.inputs.col(k) + at * from.inputs.col(k + 1));
            for (Eigen::Index i = 0; i < then.size(); ++i)
                if (from.isHeld(from.inputNames[static_cast<std::size_t>(i)])) then[i] = from.inputs(i, k);
            for (const auto& [input, edge] : here->second) then[input] = valueAt(from.inputs, input, *edge, at);
            origin.emplace_back(k, at);
        }
    }
    const auto count = static_cast<Eigen::Index>(time.size());
    recording.time = std::move(time);
    recording.inputs.resize(from.inputs.rows(), count);
    recording.outputs = Eigen::MatrixXd::Constant(from.outputs.rows(), count, std::nan(""));
    for (SpareChannel& s : recording.spares) s.values.assign(static_cast<std::size_t>(count), 0);
    for (Eigen::Index j = 0; j < count; ++j) {
        const auto [k, part] = origin[static_cast<std::size_t>(j)];
        recording.inputs.col(j) = inputs[static_cast<std::size_t>(j)];
        if (part == 0) recording.outputs.col(j) = from.outputs.col(k);
        for (std::size_t s = 0; s < recording.spares.size(); ++s) {
            const std::vector<double>& values = from.spares[s].values;
            const auto at = static_cast<std::size_t>(k);
            recording.spares[s].values[static_cast<std::size_t>(j)] =
                part == 0 ? values[at] : (1 - part) * values[at] + part * values[at + 1];
        }
    }
}

}  // namespace analogon
