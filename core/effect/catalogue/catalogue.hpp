#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/effect/catalogue/finding.hpp"
#include "core/library/library.hpp"

/// The effects known to a library: classes with the vendor annotation
///
///   annotation(__Analogon(effect(
///     kind = "friction.coulomb",        // contract, section 3
///     way = "attach",                   // attach | insert | specialise | bridge
///     ports = {"flange"},               // attach: its connector; insert: the two sides {"flange_a","flange_b"},
///                                       // for signals {"u","y"}; bridge: one for each node; specialise: absent
///     flexible = true,                  // its form may follow what other effects do: chosen only where noise is left
///     behindSource = true,              // insert: only where the first side is what a block turns something else into
///     at = "output",                    // signals only: insert at a top-level "output" or "input"
///     inSignalUnit = {"b"},             // signals only: parameters in the unit of the signal
///     inSignalRate = {"a"},             // and those in that unit per second
///     strength = "tau_c",               // 0 = off
///     oneSided = true,                  // the physical sign: strength >= 0
///     linear = {"tau_s"},               // further parameters in which the model is linear at 0
///     fixed(w_eps = "0.002*maxabs(w)"), // set before screening and kept
///     states = 2,                       // that it must add to the model, or its place is none (both sides turn)
///     reach(phi_h = 3),                 // factor by which a shape, or a strength below its secants, may leave the
///                                       // values it is tried with; at the low end of it the effect is not what it is
///                                       // called, and is none
///     part(tau_c = 0.05),               // of the strength, that a further parameter is at least as a rule; below it,
///                                       // two other effects may be meant
///     sharper(w_eps = 0.25),            // factor by which a numerical width falls where the data ask for it
///     shape(w_s = {"0.05*maxabs(w)", "0.3*maxabs(w)"}),  // tried in turn, freed in the refit
///     whole = {"n"},                    // shapes that are whole numbers as a rule: first held at what is tried
///     phase = "phi_0",                  // the flow is strength*sin(waves*along - phase): two traces a quarter turn
///     along = "phi", waves = "n",       // apart span all; `along` is taken as recorded where an output tells it
///                                       // (absent: no such trace, 1)
///     valid = "n*range(phi) - 6.28",    // a shape for which this is not above 0 is left out
///     proposal = "flange.tau = a*w^3",  // no named effect: offered as this equation, never added by itself
///     secant = {"2*sample", "8*sample"},// strengths of the screening where the slope at 0 misleads
///     quantity = "K",                   // signals and channels: restrict to those of this unit; absent: any
///     node = "heatPort",                // specialise: a connector to be joined to a node of the model
///     channel = "flow",                 // specialise, attach: a signal input that a recorded, unused channel drives
///     orInput = true)))                 // or an input of the model in the unit of `quantity`
///
/// Texts are Modelica expressions over sample, duration (of the recording, s) and range(v), minimum(v), maximum(v),
/// maxabs(v), rms(v), mean(v), start(v), rate(v), through(port) of the variables v and connectors of the effect's own
/// instance, as simulated with the effect off; what `along` passes as it was recorded, where an output tells it.
namespace analogon {

/// Where in a model an effect may be, and what it is joined to there.
struct EffectPlacement {
    Way way{Way::Attach};
    std::vector<std::string> ports;
    bool behindSource{};     // inserted where something is turned into what flows, alone
    std::string signalSide;  // "input", "output" or empty
    std::string quantity;
    std::string channel;  // signal input driven by a spare channel; empty: none
    bool orInput{};       // an input of the model in that unit may drive it as well
    std::string node;     // connector joined to an existing node; empty: none
};

/// What of an effect is estimated, and what is set.
struct EffectParameters {
    std::string strength;
    bool oneSided{};
    std::vector<std::string> linear;
    std::map<std::string, std::string> fixed;  // parameter -> expression
    std::map<std::string, std::vector<std::string>> shape;
    std::vector<std::string> whole;                       // shapes that are whole numbers as a rule
    std::map<std::string, std::string> units;             // of its own parameters
    std::vector<std::string> inSignalUnit, inSignalRate;  // its parameters in the unit of the signal; that per second
};

/// How an effect is tried.
struct EffectTrial {
    std::vector<std::string> secant;
    std::string valid;
    std::map<std::string, double> reach;    // shape -> factor by which it may leave the values it is tried with
    std::map<std::string, double> part;     // further parameter -> share of the strength that it has as a rule
    std::map<std::string, double> sharper;  // numerical parameter -> factor
    bool flexible{};                        // its form may follow what other effects do
    int states{};                           // that it must add, or its place is none
};

/// A flow strength*sin(waves*along - phase).
struct EffectWave {
    std::string phase;  // empty: the flow is none
    std::string along;  // a variable of its own
    std::string waves;  // a shape; empty: 1
};

struct EffectClass {
    std::string className, description, kind;
    EffectPlacement placement;
    EffectParameters parameters;
    EffectTrial trial;
    EffectWave wave;
    std::string proposal;                      // equation; empty: a named effect
    std::string base;                          // specialise: qualified name of the class it extends
    std::map<std::string, std::string> bound;  // inputs -> variable of the model (a law found for one model alone)
};

/// What is wrong with a signal, on whichever side it is: the kind without it ("lag", "offset").
std::string faultOf(const EffectClass& effect);

/// The effect that a class is by its annotation. Nothing: it is none, or the annotation is malformed.
std::optional<EffectClass> effectOf(const Library& library, const LibraryClass& one);

/// Effects that a class holds at once by its annotation `combines` (core/effect/catalogue/combination.hpp).
std::vector<std::string> combinedIn(const LibraryClass& one);

/// All effects of a library, in library order. A malformed annotation is a warning that names class and place.
Outcome<std::vector<EffectClass>> effectCatalogue(const Library& library);

}  // namespace analogon
