#include "core/effect/model/place.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "core/base/unit.hpp"
#include "core/effect/catalogue/combination.hpp"
#include "core/library/measured_signals.hpp"

namespace analogon {
namespace {

void collectVariables(const Library& library, const LibraryClass& of, std::set<std::string>& variables, int depth) {
    if (depth > 20) return;
    for (const syntax::Extends& base : of.definition->bases)
        if (const LibraryClass* b = library.lookup(base.base, of.qualifiedName))
            collectVariables(library, *b, variables, depth + 1);
    if (of.definition->isShort)
        if (const LibraryClass* b = library.lookup(of.definition->shortBase, of.qualifiedName))
            collectVariables(library, *b, variables, depth + 1);
    for (const syntax::Component& c : of.definition->components) variables.insert((c.isFlow ? "flow " : "") + c.name);
}

/// What a variable was replaced by, in the direction of the sign: "phi" or a constant.
struct Representative {
    std::string name;
    bool isConstant{};
    double value{};
};

class AliasTable {
public:
    explicit AliasTable(const Structure& structure) : structure_(structure) {
        for (const auto& [variable, target] : structure.aliases) targets_[variable] = target;
    }

    Representative of(const std::string& name) const {
        VariableId variable = structure_.model->find(name);
        if (!variable.valid()) return {name};
        for (int guard = 0; guard < 1000; ++guard) {
            const auto found = targets_.find(variable);
            if (found == targets_.end()) break;
            const ExpressionNode* node = &(*structure_.pool)[found->second];
            if (node->operation == Operation::Negate) node = &(*structure_.pool)[node->a];
            if (node->operation == Operation::Constant) return {name, true, node->value};
            if (node->operation != Operation::Variable) break;
            variable = node->variable;
        }
        return {(*structure_.model)[variable].name};
    }

