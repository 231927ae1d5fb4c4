#pragma once

#include <string>
#include <string_view>

namespace analogon {

/// A class of the Modelica Standard Library that has another name since its version 3 or 4.
struct MovedClass {
    std::string_view before, now;  // a package stands for all it holds
};

/// The entry whose old name is this one or holds it; null: the name is not an old one.
const MovedClass* movedClass(std::string_view qualifiedName);

/// The name that the class has now; empty: the name is not an old one.
std::string newName(std::string_view qualifiedName);

}  // namespace analogon
