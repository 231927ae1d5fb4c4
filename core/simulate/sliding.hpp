#pragma once

#include <Eigen/LU>
#include <functional>
#include <vector>

#include "core/simulate/dynamics.hpp"

namespace analogon {

/// Motion along the surfaces on which relations of the model switch, where the field on either side leads back to
/// the surface: a brake that holds, a thermostat that would chatter. There the field is the mean of both sides that
/// stays on the surface (Filippov, Differential Equations with Discontinuous Righthand Sides, 1988): exact rest, and
/// no event after event. With several surfaces r_j = 0 at a time the field is taken as
/// f = f0 + sum of share_j * change_j, where f0 is the field on the side r_j > 0 of all and change_j what crossing
/// surface j alone changes: exact for switched terms that add up, such as frictions.
class Sliding {
public:
    /// `setSlots` brings the slots `u` of the system to a time.
    Sliding(Dynamics& dynamics, std::function<void(double)> setSlots, const std::vector<double>& u);

    bool isActive() const { return !surfaces_.empty(); }
    bool holds(int root) const;
    const std::vector<int>& surfaces() const { return surfaces_; }  // roots

    /// Joins those of the candidate roots whose surface attracts from both sides, and moves the state onto it. True
    /// when one was joined.
    bool join(double t, double* x, const std::vector<int>& candidates);
    /// Leaves the surfaces whose mean has come to one side; the state goes there.
    void leave(double t, double* x);
    /// Leaves all surfaces.
    void release();

    bool derivatives(double t, const double* x, double* xdot);
    /// Row-major n x n.
    bool jacobian(double t, const double* x, double* jacobian);
    /// With tangents of K directions, n x K.
    bool derivatives(double t, const double* x, const double* dx, const double* du, double* xdot, double* dxdot);
    /// Replaces, for each surface, its entry of the root functions by one that is positive while the motion stays.
    bool exits(double t, const double* x, double* values);

private:
    struct Field {
        Eigen::VectorXd mean, shares;
        Eigen::MatrixXd gradient;                       // surfaces x states
        Eigen::MatrixXd change;                         // states x surfaces
        Eigen::MatrixXd back;                           // states x surfaces: the way onto the surface by one unit of r
        Eigen::VectorXd onto;                           // the state, moved onto the surfaces
        Eigen::VectorXd along;                          // rate of each r on its own: by time
        Eigen::PartialPivLU<Eigen::MatrixXd> crossing;  // of gradient * change
    };

    bool roots(double t, const Eigen::VectorXd& x, Eigen::VectorXd& values);
    bool gradientOf(double t, const Eigen::VectorXd& x, Eigen::MatrixXd& gradient);
    bool field(double t, const double* x, Field& out);
    bool setDistances(double t, const Field& field);
    Eigen::VectorXd beside(const Field& field, int other) const;

    Dynamics& dynamics_;
    std::function<void(double)> setSlots_;
    const std::vector<double>& u_;
    int n_{}, roots_{};
    std::vector<int> surfaces_;     // roots
    std::vector<double> distance_;  // by surface: |r| at which the relations are clearly decided
};

}  // namespace analogon
