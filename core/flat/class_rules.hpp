#pragma once

#include <set>
#include <string>
#include <unordered_set>
#include <utility>

#include "core/flat/flattening.hpp"

namespace analogon {

/// What a class must not hold, whatever it is used for: the restrictions of specialised classes (Modelica 3.6, section
/// 4.6), of names (4.8), of inheritance (7.1.3), of statements (11.2), functions (12.2) and imports (13.2). Each class
/// that a model uses is checked once; faults go to the messages.
class ClassRules {
public:
    explicit ClassRules(Flattening& work) : work_(work) {}

    void check(const LibraryClass& definition);
    /// Whether the parts of a dotted name may be reached from outside (sections 4.1 and 5.3.2): nothing protected, and
    /// in a class that is no package nothing but what is encapsulated. False: reported.
    bool mayReach(const syntax::Name& name, const LibraryClass* from);

private:
    using Definition = syntax::ClassDefinition;

    void names(const LibraryClass& definition);
    void literals(const LibraryClass& definition);
    void content(const LibraryClass& definition);
    void bases(const LibraryClass& definition);
    void imports(const LibraryClass& definition);
    void function(const LibraryClass& definition);
    void statements(const std::vector<syntax::Equation>& statements, const Definition& of, bool isInLoop,
                    bool isInWhen);
    void targets(const std::vector<syntax::Equation>& statements, const std::unordered_set<std::string_view>& inputs);
    void refuse(const Text& message, const Span& span, const Text& hint = {});

    Flattening& work_;
    std::unordered_set<const LibraryClass*> checked_;
    std::set<std::pair<const LibraryClass*, std::string>> reached_;  // judged, from where
};

/// Whether a class holds nothing but classes and constants, so that its names may be used from outside like those of a
/// package (section 5.3.2).
bool isLikePackage(const syntax::ClassDefinition& definition);

/// Whether a class of this name is declared in a protected section of the other.
bool isProtectedClass(const LibraryClass& of);

}  // namespace analogon
