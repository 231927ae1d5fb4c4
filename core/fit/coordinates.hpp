#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/fit/problem.hpp"

namespace analogon {

/// Between parameters in their own units and the coordinates z in which a fit moves: q = log(value) or value,
/// z = (q - q_start) / scale. With scales from the curvature a unit of z changes the residuals by about one.
class Coordinates {
public:
    explicit Coordinates(const std::vector<FitParameter>& parameters);

    /// `columnNorms` of the Jacobian in own units at the origin; a zero falls back on the size of the parameter.
    void scaleBy(const Eigen::VectorXd& columnNorms);
    /// z = 0 becomes this point.
    void moveOrigin(const Eigen::VectorXd& values);

    int size() const { return static_cast<int>(origin_.size()); }
    bool isLogarithmic(int i) const { return isLogarithmic_[static_cast<std::size_t>(i)]; }
    Eigen::VectorXd values(const Eigen::VectorXd& z) const;
    /// dvalue/dz at a point in own units.
    Eigen::VectorXd slopes(const Eigen::VectorXd& values) const;
    double lower(int i) const { return bound(i, parameters_[static_cast<std::size_t>(i)].min); }  // -inf: none
    double upper(int i) const { return bound(i, parameters_[static_cast<std::size_t>(i)].max); }
    /// A place to start a search: fraction 0 … 1 of the range, or of a span around the start where it is open.
    double within(int i, double fraction) const;
    /// The same within a factor of the start (which keeps its sign) and within the bounds; a start at 0 stays there.
    double near(int i, double fraction, double factor) const;
    /// A sensible first move for a method that knows no slopes, in z.
    double firstMove(int i) const;

    static bool isOpen(double bound) { return !(bound > -1e299 && bound < 1e299); }

private:
    double bound(int i, double value) const;
    double toQ(int i, double value) const;

    std::vector<FitParameter> parameters_;
    std::vector<bool> isLogarithmic_;
    Eigen::VectorXd origin_;  // q at z = 0
    Eigen::VectorXd originValues_;
    Eigen::VectorXd scale_;
};

}  // namespace analogon
