#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace analogon {

/// What A x = b says where its rows repeat each other.
struct RankDeficientSolution {
    std::vector<double> values;     // the smallest of all solutions
    std::vector<char> isUndecided;  // by unknown: other solutions have another value of it
};

/// For a square A, row-major (elimination with full pivoting, Golub & Van Loan, section 3.4; the smallest solution is
/// any solution less its part in the kernel). Nothing where A has full rank, or where its rows contradict each other.
/// `shift` is added to each unknown that is left free: another of the solutions.
std::optional<RankDeficientSolution> solveRankDeficient(std::span<const double> matrix, std::span<const double> right,
                                                        double shift = 0);

/// While it lives, linear blocks that this thread evaluates for their values alone take the smallest solution where
/// their equations repeat each other (two brakes that hold one shaft). Elsewhere that is a failure: a fit would follow
/// numbers that the model leaves open.
class UndecidedScope {
public:
    UndecidedScope();
    ~UndecidedScope();
    UndecidedScope(const UndecidedScope&) = delete;
    UndecidedScope& operator=(const UndecidedScope&) = delete;

    /// The innermost of this thread; null: none.
    static UndecidedScope* inForce();

    std::set<std::string> names;  // unknowns that were left open
    double shift{};               // as in solveRankDeficient()

private:
    UndecidedScope* around_;
};

}  // namespace analogon
