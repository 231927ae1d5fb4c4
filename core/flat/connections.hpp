#pragma once

#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "core/flat/flattening.hpp"
#include "core/flat/translator.hpp"

namespace analogon {

/// Disjoint sets of small integers; the smallest member stands for its set.
class DisjointSets {
public:
    std::uint32_t add();
    std::uint32_t find(std::uint32_t member) const;
    void join(std::uint32_t a, std::uint32_t b);
    std::uint32_t size() const { return static_cast<std::uint32_t>(parent_.size()); }

private:
    mutable std::vector<std::uint32_t> parent_;  // paths are shortened while they are followed
};

/// Connection sets and their equations (Modelica 3.6, sections 9.1 to 9.3). A connector of the class that holds
/// the connect equation is outside, one of its components inside; the same variable seen from outside and from
/// inside belongs to different sets.
class Connections {
public:
    explicit Connections(Flattening& work) : work_(work) {}

    void connect(const syntax::Equation& equation, const Scope& scope);
    /// Potentials equal, flows sum to zero, an unconnected flow is 0.
    void addEquations();
    /// The sets of whole connectors, for FlatModel::connections.
    void listSets();
    bool isConnectedInside(VariableId id) const;
    /// In how many connections a connector stands. Nothing: not all of them were read yet.
    std::optional<int> cardinality(const std::string& connector);
    /// An input of a component that sets it itself, since cardinality() has told that nothing is connected to it.
    bool isSetWithin(VariableId input);
    void allAreRead() { isComplete_ = true; }
    /// A signal of an expandable connector (section 9.1.3). After addEquations(): whether what stands in the component
    /// that has the connector gives its value; else the component reads it, as an input.
    bool isBusSignal(VariableId id) const;
    bool isDrivenWithin(VariableId signal) const;

private:
    struct Connector {
        std::string name;
        std::string className;
        std::vector<VariableId> variables;  // scalars that are neither parameter nor constant
        std::vector<std::string> members;   // their names below the connector; one empty for a signal
    };
    struct Side {
        std::vector<Connector> connectors;
        std::vector<int> dimensions;
        bool isOutside{};
    };
    struct Member {
        VariableId variable;
        bool isOutside{};
        Instance* level{};  // whose connect equation it is
        Span span;
    };

    std::optional<Side> side(const syntax::Expression& expression, const Scope& scope);
    bool isSwitchedOff(const syntax::Name& name, const Scope& scope);
    void collectVariables(Instance& instance, std::size_t prefix, Connector& connector);
    bool fit(const Connector& a, const Connector& b, const Span& span);
    bool unitsFit(VariableId a, VariableId b, const Span& span, const std::string& connection);
    void join(const Connector& a, bool aOutside, const Connector& b, bool bOutside, const Scope& scope,
              const Span& span);
    std::uint32_t memberOf(VariableId variable, bool isOutside, const Scope& scope, const Span& span);
    std::uint32_t connectorSet(const Connector& connector);

    Instance* levelOf(const Member& member) const;
    const Member& outermostOf(const std::vector<std::uint32_t>& set) const;
    void dropUnusedSignals();
    void flowEquation(const std::vector<std::uint32_t>& set);
    void potentialEquations(const std::vector<std::uint32_t>& set);
    void unconnectedFlows();
    void unconnectedInputs();
    bool isSetByEquation(VariableId input);
    bool isBoundByItself(VariableId id) const;
    std::vector<bool> inputsInEquations() const;
    std::string memberLabel(const Member& member) const;
    std::string connectorName(VariableId id) const;

    Flattening& work_;
    std::vector<Member> members_;
    std::vector<std::uint32_t> memberIndex_;  // by 2 * variable + isOutside; 0: none, else index + 1
    DisjointSets sets_;
    std::vector<std::vector<std::uint32_t>> membersOf_;  // by the member that stands for its set
    std::vector<bool> isUnused_;                         // by variable: a signal of a bus that nothing is connected to
    std::vector<std::pair<std::string, std::string>> connectors_;  // name, class
    std::unordered_map<std::string, std::uint32_t> connectorIndex_;
    DisjointSets connectorSets_;
    std::unordered_map<std::string, int> ends_;  // by the connector's name
    std::unordered_set<std::string> foundOpen_;  // connectors that cardinality() found without a connection
    bool isComplete_{};
    std::optional<std::vector<bool>> isSet_;  // inputs that an equation of the class around their component holds
};

}  // namespace analogon
