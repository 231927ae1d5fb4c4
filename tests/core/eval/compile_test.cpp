#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "core/eval/system.hpp"

namespace analogon {
namespace {

using ::testing::HasSubstr;

Outcome<SystemPtr> compiled(const std::string& text, std::vector<std::string> keep = {}) {
    const Outcome<Library> library = Library{}.withSource(std::make_shared<const Source>("model.mo", text));
    if (!library) return library.diagnostics();
    return compile(*library, "M", {std::move(keep)});
}

TEST(Compile, GoesFromTextToDerivatives) {
    const auto system = compiled(R"(
        model M
          parameter Real k = 2;
          parameter Real x_start = 3;
          input Real u;
          output Real y = 2*x;
          Real x(start = x_start, fixed = true);
        equation
          der(x) = k*(u - x);
        end M;)",
                                 {"k", "x_start"});
    ASSERT_TRUE(system) << format(system.diagnostics());
    const System& s = **system;
    Workspace w = s.workspace(0);
    std::vector<double> x(1), xdot(1), y(1);
    const std::vector<double> u{5};
    ASSERT_TRUE(s.setParameters(w, std::vector<double>{2, 3}));
    ASSERT_TRUE(s.initialise(w, 0, u, x));
    ASSERT_TRUE(s.derivatives(w, 0, x, u, xdot));
    ASSERT_TRUE(s.outputs(w, 0, x, u, y));
    EXPECT_EQ(x[0], 3);
    EXPECT_EQ(xdot[0], 4);
    EXPECT_EQ(y[0], 6);
    EXPECT_EQ(s.parameterIndex("x_start"), 1);
    EXPECT_EQ(s.inputIndex("u"), 0);
    EXPECT_EQ(s.outputIndex("y"), 0);
    EXPECT_EQ(s.outputIndex("x"), -1);
    EXPECT_THAT(s.print(), HasSubstr("derivatives of"));
}

TEST(Compile, PointsAtTheEquationThatIsSingular) {
    const auto system = compiled("model M\n  Real a;\n  Real b;\nequation\n  a = b;\n  b = a;\nend M;\n");
    ASSERT_FALSE(system);
    const std::string text = format(system.diagnostics());
    EXPECT_THAT(text, HasSubstr("model.mo:6"));
    EXPECT_THAT(text, HasSubstr("No equation determines a"));
}

TEST(Compile, OneSystemServesManyThreads) {
    const auto system = compiled(R"(
        model M
          parameter Real k = 1;
          input Real u;
          output Real z;
          Real x;
        equation
          der(x) = -k*x;
          z + z^3 = u + x;
        end M;)",
                                 {"k"});
    ASSERT_TRUE(system) << format(system.diagnostics());
    const System& s = **system;
    std::vector<double> sums(8);
    std::vector<std::thread> threads;
    for (std::size_t t = 0; t < sums.size(); ++t)
        threads.emplace_back([&s, &sum = sums[t]] {
            Workspace w = s.workspace(0);
            const std::vector<std::string> names{"z"};
            double z = 0;
            if (!s.setParameters(w, std::vector<double>{1})) return;
            for (int i = 0; i < 200; ++i) {
                const std::vector<double> x{0.01 * i}, u{1};
                if (s.observed(w, 0, x, u, s.observe(names), {&z, 1})) sum += z;
            }
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_GT(sums[0], 100);
    for (const double sum : sums) EXPECT_EQ(sum, sums[0]);
}

}  // namespace
}  // namespace analogon
