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

/// Single evaluations of the programs by the interpreter are the reference, at one point: machine code must agree, and
/// so must Runge-Kutta steps by whatever runs them.
class MachineCodeCheck {
public:
    MachineCodeCheck(const System& system, std::vector<double> x, std::vector<double> u, double t, int directions,
                     Execution execution)
        : s_(system),
          n_(x.size()),
          K_(static_cast<std::size_t>(directions)),
          t_(t),
          x_(std::move(x)),
          u_(std::move(u)),
          execution_(execution),
          interpreted_(system.workspace(directions, Execution::Interpreted)),
          code_(system.workspace(directions, execution)) {
        for (const SignalInfo& info : system.parameters()) p_.push_back(info.value);
        // Directions that mix parameters and states.
        for (std::size_t i = 0; i < p_.size() * K_; ++i) dp_.push_back(p_[i / K_] * std::sin(1.0 + 7.0 * i) + 0.01);
        for (std::size_t i = 0; i < n_ * K_; ++i) dx_.push_back(std::cos(2.0 + 3.0 * i));
    }

    void run() {
        ASSERT_TRUE(s_.setParameters(interpreted_, p_, dp_));
        ASSERT_TRUE(s_.setParameters(code_, p_, dp_));
        ASSERT_FALSE(s_.prepareSteps(interpreted_));
        rows();
        if (execution_ == Execution::Interpreted) return;
        if (!s_.prepareSteps(code_)) GTEST_SKIP() << "no machine code on this processor";
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

    /// The classic Runge-Kutta method over the reference's rates, with inputs that run linearly.
    struct Step {
        static constexpr double h = 1e-5;
        bool ok{};
        std::vector<double> uMiddle, uEnd, x, dx;
    };
    Step referenceStep() {
        Step to{false, u_, u_, x_, dx_};
        for (std::size_t i = 0; i < u_.size(); ++i) {
            to.uEnd[i] *= 1.01;
            to.uMiddle[i] = 0.5 * (u_[i] + to.uEnd[i]);
        }
        const double h = Step::h, t = t_;
        const std::vector<double>* const inputs[] = {&u_, &to.uMiddle, &to.uMiddle, &to.uEnd};
        const double reach[] = {0, 0.5 * h, 0.5 * h, h}, weights[] = {h / 6, h / 3, h / 3, h / 6};
        Rates k;
        for (int stage = 0; stage < 4; ++stage) {
            std::vector<double> xs = x_, dxs = dx_;
            for (std::size_t i = 0; i < n_ && stage > 0; ++i) xs[i] += reach[stage] * k.xdot[i];
            for (std::size_t i = 0; i < n_ * K_ && stage > 0; ++i) dxs[i] += reach[stage] * k.dxdot[i];
            t_ = t + reach[stage];
            k = rates(interpreted_, xs, dxs, *inputs[stage]);
            if (!k.ok) break;
            for (std::size_t i = 0; i < n_; ++i) to.x[i] += weights[stage] * k.xdot[i];
            for (std::size_t i = 0; i < n_ * K_; ++i) to.dx[i] += weights[stage] * k.dxdot[i];
        }
        t_ = t;
        to.ok = k.ok;
        return to;
    }
    void expectState(const Step& step, const std::string& what) {
        std::vector<double> x(n_), dx(n_ * K_);
        s_.storeState(code_, x, dx);
        expectClose(x, step.x, "state after " + what);
        expectClose(dx, step.dx, "tangent after " + what);
    }

    void step() {
        const Step to = referenceStep();
        if (!to.ok) return;
        s_.loadState(code_, x_, dx_);
        ASSERT_TRUE(s_.step(code_, t_, Step::h, u_.data(), to.uMiddle.data(), to.uEnd.data()));
        expectState(to, "a step");
    }

    /// A table of one step, with and without a look at its begin.
    void rows() {
        const RowLayout* const layout = s_.prepareRows(code_, 0.0);
        if (!layout) return;  // delays, or slopes of inputs
        const Step to = referenceStep();
        const auto m = static_cast<std::size_t>(s_.outputCount());
        std::vector<double> y(m), dy(m * K_), table(2 * static_cast<std::size_t>(layout->size()));
        const bool isSeen =
            K_ > 0 ? s_.outputs(interpreted_, t_, x_, dx_, u_, {}, y, dy) : s_.outputs(interpreted_, t_, x_, u_, y);
        if (!to.ok || !isSeen) return;
        double* const begin = table.data();
        double* const end = begin + layout->size();
        fillRow(*layout, t_, Step::h, u_, begin);
        fillRow(*layout, t_ + Step::h, 0.0, to.uEnd, end);
        std::vector<double> middle(static_cast<std::size_t>(layout->terms()));
        s_.tabulate(code_, to.uMiddle.data(), middle.data(), 1);
        std::copy_n(middle.data(), layout->rateTerms, begin + layout->rateTerm(1));

        std::vector<double> result(static_cast<std::size_t>(layout->resultSize())), yRow(m), dyRow(m * K_);
        s_.loadState(code_, x_, dx_);
        ASSERT_TRUE(s_.walk(code_, begin, result.data(), 1));
        expectState(to, "a row");
        for (std::size_t o = 0; o < m; ++o) {
            yRow[o] = result[static_cast<std::size_t>(layout->value(static_cast<int>(o)))];
            std::copy_n(result.data() + layout->tangent(static_cast<int>(o)), K_, dyRow.data() + o * K_);
        }
        expectClose(yRow, y, "output of a row");
        expectClose(dyRow, dy, "tangent of an output of a row");
        expectClose({result.data() + layout->state(0), result.data() + layout->state(0) + n_}, x_, "state of a row");
        s_.loadState(code_, x_, dx_);
        ASSERT_TRUE(s_.stepOver(code_, begin, 1));
        expectState(to, "a row that nobody looks at");
    }
    void fillRow(const RowLayout& layout, double t, double h, const std::vector<double>& u, double* row) {
        row[RowLayout::time] = t;
        row[RowLayout::step] = h;
        std::copy(u.begin(), u.end(), row + layout.slot());
        s_.tabulate(code_, u.data(), row + layout.rateTerm(0), 1);
    }

    const System& s_;
    std::size_t n_, K_;
    double t_;
    std::vector<double> p_, dp_, x_, dx_, u_;
    Execution execution_;
    Workspace interpreted_, code_;
};

inline void checkMachineCode(const System& system, const std::vector<double>& x, const std::vector<double>& u,
                             double t = 0.3) {
    for (const int directions : {0, 1, 5, 9, 17}) {
        SCOPED_TRACE(directions);
        for (const Execution execution : {Execution::Fastest, Execution::Avx2, Execution::Interpreted}) {
            SCOPED_TRACE(static_cast<int>(execution));
            MachineCodeCheck(system, x, u, t, directions, execution).run();
        }
    }
}

}  // namespace analogon::test
