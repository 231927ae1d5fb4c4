#include "core/effect/block/law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <set>

#include "core/base/parallel.hpp"
#include "core/effect/block/flow_domain.hpp"
#include "core/effect/thresholds.hpp"

namespace analogon {

using namespace threshold::law;

namespace {

std::string potentialName(const ModelNodes::FlowNode& node) { return node.place.connector + "." + node.potential; }

/// Whether a quantity is the angle of a shaft that turns on and on: nothing depends on how often it has turned.
bool turnsOn(const LawQuantity& q, const std::string& unit) { return unit == "rad" && q.range.width() > mostAngle; }

/// Products of two quantities of the model.
void addPairs(const std::vector<LawQuantity>& foreign, std::size_t j, std::vector<Term>& terms) {
    for (std::size_t k = j + 1; k < foreign.size(); ++k) terms.push_back(productOf(foreign[j], foreign[k], 3));
}

Eigen::VectorXd speed(const NullModel& null, const Eigen::VectorXd& angle, int experiment) {
    const std::vector<double>& time = fittedRecording(null.variant.task, experiment).time;
    Eigen::VectorXd w = Eigen::VectorXd::Zero(angle.size());
    for (Eigen::Index k = 1; k < angle.size(); ++k)
        w[k] = (angle[k] - angle[k - 1]) / (time[static_cast<std::size_t>(k)] - time[static_cast<std::size_t>(k - 1)]);
    return w;
}

LawProbe probeAt(const NullModel& null, const ModelNodes::FlowNode& node, const NamedUnits& others,
                 const Series& values) {
    LawProbe probe(null, siteOf(node));
    std::vector<Term>& terms = probe.terms();
    const FlowDomain domain = flowDomain(node.flow);
    const bool hasRate = !domain.rate.empty();
    const auto isRate = [&](const LawQuantity& q) { return q.name == domain.rate; };
    const std::string own = potentialName(node), potential = "port." + node.potential;
    std::vector<LawQuantity> local;
    if (const auto found = values.find(own); found != values.end()) {
        if (hasRate) {
            const std::string rate(domain.rate);
            std::vector<Eigen::VectorXd> speeds;
            for (std::size_t e = 0; e < found->second.size(); ++e)
                speeds.push_back(speed(null, found->second[e], static_cast<int>(e)));
            local.push_back(probe.addOwn(quantityOf(rate, "", rate, std::string(domain.rateUnit), speeds, 0),
                                         fmt::format("der({})", potential)));
        }
        const std::string unit(domain.potentialUnit);
        LawQuantity p = quantityOf("p", "", node.potential, unit, found->second, originOf(found->second.front()));
        if (!turnsOn(p, unit)) local.push_back(probe.addOwn(std::move(p), potential));
    }
    for (const LawQuantity& q : local) addPowers(q, isRate(q), 1, terms);
    if (!local.empty() && local.back().name == "p") addHinges(local.back(), local.back().range, terms);
    if (hasRate && !local.empty()) {
        const double largest = local.front().largest();
        addHinges(local.front(), {-largest, largest}, terms);
        if (local.size() == 2) addProducts(local[0], local[1], true, 1, terms);
    }
    const std::vector<LawQuantity> foreign = foreignQuantities(others, values, own, std::nan(""));
    for (std::size_t j = 0; j < foreign.size(); ++j) {
        probe.addForeign(foreign[j]);
        addPowers(foreign[j], false, 2, terms);
        for (const LawQuantity& q : local) addProducts(q, foreign[j], isRate(q), 2, terms);
        addPairs(foreign, j, terms);
    }
    return probe;
}

/// A reading that is bent, that picks up another quantity, or whose scale moves with one. Its gain and offset have
/// names.
LawProbe probeAt(const NullModel& null, const SignalInfo& output, const NamedUnits& others, const Series& values) {
    LawProbe probe(null, siteOf(output.name, output.unit));
    std::vector<Term>& terms = probe.terms();
    const auto found = values.find(output.name);
    if (found == values.end()) return probe;
    const bool isAngle = output.unit == "rad";
    const double origin = output.unit == "K" ? originOf(found->second.front()) : 0;
    const std::string reading = trueReading(output.name);
    const LawQuantity own = probe.addOwn(quantityOf("r", "", reading, output.unit, found->second, origin), "u");
    if (!isAngle) {
        addPowers(own, false, 1, terms);
        terms.erase(terms.begin());  // its gain
    } else if (showsWaves(own)) {
        addWaves(own, terms);
    }
    const std::vector<LawQuantity> foreign = foreignQuantities(others, values, output.name, origin);
    for (std::size_t j = 0; j < foreign.size(); ++j) {
        const LawQuantity& x = probe.addForeign(foreign[j]);
        addPowers(x, false, 2, terms);
        terms.push_back(productOf(own, x, 2));
        const bool isAlike = !output.unit.empty() && x.unit && own.unit && x.unit->text() == own.unit->text();
        if (isAlike)
            terms.push_back(
                {fmt::format("({} - {})", x.name, own.name), fmt::format("({} - {})", x.variable, reading), x.unit, 2});
        addPairs(foreign, j, terms);
    }
    return probe;
}

/// The best of each kind of place, no more than so many.
void keepBest(std::vector<LikelyTerms>& likely, std::size_t most) {
    std::stable_sort(likely.begin(), likely.end(),
                     [](const LikelyTerms& x, const LikelyTerms& y) { return x.set.explained > y.set.explained; });
    if (likely.size() > most) likely.erase(likely.begin() + static_cast<std::ptrdiff_t>(most), likely.end());
}

}  // namespace

std::vector<LawQuantity> foreignQuantities(const NamedUnits& others, const Series& values, const std::string& own,
                                           double origin) {
    std::vector<LawQuantity> found;
    const auto same = values.find(own);
    for (const auto& [name, unit] : others) {
        const auto x = values.find(name);
        if (x == values.end() || found.size() == mostQuantities) continue;
        if (same != values.end() && (x->second.front() - same->second.front()).cwiseAbs().maxCoeff() == 0) continue;
        const double zero = unit != "K" ? 0 : std::isnan(origin) ? originOf(x->second.front()) : origin;
        LawQuantity q = quantityOf("x" + std::to_string(found.size() + 1), name, name, unit, x->second, zero);
        if (!turnsOn(q, unit)) found.push_back(std::move(q));
    }
    return found;
}

bool showsWaves(const LawQuantity& angle) { return angle.range.width() > leastAngle; }

std::vector<LikelyTerms> likeliestTerms(std::vector<LikelyTerms> ofFlows, std::vector<LikelyTerms> ofSensors) {
    keepBest(ofFlows, mostOfFlows);
    keepBest(ofSensors, mostOfFlows / 2);
    std::vector<LikelyTerms> likely = std::move(ofFlows);
    likely.insert(likely.end(), std::make_move_iterator(ofSensors.begin()), std::make_move_iterator(ofSensors.end()));
    keepBest(likely, likely.size());
    return likely;
}

std::vector<Law> likelyLaws(const NullModel& null, int before, const SimulationOptions& simulation, int threads,
                            const Progress& progress) {
    std::vector<Law> laws;
    Diagram diagram;
    const Outcome<ModelNodes> nodes = nodesOf(null.variant, diagram);
    const Outcome<PreparedTask> held = prepareHeld(null.variant, {}, null.noise);
    if (!nodes || !held) return laws;
    const std::vector<ModelNodes::FlowNode> flowNodes = nodes->flowNodes();
    const NamedUnits others = quantitiesOf(*held->system);
    std::set<std::string> names;
    for (const ModelNodes::FlowNode& node : flowNodes) names.insert(potentialName(node));
    for (const auto& [name, unit] : others) names.insert(name);
    const Series values = movingSeries(null, *held, {names.begin(), names.end()}, simulation);
    std::vector<LawProbe> probes;
    for (const ModelNodes::FlowNode& node : flowNodes) probes.push_back(probeAt(null, node, others, values));
    for (const SignalInfo& output : held->system->outputs()) probes.push_back(probeAt(null, output, others, values));
    std::vector<std::vector<TermSet>> sets(probes.size());
    parallelFor(static_cast<int>(probes.size()), threads, [&](int k) {
        const auto i = static_cast<std::size_t>(k);
        if (progress.stopRequested()) return;
        if (const std::optional<Eigen::MatrixXd> columns = probes[i].traces(simulation, progress))
            sets[i] = likeliestSets(null, probes[i].terms(), *columns);
    });
    std::vector<LikelyTerms> ofFlows, ofSensors;
    for (std::size_t i = 0; i < probes.size(); ++i)
        for (TermSet& set : sets[i]) (i < flowNodes.size() ? ofFlows : ofSensors).push_back({i, std::move(set)});
    for (const LikelyTerms& each : likeliestTerms(std::move(ofFlows), std::move(ofSensors)))
        laws.push_back(probes[each.probe].law(each.set.terms, ++before));
    return laws;
}

}  // namespace analogon
