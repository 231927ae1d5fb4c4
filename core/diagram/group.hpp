#pragma once

#include "core/diagram/diagram.hpp"
#include "core/syntax/text_edit.hpp"

namespace analogon {

/// Components that become one: what their new class is called, and the component of it that takes their place.
struct Group {
    std::vector<std::string> components;
    std::string className, instance;
};

/// Puts components of a model, as they are declared, into a new class behind it. Each connector that is connected with
/// what stays outside gets a connector of its own at the border; references from outside follow. The equations say the
/// same as before. Fault: something that cannot move, such as a component whose values refer to what stays outside.
Outcome<syntax::TextEdit> groupComponents(const Library& library, const Diagram& diagram,
                                          const syntax::ClassDefinition& definition, const Group& group,
                                          std::string what);

}  // namespace analogon
