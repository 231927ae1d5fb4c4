#include "core/effect/tell/offer.hpp"

#include <algorithm>
#include <iterator>

#include "core/effect/model/place.hpp"

namespace analogon {
namespace {

/// Where and when a proposal shows when nothing else is left: at its sensor, or where the noise has a memory.
void tellWhere(Remainder& r, const std::vector<ColouredNoise>& noise, const ModelState& state) {
    const auto fitted = std::find_if(state.experiments.begin(), state.experiments.end(),
                                     [](const ExperimentState& e) { return e.role == Role::Fit; });
    if (!noise.empty()) {
        r.output = noise.front().output;
        r.experiment = noise.front().experiment;
    } else if (fitted != state.experiments.end()) {
        r.output = fitted->outputs.front().name;
        r.experiment = fitted->name;
    }
    if (r.node.starts_with(outputPrefix)) r.output = r.node.substr(outputPrefix.size());
    for (const ExperimentState& e : state.experiments)
        if (e.name == r.experiment && r.to <= r.from) r.from = e.time.front(), r.to = e.time.back();
}

}  // namespace

void offer(std::vector<Remainder> proposed, const std::vector<ColouredNoise>& noise, const ModelState& state,
           std::vector<Remainder>& left) {
    for (Remainder& r : proposed) {
        if (left.empty()) {
            tellWhere(r, noise, state);
            continue;
        }
        const auto strongest = std::max_element(
            left.begin(), left.end(), [](const Remainder& a, const Remainder& b) { return a.evidence < b.evidence; });
        r.output = strongest->output;
        r.experiment = strongest->experiment;
        if (r.to <= r.from) {
            r.from = strongest->from;
            r.to = strongest->to;
        }
        r.movesWith = strongest->movesWith;
    }
    left.insert(left.begin(), std::make_move_iterator(proposed.begin()), std::make_move_iterator(proposed.end()));
}

void offerAlone(Remainder change, const std::vector<ColouredNoise>& noise, const ModelState& state,
                std::vector<Remainder>& left) {
    if (!left.empty() || !noise.empty()) offer({std::move(change)}, noise, state, left);
}

void keepWhatIsLeft(const NullModel& with, std::size_t proposals, const SimulationOptions& simulation,
                    std::vector<Remainder>& left) {
    if (left.size() <= proposals) return;
    const std::vector<Remainder> beside = leftovers(with, simulation).structure;
    left.erase(std::remove_if(left.begin() + static_cast<std::ptrdiff_t>(proposals), left.end(),
                              [&](const Remainder& r) {
                                  return std::none_of(beside.begin(), beside.end(), [&](const Remainder& b) {
                                      return b.output == r.output && b.experiment == r.experiment;
                                  });
                              }),
               left.end());
}

}  // namespace analogon