    bool isInput(const std::string& name) const {
        const VariableId id = structure_.model->find(name);
        return id.valid() &&
               std::find(structure_.inputs.begin(), structure_.inputs.end(), id) != structure_.inputs.end();
    }

private:
    const Structure& structure_;
    std::map<VariableId, ExpressionId> targets_;
};

/// Connectors joined by wires, each connector in exactly one set.
class UnionFind {
public:
    int find(const std::string& name) {
        const auto [it, isNew] = index_.try_emplace(name, static_cast<int>(parent_.size()));
        if (isNew) parent_.push_back(it->second);
        return root(it->second);
    }
    void join(const std::string& a, const std::string& b) {
        const int x = find(a), y = find(b);
        parent_[static_cast<std::size_t>(std::max(x, y))] = std::min(x, y);
    }

private:
    int root(int i) {
        while (parent_[static_cast<std::size_t>(i)] != i) i = parent_[static_cast<std::size_t>(i)];
        return i;
    }
    std::map<std::string, int> index_;
    std::vector<int> parent_;
};

std::string potentialOf(const std::string& signature) {
    // the one variable without `flow`; physical connectors of the library have exactly one
    std::size_t begin = 0;
    while (begin < signature.size()) {
        const std::size_t end = std::min(signature.find(';', begin), signature.size());
        const std::string part = signature.substr(begin, end - begin);
        if (part.rfind("flow ", 0) != 0) return part;
        begin = end + 1;
    }
    return {};
}

std::string flowOf(const std::string& signature) {
    const std::size_t at = signature.find("flow ");
    if (at == std::string::npos) return {};
    return signature.substr(at + 5, signature.find(';', at) - at - 5);
}

/// Whether a recording compares or drives something that is no input or output by the text of the model.
bool isMeasuredWithin(const Library& library, const std::string& className, const std::string& name) {
    const MeasuredSignals& measured = library.measured(className);
    const auto isIn = [&](const std::vector<std::string>& names) {
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    if (!isIn(measured.compared) && !isIn(measured.driven)) return false;
    if (name.find('.') != std::string::npos) return true;
    const LibraryClass* const model = library.find(className);
    const auto& components = model->definition->components;
    const auto own =
        std::find_if(components.begin(), components.end(), [&](const syntax::Component& c) { return c.name == name; });
    if (own == components.end() || own->causality != syntax::Causality::None) return false;
    const LibraryClass* const type = library.lookup(own->type, className);
    return !type || type->definition->restriction != syntax::ClassDefinition::Restriction::Connector;
}

}  // namespace

std::string connectorSignature(const Library& library, std::string_view connectorClass) {
    const LibraryClass* c = library.find(connectorClass);
    if (c == nullptr) return {};
    std::set<std::string> variables;
    collectVariables(library, *c, variables, 0);
    std::string text;
    for (const std::string& v : variables) text += (text.empty() ? "" : ";") + v;
    return text;
}

std::string keyOf(const EffectClass& effect, const EffectPlace& place) {
    return effect.className + "@" + place.at + "@" + place.spare + "@" + place.node;
}

ModelNodes::ModelNodes(const Library& library, const Diagram& diagram, const Structure& structure)
    : library_(library), diagram_(diagram) {
    const AliasTable aliases(structure);
    UnionFind sets;
    for (const Wire& w : diagram.wires) sets.join(w.from, w.to);
    std::map<int, std::size_t> nodeOf;
    for (const Block& b : diagram.blocks) {
        if (b.isConnector) continue;
        for (const Port& p : b.ports) {
            const std::string signature = connectorSignature(library, p.className);
            if (signature.find("flow ") == std::string::npos) continue;  // a signal
            const std::string connector = b.name + "." + p.name;
            const auto [it, isNew] = nodeOf.try_emplace(sets.find(connector), nodes_.size());
            if (isNew) {
                const Representative potential = aliases.of(connector + "." + potentialOf(signature));
                nodes_.push_back(
                    {signature, {}, potential.name, potential.isConstant || aliases.isInput(potential.name)});
            }
            const Representative flow = aliases.of(connector + "." + flowOf(signature));
            nodes_[it->second].members.push_back(
                {connector, p.className, !(flow.isConstant && flow.value == 0), b.isEffect});
        }
    }
    // nothing is inserted where a signal is none of the model's own connectors
    const FlatModel& model = *structure.model;
    for (const auto& [ids, signals] :
         {std::pair(&structure.inputs, &inputs_), std::pair(&structure.outputs, &outputs_)})
        for (const VariableId id : *ids)
            if (!isMeasuredWithin(library, model.name, model[id].name))
                signals->emplace_back(model[id].name, model.unitOf(model[id]));
}

std::vector<EffectPlace> ModelNodes::attachPlaces(const std::string& signature) const {
    std::vector<EffectPlace> places;
    std::set<std::string> taken;
    for (const Node& n : nodes_) {
        if (n.signature != signature || n.isImposed || !taken.insert(n.potential).second) continue;
        // named by a block of the model that takes part in the balance, not by a sensor or an effect added before
        const auto named = [&](bool mayBeSensor) {
            return std::find_if(n.members.begin(), n.members.end(),
                                [&](const Member& m) { return !m.isEffect && (mayBeSensor || m.takesFlow); });
        };
        auto member = named(false);
        if (member == n.members.end()) member = named(true);
        if (member == n.members.end()) {
            taken.erase(n.potential);
            continue;
        }
        places.push_back({member->connector, member->connector, {}});
    }
    return places;
}

std::vector<ModelNodes::FlowNode> ModelNodes::flowNodes() const {
    std::vector<FlowNode> found;
    std::set<std::string> signatures;
    for (const Node& n : nodes_) {
        if (!signatures.insert(n.signature).second) continue;
        for (EffectPlace& place : attachPlaces(n.signature))
            for (const Node& of : nodes_)
                for (const Member& m : of.members)
                    if (m.connector == place.connector)
                        found.push_back({place, m.className, potentialOf(n.signature), flowOf(n.signature)});
    }
    return found;
}

std::vector<std::string> ModelNodes::inputsIn(const std::string& unit) const {
    std::vector<std::string> found;
    for (const auto& [name, of] : inputs_)
        if (of == unit) found.push_back(std::string(inputPrefix) + name);
    return found;
}

std::string ModelNodes::unitAt(const EffectPlace& place) const {
    for (const auto* side : {&inputs_, &outputs_})
        for (const auto& [name, unit] : *side)
            if (place.at == std::string(side == &inputs_ ? inputPrefix : outputPrefix) + name) return unit;
    return {};
}

std::vector<EffectPlace> ModelNodes::insertPlaces(const std::string& signature) const {
    std::vector<EffectPlace> places;
    for (const Node& n : nodes_) {
        if (n.signature != signature || n.members.size() < 2) continue;
        std::vector<EffectPlace> cuts;
        for (const Member& m : n.members)
            if (m.takesFlow && !m.isEffect) cuts.push_back({m.connector, m.connector, {}});
        if (n.members.size() == 2 && cuts.size() == 2) cuts.pop_back();  // both cuts are the same
        places.insert(places.end(), cuts.begin(), cuts.end());
    }
    return places;
}

bool ModelNodes::isSource(const std::string& connector, const std::string& signature) const {
    const std::size_t dot = connector.rfind('.');
    const Block* block = diagram_.find(connector.substr(0, dot));
    if (block == nullptr) return false;
    const auto alike = std::count_if(block->ports.begin(), block->ports.end(), [&](const Port& p) {
        return connectorSignature(library_, p.className) == signature;
    });
    return alike == 1 && block->ports.size() > 1;
}

bool ModelNodes::areNeighbours(const Node& a, const Node& b) const {
    const std::set<std::string> first = blocksAt(a, true), second = blocksAt(b, true);
    return std::any_of(first.begin(), first.end(), [&](const std::string& block) { return second.contains(block); });
}

std::vector<EffectPlace> ModelNodes::bridgePlaces(const std::string& signature) const {
    const std::vector<EffectPlace> ends = attachPlaces(signature);
    std::vector<EffectPlace> places;
    for (std::size_t i = 0; i < ends.size(); ++i)
        for (std::size_t j = i + 1; j < ends.size(); ++j) {
            const Node *a = nodeOf(ends[i].connector), *b = nodeOf(ends[j].connector);
            if (a == nullptr || b == nullptr || areNeighbours(*a, *b)) continue;
            places.push_back({ends[i].at + bridgeJoint + ends[j].at, ends[i].connector, {}, ends[j].connector});
        }
    return places;
}

std::vector<EffectPlace> ModelNodes::signalPlaces(const EffectClass& effect) const {
    std::vector<EffectPlace> places;
    const bool isOutput = effect.placement.signalSide == "output";
    for (const auto& [name, unit] : isOutput ? outputs_ : inputs_) {
        if (!effect.placement.quantity.empty() && !areConvertible(unit, effect.placement.quantity)) continue;
        places.push_back({std::string(isOutput ? outputPrefix : inputPrefix) + name, name, {}});
    }
    return places;
}

/// What replaces a block must have its connectors, and no more but those that it brings itself.
bool ModelNodes::keepsConnectors(const Block& block, const EffectClass& effect) const {
    std::set<std::string> left;
    for (const Port& p : readPorts(library_, effect.className)) left.insert(p.name);
    left.erase(effect.placement.channel);
    left.erase(effect.placement.node);
    // those of effects that are in it already
    const auto isOwn = [&](const Port& p) { return left.erase(p.name) == 0; };
    const std::vector<Port> ports = readPorts(library_, block.className);
    const bool misses = std::any_of(ports.begin(), ports.end(), isOwn);
    return block.isEffect || (!misses && left.empty());
}

const ModelNodes::Node* ModelNodes::nodeOf(const std::string& connector) const {
    const auto found = std::find_if(nodes_.begin(), nodes_.end(), [&](const Node& n) {
        return std::any_of(n.members.begin(), n.members.end(),
                           [&](const Member& m) { return m.connector == connector; });
    });
    return found == nodes_.end() ? nullptr : &*found;
}

bool ModelNodes::isOneNode(const std::string& a, const std::string& b) const {
    const Node *first = nodeOf(a), *second = nodeOf(b);
    return (first ? first->potential : a) == (second ? second->potential : b);
}

std::size_t ModelNodes::blocksAt(const std::string& connector) const {
    const Node* const own = nodeOf(connector);
    return own == nullptr ? 0 : blocksAt(*own, false).size();
}

std::set<std::string> ModelNodes::blocksAt(const Node& own, bool withEffects) const {
    std::set<std::string> blocks;
    for (const Node& n : nodes_) {
        if (n.signature != own.signature || n.potential != own.potential) continue;
        for (const Member& m : n.members)
            if (withEffects || !m.isEffect) blocks.insert(m.connector.substr(0, m.connector.rfind('.')));
    }
    return blocks;
}

std::vector<EffectPlace> ModelNodes::specialisePlaces(const EffectClass& effect,
                                                      const std::vector<std::string>& spares) const {
    std::vector<EffectPlace> places;
    for (const Block& b : diagram_.blocks) {
        if (b.isConnector || !b.isResolved) continue;
        if (!library_.isDerived(b.className, effect.base) || classWith(library_, b, effect).empty()) continue;
        if (!keepsConnectors(b, effect)) continue;
        const std::string own = nodePortOf(library_, b);
        if (!effect.placement.node.empty())
            for (const EffectPlace& n : attachPlaces(signatureOf(effect, effect.placement.node))) {
                if (own.empty() || isOneNode(b.name + "." + own, n.connector))
                    places.push_back({b.name, b.name, {}, n.connector});
            }
        else if (effect.placement.channel.empty())
            places.push_back({b.name, b.name, {}});
        else
            for (const std::string& s : spares) places.push_back({b.name, b.name, s});
    }
    return places;
}

std::string ModelNodes::signatureOf(const EffectClass& effect, const std::string& port) const {
    for (const Port& p : readPorts(library_, effect.className))
        if (p.name == port) return connectorSignature(library_, p.className);
    return {};
}

std::vector<EffectPlace> ModelNodes::placesFor(const EffectClass& effect,
                                               const std::vector<std::string>& spares) const {
    if (effect.placement.way == Way::Specialise) return specialisePlaces(effect, spares);
    if (!effect.placement.signalSide.empty()) return signalPlaces(effect);
    if (effect.placement.ports.empty()) return {};
    const std::string signature = signatureOf(effect, effect.placement.ports.front());
    if (signature.empty()) return {};
    if (effect.placement.way == Way::Bridge) return bridgePlaces(signature);
    if (effect.placement.way == Way::Insert) {
        std::vector<EffectPlace> places = insertPlaces(signature);
        if (effect.placement.behindSource)
            std::erase_if(places, [&](const EffectPlace& place) { return !isSource(place.connector, signature); });
        return places;
    }
    if (effect.placement.channel.empty()) return attachPlaces(signature);
    std::vector<EffectPlace> driven;
    for (const EffectPlace& p : attachPlaces(signature))
        for (const std::string& s : spares) driven.push_back({p.at, p.connector, s});
    return driven;
}

}  // namespace analogon
