#pragma once

#include <string>

#include "core/diagram/diagram.hpp"

namespace analogon::ui {

bool isSignal(Domain domain);

/// A signal comes out of here: an output of a component, or an input of the whole model.
bool isSource(const Diagram& diagram, const std::string& connector);

/// Class of a connector "motor.flange", or of a top-level one; empty: unknown.
std::string connectorClass(const Diagram& diagram, const std::string& connector);

}  // namespace analogon::ui
