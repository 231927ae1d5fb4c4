#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace analogon {

struct SystemPrograms;

/// Where df/dx of a system may differ from 0, compressed by columns, with groups of columns that have no row in common:
/// one direction yields all columns of a group (Curtis, Powell & Reid, IMA J. Appl. Math. 13 (1974) 117-119).
struct StatePattern {
    std::vector<int> starts;   // of each column in `rows`, and the end: states + 1
    std::vector<int> rows;     // ascending within a column
    std::vector<int> groupOf;  // by column
    int groups{};

    int states() const { return static_cast<int>(groupOf.size()); }
    std::size_t entries() const { return rows.size(); }
};

/// From which states the program of the rates carries tangents to which rates. Nothing: few states, or so many entries
/// that a full matrix is no dearer.
std::optional<StatePattern> statePatternOf(const SystemPrograms& programs);

/// The same from the states that each rate depends on (ascending).
std::optional<StatePattern> statePatternOf(const std::vector<std::vector<int>>& dependences);

}  // namespace analogon
