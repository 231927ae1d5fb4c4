#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/effect/model/null_model.hpp"

namespace analogon {

/// An effect at a place.
struct Candidate {
    EffectClass effect;
    EffectPlace place;
};

/// One way to switch a candidate on: its shape, and the strength at which the trace was taken.
struct Probe {
    std::map<std::string, double> values;  // shape parameters
    double secant{};                       // 0: slope at strength 0
    ColumnScore plain;                     // against the residual as it is
    ColumnScore whitened;                  // with the noise made white; without its directions
    Eigen::VectorXd column;                // trace of the strength, in units of the noise; of the best probe alone
    bool isAlongRecorded{};                // of a wave along the recorded course of its variable
    double strength() const;               // best estimate, 0 when the sign is wrong
    std::vector<double> linear() const;    // of the further linear parameters
};

/// A candidate with what its probes show.
struct Screened {
    Candidate candidate;
    Variant wired;  // the effect in the model, fixed values set, parameters not yet freed
    std::map<std::string, double> fixed;
    std::shared_ptr<const Variant> recorded;  // `wired` along the recorded course of its variable; null: none is told
    std::vector<Probe> probes;                // best first
    Text failure;                             // why it could not be tried; empty: it was

    double score() const;  // fall in the sum of squares of the best probe (right sign)
    double whitenedScore() const;
    bool isAbsorbed() const;  // no probe is visible
    bool isWrongSign() const;
    std::vector<std::string> absorbedBy;  // parameters that imitate it
};

/// The nodes of a variant. `diagram` receives its drawing, which they refer to.
Outcome<ModelNodes> nodesOf(const Variant& variant, Diagram& diagram);

/// Sorts items by how many parts of the model meet at their connectors, the most first; else they keep their order.
template <class Item, class ConnectorOf>
void mostPartsFirst(const Variant& variant, std::vector<Item>& items, const ConnectorOf& connectorOf) {
    if (items.size() < 2) return;
    Diagram diagram;
    if (const Outcome<ModelNodes> nodes = nodesOf(variant, diagram))
        std::stable_sort(items.begin(), items.end(), [&](const Item& a, const Item& b) {
            return nodes->blocksAt(connectorOf(a)) > nodes->blocksAt(connectorOf(b));
        });
}

/// Every effect of the catalogue at every place where it fits.
Outcome<std::vector<Candidate>> candidatesFor(const Variant& variant, const std::vector<EffectClass>& catalogue);

/// The options with a limit on the effort of one simulation, the same on any machine: a candidate that is far too
/// stiff for the recording is given up.
SimulationOptions limited(const NullModel& null, SimulationOptions simulation);

/// Takes a candidate's traces and scores them (Rao's score test; secants where the slope at 0 misleads).
Screened screen(const NullModel& null, const Candidate& candidate, const SimulationOptions& simulation,
                const Progress& progress);

}  // namespace analogon
