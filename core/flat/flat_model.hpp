#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/base/outcome.hpp"
#include "core/flat/expression.hpp"
#include "core/library/library.hpp"

namespace analogon {

enum class FlatType { Real, Integer, Boolean, String };
enum class FlatVariability { Constant, Parameter, Continuous };
enum class FlatCausality { Local, Input, Output };  // of the top level only
enum class StateSelect { Never, Avoid, Default, Prefer, Always };

/// One scalar variable. Arrays are expanded: "x[3]".
struct FlatVariable {
    std::string name;  // "rotor.flange_a.phi"
    FlatType type{FlatType::Real};
    FlatVariability variability{FlatVariability::Continuous};
    FlatCausality causality{FlatCausality::Local};
    bool isFlow{};
    bool isDiscrete{};  // changes at events alone: no Real, or set by a when
    bool isProtected{};
    bool isFoundAtStart{};  // a parameter with fixed = false: an initial equation gives its value
    bool isFinal{};         // a final modification: an inspector does not offer it, a fit refuses it
    bool isStructural{};    // its value has shaped the equations (array size, condition): changing it needs a new
                            // flatten()
    std::string unit;       // empty: not given
    std::string displayUnit;
    std::string quantity;
    std::string description;
    std::optional<double> min, max, nominal;
    ExpressionId start{};  // invalid: not given (0)
    bool isFixed{};        // fixed = true
    StateSelect stateSelect{StateSelect::Default};
    ExpressionId binding{};  // parameters and constants: value expression; invalid: none. The binding of a
                             // continuous variable is an equation, not this.
    std::string text;        // value of a String parameter
    Span declared;           // where it is declared
    Span value;              // where its binding or modification stands; invalid: nowhere
};

/// left = right.
struct FlatEquation {
    ExpressionId left, right;
    Span span;
    std::string component;  // instance it came from ("" = top level); for connection equations the set's first member
    bool fromConnection{};
    bool isDiscrete{};  // of a when: its left side is the variable that it sets
};

/// Connectors joined by connect equations.
struct ConnectionSet {
    std::vector<std::string> connectors;  // "rotor.flange_a"; a top-level connector: "v_cmd"
    std::string connectorClass;           // qualified class of the first member
};

/// An instance of the composed model, for places of effects, balance messages and the diagram.
struct FlatComponent {
    std::string name;       // "rotor", nested "drive.rotor"
    std::string className;  // qualified
    int unknowns{};         // continuous scalars declared in it (connector variables counted as the specification does)
    int equations{};        // equations of its own, including bindings and the flow equations it must supply
    Span span;
};

/// What happens at events (Modelica 3.6, section 8.5 and appendix B): the quantities that its equations speak of as
/// variables, and what is done beside them.
struct FlatEvents {
    struct Sample {
        VariableId flag;  // true at start, start + interval, …
        ExpressionId start, interval;
    };
    struct Reinit {
        ExpressionId condition, variable, value;
        Span span;
    };
    /// An element that is chosen while the model runs; outside of 1:extent there is none, and its value is NaN.
    struct Subscript {
        ExpressionId index;
        int extent{};
        Span span;
    };
    struct Check {
        ExpressionId condition;  // assert: must hold; terminate: ends the simulation where it holds
        std::string message;
        bool isWarning{};
        bool isTerminate{};
        Span span;
    };

    std::vector<std::pair<VariableId, VariableId>> pres;  // pre(x) and x
    VariableId initial, terminal;                         // invalid: nobody asks
    std::vector<Sample> samples;
    std::vector<Reinit> reinits;
    std::vector<Check> checks;
    std::vector<Subscript> subscripts;
    /// What a use of the model that knows no events says of them.
    Diagnostics refusals;
};

/// The composed model as scalar equations over scalar variables.
struct FlatModel {
    std::string name;  // qualified class
    std::shared_ptr<ExpressionPool> pool;
    std::vector<FlatVariable> variables;
    std::vector<FlatEquation> equations;
    std::vector<FlatEquation> initialEquations;
    std::vector<ConnectionSet> connections;
    std::vector<FlatComponent> components;
    FlatEvents events;
    std::vector<SourcePtr> sources;  // keep the spans alive

    const FlatVariable& operator[](VariableId id) const { return variables[id.value]; }
    /// Invalid when unknown.
    VariableId find(std::string_view name) const;
    /// Whether something outside sets it. What the equations say of events (pre(x), initial()) comes from the
    /// simulation.
    bool isInput(VariableId id) const;
    /// Value of a parameter or constant with all bindings followed; empty when it has none (or a cycle).
    std::optional<double> parameterValue(VariableId id) const;
    /// Unit of a variable; of what it is connected to where it was declared without one.
    std::string unitOf(const FlatVariable& variable) const;
    /// The connection set that holds the connector; null when it is unconnected.
    const ConnectionSet* connectionOf(std::string_view connector) const;

    std::unordered_map<std::string, VariableId> byName;
};

/// Instantiates a class: inheritance, modifications, redeclarations, arrays, connections (potentials equal,
/// flows sum to zero, an unconnected flow is 0). Modelica 3.6, chapters 5 to 9. Messages name component and
/// place. Balance is checked per component and in total (section 4.7).
Outcome<FlatModel> flatten(const Library& library, std::string_view className);

/// Modelica-like listing of variables and equations, for people and golden files.
std::string print(const FlatModel& model);

}  // namespace analogon
