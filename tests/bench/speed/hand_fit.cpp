#include "tests/bench/speed/hand_fit.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace analogon::speed {

HandFit handFit(const SpeedProblem& problem, const Pass& pass) {
    const auto K = static_cast<Eigen::Index>(problem.parameters.size());
    Eigen::VectorXd p(K), lower(K), upper(K), largest = Eigen::VectorXd::Zero(K);
    for (Eigen::Index i = 0; i < K; ++i) {
        const FitParameter& q = problem.parameters[static_cast<std::size_t>(i)];
        p[i] = q.start, lower[i] = q.min, upper[i] = q.max;
    }
    NormalEquations here = pass(p);
    HandFit fit{p, here.cost, 1};
    double damping = 1e-3, growth = 2;
    for (int iteration = 0; iteration < 200; ++iteration) {
        const Eigen::VectorXd gradient = Eigen::Map<const Eigen::VectorXd>(here.gradient.data(), K).cwiseProduct(p);
        const Eigen::MatrixXd hessian =
            p.asDiagonal() * Eigen::Map<const Eigen::MatrixXd>(here.hessian.data(), K, K) * p.asDiagonal();
        largest = largest.cwiseMax(hessian.diagonal());
        Eigen::MatrixXd damped = hessian;
        damped.diagonal() += damping * largest;
        const Eigen::VectorXd step = -damped.ldlt().solve(gradient);
        const Eigen::VectorXd next =
            (p.array() * step.array().max(-1.5).min(1.5).exp()).matrix().cwiseMax(lower).cwiseMin(upper);
        const Eigen::VectorXd taken = (next.array() / p.array()).log();
        const double predicted = -taken.dot(gradient) - 0.5 * taken.dot(hessian * taken);
        NormalEquations there = pass(next);
        ++fit.passes;
        const double fall = here.cost - there.cost;
        if (std::isfinite(there.cost) && fall > 0) {
            const double quality = 2 * fall / predicted - 1;
            damping *= std::max(1.0 / 9, 1 - quality * quality * quality);
            growth = 2;
            p = next;
            here = std::move(there);
            if (fall < 1e-9 * here.cost) break;
        } else {
            if (std::abs(predicted) < 1e-9 * here.cost) break;
            damping *= growth;
            growth *= 2;
        }
    }
    fit.values = p;
    fit.cost = here.cost;
    return fit;
}

}  // namespace analogon::speed
