#pragma once

#include <string>
#include <vector>

#include "core/flat/table_sum.hpp"
#include "core/syntax/ast.hpp"

namespace analogon {

struct Flattening;
struct Scope;

/// A table of the functions that CombiTable1D, CombiTable2D and CombiTimeTable call.
struct ExternalTable {
    enum class Kind { OneDimension, TwoDimensions, Time };
    Kind kind{Kind::OneDimension};
    std::vector<TableSum> columns;  // one dimension, time: by output
    // Two dimensions: the value is sum_j across[j](u2) * along[j](u1).
    std::vector<TableSum> along;
    std::vector<LookupTable> across;
    std::vector<TableSum> alongBeyond;  // the same outside of the grid; empty: as inside
    std::vector<LookupTable> acrossBeyond;
    LookupTable next;  // time: from a time to the next event, or, with a period, to how long it takes till there
    double start{}, rounding{};
    bool isPeriodic{};
    double first{}, last{}, first2{}, last2{};  // abscissas
};

/// Runs an external function that the program knows: the tables, some functions of strings, and "builtin" ones. Its
/// arguments and its result are variables of the frame in force (Translator); false when it is not known (reported).
bool callExternal(Flattening& work, const syntax::ClassDefinition& function, const syntax::Expression& call,
                  const Scope& scope);

}  // namespace analogon
