#pragma once

#include <string>

#include "core/diagram/diagram.hpp"
#include "core/effect/catalogue/catalogue.hpp"

/// Several effects that specialise one component. A component has one class, so that a class is needed that holds them
/// all; it tells which by the vendor annotation
///
///   annotation(__Analogon(combines = {"Analogon.Effects.ElectricMechanical.VoltageDrop", …}))
///
/// and has the parameters of each, by the same names. Those whose strength is not among the component's modifiers are
/// off.
namespace analogon {

/// The class that a component takes for an effect that specialises it: the effect's own, or where the component is
/// specialised already, the first of the library that holds what it has and this one. Empty: it has it, or no class
/// holds them all.
std::string classWith(const Library& library, const Block& component, const EffectClass& effect);

/// The connector by which an effect that a component has already joins a node: "heatPort". Empty: none does. A second
/// effect with such a connector can only be of the same node.
std::string nodePortOf(const Library& library, const Block& component);

}  // namespace analogon
