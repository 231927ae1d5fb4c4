#pragma once

#include "core/study/study.hpp"
#include "core/syntax/ast.hpp"

namespace analogon::ui {

/// Whether anybody has said what a parameter is: a value in the study, one at a block, or a declaration of the model's
/// own. Else all values are those of the library, which know nothing of the test bench.
bool isAnyValueTold(const Study& study, const syntax::ClassDefinition& model);

}  // namespace analogon::ui
