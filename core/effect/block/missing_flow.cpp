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

/// The rows of a residual that belong to a recording.
struct Rows {
    Eigen::Index begin{}, end{};
};

std::map<int, Rows> rowsOfRecordings(const std::vector<ResidualChannel>& channels) {
    std::map<int, Rows> rows;
    for (const ResidualChannel& c : channels) {
        Rows& own = rows.try_emplace(c.experiment, Rows{c.begin, c.end}).first->second;
        own = {std::min<Eigen::Index>(own.begin, c.begin), std::max<Eigen::Index>(own.end, c.end)};
    }
    return rows;
}

/// An error of one sensor shows on its channel and nowhere else: hats over its samples.
ResponseBlock errorOfSensor(const ResidualChannel& channel, int pieces) {
    const int count = channel.end - channel.begin;
    ResponseBlock block{channel.experiment, channel.begin, Eigen::MatrixXd::Zero(count, pieces + 1)};
    for (int row = 0; row < count; ++row) {
        const double at = static_cast<double>(row) * pieces / std::max(1, count - 1);
        const int k = std::min(pieces - 1, static_cast<int>(at));
        block.columns(row, k) = 1 - (at - k);
        block.columns(row, k + 1) = at - k;
    }
    return block;
}

}  // namespace

const ResponseBlock* FlowResponse::of(int recording) const {
    const auto found =
        std::find_if(blocks.begin(), blocks.end(), [&](const ResponseBlock& b) { return b.recording == recording; });
    return found != blocks.end() ? &*found : nullptr;
}

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
    const std::map<int, Rows> rows = rowsOfRecordings(null.channels);
    for (const ModelNodes::FlowNode& node : nodes->flowNodes()) {
        if (progress.stopRequested()) return responses;
        if (!isWanted(node.place.at)) continue;
        LawSite site = siteOf(node);
        std::string unit = site.unit ? site.unit->text() : std::string();
        LawProbe probe(null, std::move(site));
        probe.terms() = hats(time.low, time.high, pieces);
        // no recording feels what happens in another: the rows of each are the responses to its own pieces
        const std::optional<Eigen::MatrixXd> columns = probe.traces(simulation, progress);
        if (!columns || !columns->allFinite()) continue;
        FlowResponse response{probe.place().at, true, {}, (time.high - time.low) / pieces, std::move(unit)};
        for (const auto& [recording, own] : rows)
            response.blocks.push_back({recording, own.begin, columns->middleRows(own.begin, own.end - own.begin)});
        responses.push_back(std::move(response));
    }
    std::map<int, FlowResponse> ofOutput;
    for (const ResidualChannel& c : null.channels) ofOutput[c.output].blocks.push_back(errorOfSensor(c, pieces));
    for (auto& [output, response] : ofOutput) {
        response.place = std::string(outputPrefix) + held->system->outputs()[static_cast<std::size_t>(output)].name;
        if (isWanted(response.place)) responses.push_back(std::move(response));
    }
    return responses;
}

}  // namespace analogon
