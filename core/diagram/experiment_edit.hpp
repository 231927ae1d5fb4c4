#pragma once

#include "core/base/outcome.hpp"
#include "core/syntax/ast.hpp"
#include "core/syntax/text_edit.hpp"

namespace analogon {

/// Sets StopTime [s] of the annotation `experiment` of a class, which says how long it is simulated by itself; all else
/// of its annotations stays. Fault: the class is written without a body (`model A = B`).
Outcome<syntax::TextEdit> stopTimeEdit(const syntax::ClassDefinition& definition, double stop, std::string what);

}  // namespace analogon
