#pragma once

#include <cstdint>
#include <set>
#include <string>

#include "core/flat/flat_model.hpp"

namespace analogon {

/// Lets a parameter take another value in mid run: p stands for p + p.step * s(t) in every equation, where s rises from
/// 0 to 1 around the time p.moment within `width` [s]. "p.step" and "p.moment" are new parameters of the model (0 and
/// 0: nothing changes). Parameters bound to p follow it. Fault: no such Real parameter.
Outcome<FlatModel> withChange(FlatModel model, const std::string& parameter, double width);

/// Lets a parameter move with a signal: p stands for p + p.slope * u in every equation, where u is a new top-level
/// input. "p.slope" is a new parameter (0: it does not move). Fault: no such Real parameter, or a variable of the
/// input's name.
Outcome<FlatModel> withDependence(FlatModel model, const std::string& parameter, const std::string& input);

/// Takes a variable from a signal: the equation with the variable alone on its left side sets it to `input`, a new
/// top-level input, instead. Fault: no such equation, or a variable of the input's name.
Outcome<FlatModel> withImposed(FlatModel model, const std::string& variable, const std::string& input);

/// Whether what an initial equation decides begins where its start value says instead.
enum class StartTold { WhereSet, Always };

/// Lets a variable begin where a new parameter says, "rotor.w.start" for "rotor.w" (its own start value until it is
/// set), as start and fixed of Modelica do. An initial equation that decides it gives way where a further parameter
/// (`toldOf`) is 1; by default it is 0, or 1 with `Always`. Fault: there is no such variable, or it is an input.
Outcome<FlatModel> withStart(FlatModel model, const std::string& start, StartTold told = StartTold::WhereSet);

/// The same for all of these names that stand for such a start value.
Outcome<FlatModel> withStarts(FlatModel model, const std::vector<std::string>& names,
                              StartTold told = StartTold::WhereSet);

/// The variable whose start value that name stands for, "rotor.w.start" for "rotor.w"; invalid: it stands for none.
VariableId startedBy(const FlatModel& model, const std::string& start);

/// The variables whose start initial equations decide, by their numbers.
std::set<std::uint32_t> decidedAtStart(const FlatModel& model);

std::string startOf(const std::string& variable);
std::string toldOf(const std::string& start);
std::string slopeOf(const std::string& parameter);
std::string stepOf(const std::string& parameter);
std::string momentOf(const std::string& parameter);

}  // namespace analogon
