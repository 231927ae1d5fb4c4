#pragma once

#include <string>

#include "core/study/study.hpp"

namespace analogon {

/// The composed model as one Modelica text that stands alone: every class of the libraries that it uses, in packages
/// of the same names, then the study's own classes and the model. Values that the study holds beside the text
/// (start values of study.json) are written into the model. Class texts are taken word for word.
/// Faults: the study's library cannot be read, or its class is not in it.
Outcome<std::string> modelicaText(const Study& study);

}  // namespace analogon
