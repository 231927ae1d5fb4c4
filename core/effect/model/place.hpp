#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/diagram/diagram.hpp"
#include "core/effect/catalogue/catalogue.hpp"
#include "core/structure/structure.hpp"

namespace analogon {

/// Where an effect can go in a composed model.
struct EffectPlace {
    std::string at;         // as the report says it: "rotor.flange_a", "element", "output i_mod"
    std::string connector;  // attach, insert: "rotor.flange_a" or the top-level signal's name; specialise: the instance
    std::string spare;      // what drives its signal input: a recorded channel or "input NAME" of the model
    std::string node{};     // connector of the node that the effect's further connector joins, of a bridge the second

    bool operator==(const EffectPlace&) const = default;
};

/// One text for an effect of a class at a place.
std::string keyOf(const EffectClass& effect, const EffectPlace& place);

/// Before the name of a signal of the model, where it is an effect's place or drives an effect.
inline constexpr std::string_view inputPrefix = "input ", outputPrefix = "output ";

/// Between the two places of a bridge: "heater1.port <-> heater2.port".
inline constexpr const char* bridgeJoint = " <-> ";

/// The connectors of a composed model by the node they belong to, with what the structure knows of them.
class ModelNodes {
public:
    ModelNodes(const Library& library, const Diagram& diagram, const Structure& structure);

    /// A node of the model whose balance of flows may lack something.
    struct FlowNode {
        EffectPlace place;
        std::string connectorClass;   // of place.connector
        std::string potential, flow;  // its variables: "phi", "tau"
    };
    /// All of them but those whose potential is imposed, one each.
    std::vector<FlowNode> flowNodes() const;

    /// Inputs of the model in a unit, as a place writes them: "input T_room".
    std::vector<std::string> inputsIn(const std::string& unit) const;

    /// How many blocks of the model meet at the potential of a connector; 0: it is none.
    std::size_t blocksAt(const std::string& connector) const;

    /// Unit of the input or output of the model at a signal's place; empty: unknown.
    std::string unitAt(const EffectPlace& place) const;

    /// All places at which an effect can go. Connectors on one rigid shaft, or on heat ports of equal temperature, are
    /// one place (named by its first connector); nodes whose potential is imposed take no attached effect.
    std::vector<EffectPlace> placesFor(const EffectClass& effect, const std::vector<std::string>& spares) const;

private:
    struct Member {
        std::string connector;  // "rotor.flange_a"
        std::string className;  // of the connector
        bool takesFlow{};       // false: an ideal sensor
        bool isEffect{};
    };
    struct Node {
        std::string signature;  // what flows here: "phi, flow tau"
        std::vector<Member> members;
        std::string potential;  // representative of the potential among all aliases
        bool isImposed{};       // the potential is an input or a constant
    };

    std::vector<EffectPlace> attachPlaces(const std::string& signature) const;
    std::vector<EffectPlace> insertPlaces(const std::string& signature) const;
    /// Whether a block turns something else into what flows at its one connector of this kind.
    bool isSource(const std::string& connector, const std::string& signature) const;
    /// Blocks that meet at the potential of a node.
    std::set<std::string> blocksAt(const Node& own, bool withEffects) const;
    /// Whether one block joins the two.
    bool areNeighbours(const Node& a, const Node& b) const;
    /// Pairs of nodes that no block joins.
    std::vector<EffectPlace> bridgePlaces(const std::string& signature) const;
    std::vector<EffectPlace> signalPlaces(const EffectClass& effect) const;
    /// Whether two connectors have one potential.
    bool isOneNode(const std::string& a, const std::string& b) const;
    const Node* nodeOf(const std::string& connector) const;
    bool keepsConnectors(const Block& block, const EffectClass& effect) const;
    std::vector<EffectPlace> specialisePlaces(const EffectClass& effect, const std::vector<std::string>& spares) const;
    /// Signature of a connector that an effect class has; empty: it has none of that name.
    std::string signatureOf(const EffectClass& effect, const std::string& port) const;

    const Library& library_;
    const Diagram& diagram_;
    std::vector<Node> nodes_;
    std::vector<std::pair<std::string, std::string>> inputs_, outputs_;  // name, unit
};

/// The variables of a connector class, flow ones marked: connectors with equal signatures fit together.
std::string connectorSignature(const Library& library, std::string_view connectorClass);

}  // namespace analogon
