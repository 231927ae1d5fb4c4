#pragma once

#include <array>
#include <memory>
#include <vector>

#include "core/eval/sparse_factors.hpp"
#include "core/simulate/dense_factors.hpp"
#include "core/simulate/dynamics.hpp"

namespace analogon {

/// The pattern of I - c df/dx: that of df/dx with the diagonal, compressed by columns.
struct StepPattern {
    explicit StepPattern(const StatePattern& pattern);
    std::vector<int> starts, rows;
    std::vector<int> places;     // of each entry of the pattern of df/dx
    std::vector<int> diagonals;  // by column
};

/// df/dx at a point and the factors of I - c df/dx that implicit steps solve with: full matrices where the model is
/// small or full, else by the pattern of the model (Dynamics::pattern), so that a chain costs as much as it is long.
/// With a pattern the factors of the last few c are kept side by side: steps of several lengths take turns. Those of a
/// linear model are found once for each c, as is df/dx.
class StateJacobian {
public:
    explicit StateJacobian(Dynamics& dynamics);

    bool isSparse() const { return pattern_ != nullptr; }
    /// Whether factors of any point serve at every other.
    bool isConstant() const { return isConstant_; }
    /// The rates into xdot, and df/dx.
    bool evaluate(double t, const double* x, const double* u, double* xdot);
    /// The same with the tangents of the rates along K directions with the states held.
    bool linearise(double t, const double* x, const double* u, const double* du, double* xdot);
    /// Those of one rate, K of them; after linearise().
    const double* held(int state) const {
        return pattern_ ? held_.data() + static_cast<std::ptrdiff_t>(state) * K_
                        : entries_.data() + static_cast<std::ptrdiff_t>(state) * stride_ + n_;
    }

    /// Factors of I - c df/dx. False: singular.
    bool factorise(double c);
    /// Whether there are factors for this c (but for rounding), of this point or an earlier one; they are in force
    /// then.
    bool hasFactors(double c);
    /// With the factors in force, in place: `width` right-hand sides, row-major n x width.
    void solve(double* b, int width) const;

    /// Largest magnitude of the eigenvalues of df/dx, as spectralRadius() has it. Full matrices are overwritten. Large
    /// ones are not squared: their powers act on one vector, whose length in the mean is the Frobenius norm of the
    /// power (Hutchinson, Commun. Stat. Simul. 19 (1990) 433-450).
    double radius(double enough);

private:
    struct Factors {
        double c{};
        std::unique_ptr<SparseFactors> factors;  // null: none yet
    };

    bool factoriseSparse(double c);
    bool isKnown() const { return isConstant_ && isEvaluated_; }
    double radiusByVector(double enough);
    double leastNorm();
    void multiply(const std::vector<double>& x, std::vector<double>& to) const;

    Dynamics& dynamics_;
    int n_{}, K_{}, stride_{};
    const StatePattern* pattern_{};
    bool isConstant_{}, isEvaluated_{};
    std::vector<double> entries_;          // by the pattern; else row-major with `stride_` numbers a row
    std::vector<double> held_;             // n x K, with a pattern
    std::vector<double> scratch_, still_;  // still_: states that do not move, n x K

    bool hasDense_{};
    double denseFor_{};
    DenseFactors dense_;
    std::unique_ptr<StepPattern> step_;  // with a pattern
    std::vector<double> matrix_;         // I - c df/dx by it
    std::array<Factors, 4> kept_;
    std::size_t inForce_{}, next_{};

    std::vector<double> vector_, image_, judged_;  // judged_: the entries that the radius below is of
    double radius_{-1};
    bool isBound_{};  // it is a bound that was enough, and may be lower
};

}  // namespace analogon
