#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/fit/problem.hpp"
#include "core/fit/reduced_misfit.hpp"

namespace analogon {

/// JᵀJ, Jᵀr and rᵀr of one experiment, added up while its samples pass by: memory does not grow with the record.
class NormalEquations final : public SampleSink {
public:
    /// `columns`: column of the problem's Jacobian of each direction of the simulation.
    NormalEquations(const FitExperiment& experiment, std::vector<Eigen::Index> columns);

    void take(int sample, const double* y, const double* dy) override;
    void takeRows(int first, int count, const double* rows, const RowLayout& layout, int directions) override;
    void restart() override;

    bool isFinite() const;
    double squares() const { return squares_; }  // rᵀr
    /// Adds them to those of the whole problem.
    void addTo(Eigen::MatrixXd& hessian, Eigen::VectorXd& gradient) const;

private:
    void add(int output, int first, int count, const double* values, const double* slopes, int stride, int lanes);

    const FitExperiment& experiment_;
    std::vector<Eigen::Index> columns_;
    int lanes_{};
    std::vector<int> fitted_;  // outputs that count
    double squares_{};
    std::vector<double> hessian_, gradient_;   // lanes x lanes, lanes
    std::vector<double> residuals_, blanked_;  // of a block of samples; slopes with gaps where nothing was measured
    std::vector<double> slopes_;               // of one output at one sample, filled up to whole lanes
};

/// The triangle that stands for them (Cholesky: Golub & Van Loan, section 5.3.2). Nothing: they are too ill-conditioned
/// for that, and the samples themselves have to be looked at.
std::optional<ReducedMisfit> reduce(const Eigen::MatrixXd& hessian, const Eigen::VectorXd& gradient, double squares);

}  // namespace analogon
