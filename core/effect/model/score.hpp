#pragma once

#include <Eigen/Core>
#include <memory>
#include <random>
#include <utility>
#include <vector>

#include "core/effect/thresholds.hpp"
#include "core/fit/problem.hpp"
#include "core/residual/noise.hpp"

/// The linear algebra of the search: what of an effect's trace the parameters cannot imitate, and how much of the
/// residual it explains. Score tests as in Rao 1948; projection on the complement of the parameters' Jacobian.
namespace analogon {

using threshold::screen::leastVisible;

/// The rows of a residual vector that belong to one output of one experiment, in time order.
struct ResidualChannel {
    int experiment{};
    int output{};
    int begin{}, end{};          // rows [begin, end)
    std::vector<int> samples;    // sample index of each row
    Eigen::VectorXd measured{};  // of each row, in the units of the rows
};
std::vector<ResidualChannel> residualChannels(const FitProblem& problem);

/// A channel's part of a residual without what a converter of that step (in the units of the rows) rounds off: that
/// follows from where the model lies between two steps, a periodic function of it (Widrow 1956).
Eigen::VectorXd besideRounding(const ResidualChannel& channel, const Eigen::VectorXd& residual, double step);

/// Makes the noise of every channel white: one autoregressive model per channel, and the rows in units of the
/// innovation. Default: leaves rows as they are.
class Whitener {
public:
    Whitener() = default;
    /// Estimates the models from a residual.
    Whitener(const std::vector<ResidualChannel>& channels, const Eigen::VectorXd& residual);

    Eigen::VectorXd operator()(const Eigen::VectorXd& rows) const;
    Eigen::MatrixXd operator()(const Eigen::MatrixXd& rows) const;
    /// The same of the rows of one channel, its place among those it was estimated from. Default: as they are.
    Eigen::MatrixXd through(std::size_t channel, const Eigen::MatrixXd& rows) const;
    /// Noise of every channel's colour and size, as rows that are not white.
    Eigen::VectorXd noise(std::mt19937_64& random) const;

private:
    std::vector<ResidualChannel> channels_;
    std::vector<AutoregressiveModel> models_;
};

/// Projection on the complement of the columns of a Jacobian (rank found by pivoting).
class OrthogonalProjector {
public:
    explicit OrthogonalProjector(const Eigen::MatrixXd& jacobian);
    Eigen::MatrixXd operator()(const Eigen::MatrixXd& columns) const;
    int rank() const { return static_cast<int>(basis_.cols()); }
    const Eigen::MatrixXd& basis() const { return basis_; }  // orthonormal, of the columns
    /// Least-squares coefficients of the Jacobian's columns for a column (how the parameters imitate it).
    Eigen::VectorXd coefficients(const Eigen::VectorXd& column) const;

private:
    Eigen::MatrixXd basis_;  // orthonormal
    Eigen::MatrixXd jacobian_;
};

/// Columns of length 1 that copies share, in single precision: those of all candidates of a round take more room than
/// all else, and are only held against each other.
class SharedColumns {
public:
    SharedColumns() = default;
    SharedColumns(const Eigen::MatrixXd& columns)
        : columns_(std::make_shared<const Eigen::MatrixXf>(columns.cast<float>())) {}
    /// Without rows and columns where there are none.
    const Eigen::MatrixXf& operator*() const;
    const Eigen::MatrixXf* operator->() const { return &**this; }
    void reset() { columns_.reset(); }

private:
    std::shared_ptr<const Eigen::MatrixXf> columns_;
};

/// What one or more columns (the first: the strength) explain of a residual.
struct ColumnScore {
    double visible{};           // |g_perp| / |g| of the strength: under leastVisible the parameters imitate it
    double explained{};         // decrease of chi-square when the columns are fitted
    bool wrongSign{};           // the best strength is negative though the effect is one-sided
    Eigen::VectorXd strengths;  // best coefficients
    SharedColumns directions;   // orthonormal basis of the projected columns (correlation with other candidates)
    Eigen::VectorXd along;      // the residual in that basis
};
ColumnScore scoreColumns(const OrthogonalProjector& complement, const Eigen::VectorXd& residual,
                         const Eigen::MatrixXd& columns, bool oneSided);

/// What columns explain of a residual together, whichever of them move at all.
struct Explained {
    double explained{};          // fall in the sum of squares
    Eigen::MatrixXd directions;  // orthonormal basis of the columns
};
Explained explainedBy(const Eigen::VectorXd& residual, const Eigen::MatrixXd& columns);

/// Directions at no more rows than `most`, one drawn from each piece of the rows (jittered sampling: what alternates
/// faster than the pieces does not pass for something slow), of length 1 again.
SharedColumns atSomeRows(const SharedColumns& directions, Eigen::Index most);

/// What two effects explain of one residual together, their projected columns (`directions`) fitted at once: far more
/// than the sum of what each does alone where they hide each other.
double explainedTogether(const ColumnScore& a, const ColumnScore& b);

/// Quantile of the largest `explained - columns * ln(rows)` over all candidates when the residual is noise alone,
/// from draws with the candidates' own correlation: accounts for how many were tried and how alike they are.
double noiseThreshold(const std::vector<SharedColumns>& directions, double logRows, double quantile,
                      std::uint64_t seed);

/// N / (1 + 2 sum rho_k) over the channels of a residual.
double effectiveCount(const std::vector<ResidualChannel>& channels, const Eigen::VectorXd& residual);

}  // namespace analogon
