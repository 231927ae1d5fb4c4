#pragma once

#include <memory>
#include <vector>

#include "core/simulate/dynamics.hpp"
#include "core/simulate/input_slots.hpp"
#include "core/simulate/state_jacobian.hpp"

namespace analogon {

/// A one-step method of the grid engine. With K > 0 it carries the tangents of the discrete solution along:
/// dx is the exact derivative of the x it yields.
class StepMethod {
public:
    virtual ~StepMethod() = default;
    /// From t to t + h within one interval of the inputs; x (n) and dx (n x K) are replaced. False: failed, and
    /// failure() of the dynamics or reason() says why.
    virtual bool step(int interval, double t, double h, double* x, double* dx) = 0;
    virtual const char* reason() const { return "not finite"; }
    /// The state at which it failed; -1: none more than another, or failure() names one.
    virtual int culprit() const { return -1; }
};

std::unique_ptr<StepMethod> makeStepMethod(GridMethod method, Dynamics& dynamics, InputSlots& slots,
                                           const SimulationOptions& options);

/// The classic explicit method of fourth order (Kutta 1901).
class RungeKutta4 final : public StepMethod {
public:
    RungeKutta4(Dynamics& dynamics, InputSlots& slots);
    bool step(int interval, double t, double h, double* x, double* dx) override;

private:
    bool evaluate(double t, const double* x, const double* dx, double* slope);

    Dynamics& dynamics_;
    InputSlots& slots_;
    int n_{}, total_{};  // total: n (1 + K), values first and tangents after
    std::vector<double> u_, du_;
    std::vector<double> stage_, slope_, sum_;
};

/// Singly diagonally implicit method with explicit first stage, order 3, stage order 2, stiffly accurate and
/// L-stable: four stages with c = (0, 2g, 3/5, 1) and g the middle root of 6g^3 - 18g^2 + 9g - 1 = 0. The
/// remaining coefficients follow from the row sums, stage order 2 and the order conditions (the family of
/// Kennedy & Carpenter, NASA/TM-2016-219173, section 5). Each stage is solved by Newton's method with the exact
/// Jacobian; tangents follow from the implicit function theorem at the converged stages. A step whose stages
/// do not converge is halved, down to 2^-maxDepth of it.
class Esdirk final : public StepMethod {
public:
    Esdirk(Dynamics& dynamics, InputSlots& slots, const SimulationOptions& options);
    bool step(int interval, double t, double h, double* x, double* dx) override;
    const char* reason() const override { return reason_; }
    int culprit() const override { return culprit_; }

    static constexpr int stages = 4;
    struct Tableau {
        double a[stages][stages]{};
        double c[stages]{};
    };
    static const Tableau& tableau();  // the last row of a are the weights

private:
    bool attempt(int interval, double t, double h, const double* x, const double* dx);
    void forgetScale();
    bool solveStage(double t, double hg);
    bool simplifiedNewton(double t, double hg);
    bool dampedNewton(double t, double hg);
    bool factorise(double hg);
    double defect(double hg, const double* stage, const double* slope, double* out) const;
    double scaledNorm(const double* v) const;
    int largestDefect() const;
    bool stageTangents(int stage, double t, double hg);

    static constexpr int maxDepth_ = 10;
    Dynamics& dynamics_;
    InputSlots& slots_;
    int n_{}, K_{};
    double tolerance_{};
    StateJacobian jacobian_;
    std::vector<double> u_, du_;
    std::vector<double> scale_;  // largest magnitude of each state so far, since the last gap of the recording
    int interval_{-1};           // of the last step
    std::vector<double> base_, stage_, slope_, delta_, trial_, trialSlope_, trialDelta_;
    std::vector<double> slopes_;                       // stages x n
    std::vector<double> tangentBase_, tangentSlopes_;  // n x K, stages x n x K
    std::vector<double> endTangents_, savedX_, savedDx_;
    const char* reason_{"not finite"};
    int culprit_{-1};
};

}  // namespace analogon
