#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/eval/system.hpp"

namespace analogon::test {

/// Equal but for rounding. Sums of tangents may cancel: the largest of the list sets the scale there.
inline void expectClose(const std::vector<double>& a, const std::vector<double>& b, const std::string& what) {
    ASSERT_EQ(a.size(), b.size());
    double largest = 0;
    for (const double value : b) largest = std::max(largest, std::fabs(value));
    for (std::size_t i = 0; i < a.size(); ++i)
        EXPECT_NEAR(a[i], b[i], 1e-11 * std::fabs(b[i]) + 1e-12 * largest) << what << " " << i;
}

/// Machine code against the interpreter at one point, for several numbers of directions; and a Runge-Kutta step.
class MachineCodeCheck {
public:
    MachineCodeCheck(const System& system, std::vector<double> x, std::vector<double> u, double t, int directions)
        : s_(system),
          n_(x.size()),
          K_(static_cast<std::size_t>(directions)),
          t_(t),
          x_(std::move(x)),
          u_(std::move(u)),
          interpreted_(system.workspace(directions, true)),
          code_(system.workspace(directions)) {
        for (const SignalInfo& info : system.parameters()) p_.push_back(info.value);
        // Directions that mix parameters and states.
        for (std::size_t i = 0; i < p_.size() * K_; ++i) dp_.push_back(p_[i / K_] * std::sin(1.0 + 7.0 * i) + 0.01);
        for (std::size_t i = 0; i < n_ * K_; ++i) dx_.push_back(std::cos(2.0 + 3.0 * i));
    }

    void run() {
        ASSERT_TRUE(s_.setParameters(interpreted_, p_, dp_));
        ASSERT_TRUE(s_.setParameters(code_, p_, dp_));
        if (!s_.prepareSteps(code_)) GTEST_SKIP() << "no machine code on this processor";
        ASSERT_FALSE(s_.prepareSteps(interpreted_));
        const Rates byCode = rates(code_, x_, dx_, u_), reference = rates(interpreted_, x_, dx_, u_);
        ASSERT_EQ(byCode.ok, reference.ok);
        if (!reference.ok) return;
        expectClose(byCode.xdot, reference.xdot, "derivative");
        expectClose(byCode.dxdot, reference.dxdot, "tangent of a derivative");
        outputs();
        step();
        inputsThatVary();
    }

private:
    struct Rates {
        bool ok{};
        std::vector<double> xdot, dxdot;
    };
    Rates rates(Workspace& w, const std::vector<double>& x, const std::vector<double>& dx,
                const std::vector<double>& u) {
        Rates r{false, std::vector<double>(n_), std::vector<double>(n_ * K_)};
        r.ok = K_ > 0 ? s_.derivatives(w, t_, x, dx, u, {}, r.xdot, r.dxdot) : s_.derivatives(w, t_, x, u, r.xdot);
        return r;
    }

    /// Slots that depend on the parameters (a delay is fitted): code of its own, made once it pays.
    void inputsThatVary() {
        if (K_ == 0 || u_.empty()) return;
        std::vector<double> du;
        for (std::size_t i = 0; i < u_.size() * K_; ++i) du.push_back(std::sin(0.4 + 1.7 * static_cast<double>(i)));
        const auto m = static_cast<std::size_t>(s_.outputCount());
        const auto evaluate = [&](Workspace& w, Rates& r, std::vector<double>& y, std::vector<double>& dy) {
            return s_.derivatives(w, t_, x_, dx_, u_, du, r.xdot, r.dxdot) && s_.outputs(w, t_, x_, dx_, u_, du, y, dy);
        };
        Rates byCode{false, std::vector<double>(n_), std::vector<double>(n_ * K_)}, reference = byCode;
        std::vector<double> y(m), dy(m * K_), yCode(m), dyCode(m * K_);
        ASSERT_TRUE(evaluate(interpreted_, reference, y, dy));
        for (int i = 0; i < 200; ++i) ASSERT_TRUE(evaluate(code_, byCode, yCode, dyCode));
        expectClose(byCode.dxdot, reference.dxdot, "tangent of a derivative, inputs varying");
        expectClose(yCode, y, "output, inputs varying");
        expectClose(dyCode, dy, "tangent of an output, inputs varying");
    }

    void outputs() {
        const auto m = static_cast<std::size_t>(s_.outputCount());
        std::vector<double> y(m), dy(m * K_), yCode(m), dyCode(m * K_);
        const auto evaluate = [&](Workspace& w, std::vector<double>& to, std::vector<double>& dto) {
            return K_ > 0 ? s_.outputs(w, t_, x_, dx_, u_, {}, to, dto) : s_.outputs(w, t_, x_, u_, to);
        };
        ASSERT_EQ(evaluate(interpreted_, y, dy), evaluate(code_, yCode, dyCode));
        expectClose(yCode, y, "output");
        expectClose(dyCode, dy, "tangent of an output");
    }

    void step() {
        constexpr double h = 1e-5;
        std::vector<double> uEnd = u_, uMiddle = u_;
        for (std::size_t i = 0; i < u_.size(); ++i) {
            uEnd[i] *= 1.01;
            uMiddle[i] = 0.5 * (u_[i] + uEnd[i]);
        }
        std::vector<double> x = x_, dx = dx_, sum(n_), dsum(n_ * K_);
        const std::vector<double>* const inputs[] = {&u_, &uMiddle, &uMiddle, &uEnd};
        const double reach[] = {0, 0.5 * h, 0.5 * h, h}, weights[] = {h / 6, h / 3, h / 3, h / 6};
        const double t = t_;
        Rates k;
        for (int stage = 0; stage < 4; ++stage) {
            std::vector<double> xs = x_, dxs = dx_;
            for (std::size_t i = 0; i < n_ && stage > 0; ++i) xs[i] += reach[stage] * k.xdot[i];
            for (std::size_t i = 0; i < n_ * K_ && stage > 0; ++i) dxs[i] += reach[stage] * k.dxdot[i];
            t_ = t + reach[stage];
            k = rates(interpreted_, xs, dxs, *inputs[stage]);
            if (!k.ok) return;
            for (std::size_t i = 0; i < n_; ++i) x[i] += weights[stage] * k.xdot[i];
            for (std::size_t i = 0; i < n_ * K_; ++i) dx[i] += weights[stage] * k.dxdot[i];
        }
        t_ = t;
        s_.loadState(code_, x_, dx_);
        ASSERT_TRUE(s_.step(code_, t, h, u_.data(), uMiddle.data(), uEnd.data()));
        std::vector<double> xCode(n_), dxCode(n_ * K_);
        s_.storeState(code_, xCode, dxCode);
        expectClose(xCode, x, "state after a step");
        expectClose(dxCode, dx, "tangent after a step");
    }

    const System& s_;
    std::size_t n_, K_;
    double t_;
    std::vector<double> p_, dp_, x_, dx_, u_;
    Workspace interpreted_, code_;
};

inline void checkMachineCode(const System& system, const std::vector<double>& x, const std::vector<double>& u,
                             double t = 0.3) {
    for (const int directions : {0, 1, 5, 9, 17}) {
        SCOPED_TRACE(directions);
        MachineCodeCheck(system, x, u, t, directions).run();
    }
}

}  // namespace analogon::test
