#pragma once

#include <set>
#include <string>
#include <vector>

#include "core/syntax/ast.hpp"

namespace analogon {

/// First parts of all references in what is visited, without those that an iterator gives its meaning (a name may be
/// found twice where one text is part of two trees).
class FirstNames {
public:
    void visit(const syntax::Expression& e);
    void visit(const syntax::Modification& m);
    void visit(const syntax::Component& c);
    void visit(const syntax::Equation& e);

    std::vector<const syntax::Name*> found;

private:
    std::multiset<std::string> shadowed_;
};

}  // namespace analogon
