#pragma once

#include <string>
#include <vector>

#include "core/effect/catalogue/finding.hpp"
#include "core/effect/course/change.hpp"
#include "core/effect/course/dependence.hpp"
#include "core/effect/course/held_parameter.hpp"

/// Parameters of another value, or that are not constant, told as what is proposed.
namespace analogon {

Remainder remainderOf(const Change& c, double end);

/// Of all recordings that were not fitted, each in the condition that suits it best [%]; -1: there are none.
double leastOf(const std::vector<CheckOfChange>& checks);

/// In which condition a recording that was not fitted seems to have been taken.
Text remarkOf(const CheckOfChange& c, const std::string& parameter);

Text remarkOf(const HeldInstead& h, const std::string& effect, const std::string& at);

Text remarkOf(const HeldInstead& h);

/// What explains as much as the value that is told first.
Text remarkOfEqual(const HeldInstead& h);

Remainder remainderOf(const HeldInstead& h);

Remainder remainderOf(const ChannelDependence& d);

}  // namespace analogon
