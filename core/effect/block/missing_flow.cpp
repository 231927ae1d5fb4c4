#include "core/effect/block/missing_flow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/base/range.hpp"
#include "core/effect/block/law_probe.hpp"
#include "core/syntax/printer.hpp"

namespace analogon {
namespace {

/// Terms of an unknown course in time over each recording.
std::vector<Term> hats(double begin, double end, int pieces) {
    std::vector<Term> terms;
    const double width = (end - begin) / pieces;
    for (int k = 0; k <= pieces; ++k)
        terms.push_back({fmt::format("noEvent(max(0, 1 - abs(time - {})/{}))", syntax::printNumber(begin + k * width),
                                     syntax::printNumber(width)),
                         {},
                         {},
                         1});
    return terms;
}

}  // namespace

std::vector<FlowResponse> flowResponses(const NullModel& null, int pieces, const SimulationOptions& simulation,
                                        const Progress& progress, const std::set<std::string>& wanted) {
    std::vector<FlowResponse> responses;
    const auto isWanted = [&](const std::string& place) { return wanted.empty() || wanted.contains(place); };
    Diagram diagram;
    const Outcome<ModelNodes> nodes = nodesOf(null.variant, diagram);
    const Outcome<PreparedTask> held = prepareHeld(null.variant, {}, null.noise);
    if (!nodes || !held) return responses;
    const std::vector<int> fitted = recordingsOf(null.variant.task, Role::Fit);
    Range time;
    for (const int r : fitted) time.take(rangeOf(null.variant.task.recordings[static_cast<std::size_t>(r)].time));
    for (const ModelNodes::FlowNode& node : nodes->flowNodes()) {
        if (progress.stopRequested()) return responses;
        if (!isWanted(node.place.at)) continue;
        LawProbe probe(null, siteOf(node));
        probe.terms() = hats(time.low, time.high, pieces);
        std::optional<Eigen::MatrixXd> columns = probe.traces(fitted.size() > 1, simulation, progress);
        if (columns && columns->allFinite()) responses.push_back({probe.place().at, true, std::move(*columns)});
    }
    // an error of one sensor shows on its channel and nowhere else
    std::map<int, Eigen::MatrixXd> ofOutput;
    for (const ResidualChannel& c : null.channels) {
        Eigen::MatrixXd& columns = ofOutput[c.output];
        const Eigen::Index before = columns.cols();
        columns.conservativeResize(null.fit.optimum.residuals.size(), before + pieces + 1);
        columns.rightCols(pieces + 1).setZero();
        const int count = c.end - c.begin;
        for (int row = 0; row < count; ++row) {
            const double at = static_cast<double>(row) * pieces / std::max(1, count - 1);
            const int k = std::min(pieces - 1, static_cast<int>(at));
            columns(c.begin + row, before + k) = 1 - (at - k);
            columns(c.begin + row, before + k + 1) = at - k;
        }
    }
    for (auto& [output, columns] : ofOutput) {
        std::string place = std::string(outputPrefix) + held->system->outputs()[static_cast<std::size_t>(output)].name;
        if (isWanted(place)) responses.push_back({std::move(place), false, std::move(columns)});
    }
    return responses;
}

}  // namespace analogon
