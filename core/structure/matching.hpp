#pragma once

#include <vector>

/// Bipartite matching and strong components of plain index graphs.
namespace analogon {

/// For each row the columns it may be matched with.
using Adjacency = std::vector<std::vector<int>>;

/// A matching of rows (equations) with columns (unknowns), extended row by row along augmenting paths
/// (Kuhn's algorithm with a look-ahead, so that a chain of n costs O(n)).
class Matching {
public:
    Matching(const Adjacency& adjacency, int columns);

    /// Tries to match one more row. `isUsable` hides columns (empty: all are usable). On failure
    /// `visitedRows()` and `visitedColumns()` are the rows and columns of the alternating tree: rows that
    /// compete for too few columns.
    bool augment(int row, const std::vector<char>& isUsable = {});
    /// Matches as many rows as possible, cheap ones first. True when all rows are matched.
    bool augmentAll(const std::vector<char>& isUsable = {});

    int columnOf(int row) const { return columnOf_[static_cast<std::size_t>(row)]; }
    int rowOf(int column) const { return rowOf_[static_cast<std::size_t>(column)]; }
    void assign(int row, int column);
    /// Follows the adjacency (rows at its end added or taken away) and the number of columns.
    void resize(int columns);
    const std::vector<int>& visitedRows() const { return visitedRows_; }
    const std::vector<int>& visitedColumns() const { return visitedColumns_; }

private:
    bool search(int root, const std::vector<char>& isUsable);

    const Adjacency& adjacency_;
    std::vector<int> columnOf_, rowOf_;
    std::vector<int> lookAhead_;  // by row: first column that may be free (a matched column never becomes free)
    std::vector<int> rowVisit_, columnVisit_;
    std::vector<int> visitedRows_, visitedColumns_;
    int visit_{};
};

/// Strong components of the graph node -> successors, each after all it depends on (Tarjan 1972).
std::vector<std::vector<int>> strongComponents(const Adjacency& successors);

}  // namespace analogon
