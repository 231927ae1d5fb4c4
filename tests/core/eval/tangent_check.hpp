#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/eval/system.hpp"
#include "tests/core/eval/machine_code_check.hpp"

namespace analogon::test {

inline std::vector<double> modelParameters(const System& system) {
    std::vector<double> p;
    for (const SignalInfo& info : system.parameters()) p.push_back(info.value);
    return p;
}

/// All of (x0, xdot, y) as functions of (p, x, u) along one direction each; tangents against central differences.
inline void checkTangents(const System& system, const std::vector<double>& x, const std::vector<double>& u,
                          double t = 0.3) {
    const auto nx = static_cast<std::size_t>(system.stateCount()), ny = static_cast<std::size_t>(system.outputCount());
    const auto np = static_cast<std::size_t>(system.parameterCount()), nu = u.size();
    const std::size_t directions = np + nx + nu;
    const std::vector<double> p = modelParameters(system);
    ASSERT_EQ(x.size(), nx);
    ASSERT_EQ(static_cast<int>(nu), system.slotCount());

    Workspace w = system.workspace(static_cast<int>(directions));
    std::vector<double> dp(np * directions), dx(nx * directions), du(nu * directions);
    for (std::size_t i = 0; i < np; ++i) dp[i * directions + i] = 1;
    for (std::size_t i = 0; i < nx; ++i) dx[i * directions + np + i] = 1;
    for (std::size_t i = 0; i < nu; ++i) du[i * directions + np + nx + i] = 1;
    std::vector<double> x0(nx), dx0(nx * directions), xdot(nx), dxdot(nx * directions), y(ny), dy(ny * directions);
    ASSERT_TRUE(system.setParameters(w, p, dp)) << system.failure(w);
    ASSERT_TRUE(system.initialise(w, t, u, x0, dx0, du)) << system.failure(w);
    ASSERT_TRUE(system.derivatives(w, t, x, dx, u, du, xdot, dxdot)) << system.failure(w);
    ASSERT_TRUE(system.outputs(w, t, x, dx, u, du, y, dy)) << system.failure(w);

    // Tangents and values agree with the values-only program, bit by bit.
    Workspace plain = system.workspace(0);
    std::vector<double> again(nx);
    ASSERT_TRUE(system.setParameters(plain, p));
    ASSERT_TRUE(system.derivatives(plain, t, x, u, again));
    EXPECT_EQ(again, xdot);

    const auto all = [&](std::size_t k, double step) {
        std::vector<double> ps = p, xs = x, us = u, results;
        (k < np ? ps[k] : k < np + nx ? xs[k - np] : us[k - np - nx]) += step;
        std::vector<double> a(nx), b(nx), c(ny);
        EXPECT_TRUE(system.setParameters(plain, ps)) << system.failure(plain);
        EXPECT_TRUE(system.initialise(plain, t, us, a)) << system.failure(plain);
        EXPECT_TRUE(system.derivatives(plain, t, xs, us, b)) << system.failure(plain);
        EXPECT_TRUE(system.outputs(plain, t, xs, us, c)) << system.failure(plain);
        results.insert(results.end(), a.begin(), a.end());
        results.insert(results.end(), b.begin(), b.end());
        results.insert(results.end(), c.begin(), c.end());
        return results;
    };
    for (std::size_t k = 0; k < directions; ++k) {
        const double at = k < np ? p[k] : k < np + nx ? x[k - np] : u[k - np - nx];
        const double step = 1e-5 * std::max(std::fabs(at), 1e-3);
        const std::vector<double> up = all(k, step), down = all(k, -step);
        for (std::size_t i = 0; i < up.size(); ++i) {
            const double tangent = i < nx       ? dx0[i * directions + k]
                                   : i < 2 * nx ? dxdot[(i - nx) * directions + k]
                                                : dy[(i - 2 * nx) * directions + k];
            const double difference = (up[i] - down[i]) / (2 * step);
            const double rounding = 1e-15 * (std::fabs(up[i]) + std::fabs(down[i])) / step;
            EXPECT_NEAR(tangent, difference, 1e-6 * std::max(std::fabs(difference), 1e-6) + 4 * rounding)
                << "result " << i << " direction " << k;
        }
    }
    checkMachineCode(system, x, u, t);
}

}  // namespace analogon::test
