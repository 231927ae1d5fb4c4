#pragma once

#include <optional>
#include <set>

#include "core/flat/flattening.hpp"

namespace analogon {

/// Gives variables their attributes and values: the modifications of built-in types.
class Binder {
public:
    explicit Binder(Flattening& work) : work_(work) {}

    /// All variables; binding equations of continuous ones are added to the model.
    void bindAll();
    /// The value expressions of a parameter's element, when they are needed early. False: none (reported).
    bool bindParameter(Instance& instance, Element& element);
    /// Whether an initial equation says what a parameter with fixed = false is in terms of parameters alone: then it is
    /// its value, and no condition of the start.
    bool takeInitialValue(const FlatEquation& equation);
    /// No parameter depends on itself, none on a variable, each has a value.
    void checkParameters();

private:
    void bindAttributes(Instance& instance, Element& element);
    void setAttribute(Instance& instance, Element& element, const std::string& name, const Modifier& modifier);
    void setText(FlatVariable& variable, const std::string& name, const Value& value, std::size_t at);
    void setNumber(FlatVariable& variable, const std::string& name, double number);
    void setStateSelect(Element& element, const Modifier& modifier);
    bool bindValue(Instance& instance, Element& element);
    std::optional<Value> valueFor(Instance& instance, Element& element, const Modifier& modifier, const Text& what);
    bool fitsType(const Element& element, const Value& value) const;
    void freeParameters(Instance& instance, Element& element);
    void bindFreeParameters();
    bool followsFoundAtStart(const FlatVariable& variable);
    void freeFollowers();
    void checkParameter(VariableId id);

    Flattening& work_;
    std::set<VariableId> free_;   // parameters with fixed = false
    std::set<VariableId> bound_;  // those of them that are no unknowns any more: an initial equation was their value
};

}  // namespace analogon
