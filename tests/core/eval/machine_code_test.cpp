#include <gtest/gtest.h>

#include "tests/core/eval/machine_code_check.hpp"
#include "tests/core/simulate/text_models.hpp"

namespace analogon {
namespace {

using test::checkMachineCode;
using test::compileText;

TEST(MachineCode, AgreesWithTheInterpreterOnAMotor) {
    const SystemPtr system = compileText(test::motorText, "Motor", {"R", "L", "k", "J1", "J2", "c", "d", "b"});
    ASSERT_TRUE(system);
    checkMachineCode(*system, {0.3, 0.1, 0.08, 12, 11}, {9});
}

TEST(MachineCode, AgreesOnEveryOperation) {
    const SystemPtr system = compileText(R"(
model All
  input Real u;
  output Real y;
  parameter Real p = 0.7;
  parameter Real q = 1.3;
  Real x(start = 0.2, fixed = true);
  Real z(start = 0.4, fixed = true);
equation
  der(x) = p*sin(x) + cos(q*z) - tan(0.3*x)*exp(-z) + log(2 + x^2) + log10(3 + z) + sqrt(abs(x) + q)
    + asin(0.3*x) + acos(0.2*z) + atan(p*x) + atan2(x, q + z) + sinh(0.1*x) + cosh(p*0.1) + tanh(x/p)
    + noEvent(if x > z then p*x else q*z) + noEvent(if u >= x and z < 5 or x == 2 then -p else x*z)
    + min(x, p*z) + max(x, q) + (x + 1)^q + (1 + z)^3 + 1/(x + 2) + p/(z*x + 3) + time*p + sign(x)*q;
  der(z) = u - z/q + (p*x)^2 - x*z + noEvent(if not (x < z) then 1 else 2*p) + x^0.5 + z^4;
  y = x*u + q;
end All;
)",
                                         "All", {"p", "q"});
    ASSERT_TRUE(system);
    checkMachineCode(*system, {0.4, 0.6}, {0.9});
    checkMachineCode(*system, {0.8, 0.1}, {0.2});
}

TEST(MachineCode, AgreesOnAlgebraicLoops) {
    const SystemPtr system = compileText(R"(
model Loops
  input Real u;
  output Real y;
  parameter Real p = 0.7;
  parameter Real q = 1.3;
  Real x(start = 0.2, fixed = true);
  Real a;
  Real b;
  Real c(start = 0.5);
  Real d(start = 0.5);
equation
  der(x) = -p*a + q*b + c*d;
  p*a + (1 + x^2)*b = u;
  q*a - x*b = 1 + p*x;
  c + 0.3*exp(-d*p) = 1 + 0.1*x;
  d + 0.2*sin(c*q) = u*0.3 + a;
  y = c + b;
end Loops;
)",
                                         "Loops", {"p", "q"});
    ASSERT_TRUE(system);
    checkMachineCode(*system, {0.4}, {0.9});
    checkMachineCode(*system, {-0.3}, {1.7});
}

TEST(MachineCode, NamesWhatIsNotFinite) {
    const SystemPtr system = compileText(R"(
model Root
  input Real u;
  output Real y;
  parameter Real p = 1;
  Real x(start = 1, fixed = true);
  Real w;
equation
  w = log(x - p);
  der(x) = u + w;
  y = x;
end Root;
)",
                                         "Root", {"p"});
    ASSERT_TRUE(system);
    Workspace w = system->workspace(1);
    const std::vector<double> p{1}, dp{1}, x{0.5}, dx{0}, u{1};
    std::vector<double> xdot(1), dxdot(1);
    ASSERT_TRUE(system->setParameters(w, p, dp));
    system->prepareSteps(w);
    EXPECT_FALSE(system->derivatives(w, 0, x, dx, u, {}, xdot, dxdot));
    EXPECT_EQ(system->failure(w), "w");
}

}  // namespace
}  // namespace analogon
