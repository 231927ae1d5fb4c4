#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/effect/model/place.hpp"
#include "core/syntax/text_edit.hpp"

namespace analogon {

/// An effect put into the text of a model.
struct WiredEffect {
    syntax::TextEdit edit;  // undoes as one
    std::string instance;   // "coulomb", or the specialised component
    std::string newInput;   // top-level input that carries a spare channel; empty: none
};

/// The edit that adds an effect at a place (attach: a component and a connection; insert: a component between a
/// connector and the rest of its node, or between a signal and what it feeds; specialise: another class).
/// `values` are written as modifications of the instance, and so are `expressions` (the parameters of a twin: "lag.T").
Outcome<WiredEffect> wireIn(const Library& library, const syntax::ClassDefinition& model, const EffectClass& effect,
                            const EffectPlace& place, const std::map<std::string, double>& values,
                            const std::map<std::string, std::string>& expressions = {});

/// An effect at several places at once, switched off: joined to nodes (attach, bridge) and to an input of the model or
/// none, between connectors and their nodes (insert), or in place of components that join no further node (specialise).
struct WiredBeside {
    syntax::TextEdit edit;
    std::vector<std::string> instances;  // one for each place
};

/// For what is simulated and never shown: nothing is laid out.
Outcome<WiredBeside> wireInBeside(const Library& library, const syntax::ClassDefinition& model,
                                  const EffectClass& effect, const std::vector<EffectPlace>& places);

}  // namespace analogon
