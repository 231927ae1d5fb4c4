#include "core/eval/c_code.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/eval/system.hpp"

namespace analogon {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

CCode codeOf(const std::string& text, const std::vector<std::string>& keep = {}) {
    const Outcome<Library> library = Library().withSource(std::make_shared<const Source>("model.mo", text));
    EXPECT_TRUE(library) << format(library.diagnostics());
    const Outcome<SystemPtr> system = compile(*library, "M", {keep});
    EXPECT_TRUE(system) << format(system.diagnostics());
    return (*system)->cCode();
}

TEST(CCode, WritesAnInstructionALine) {
    const CCode code = codeOf(R"(model M
  parameter Real T = 2;
  input Real u;
  output Real y;
equation
  T*der(y) = max(u, 0.25) - y;
end M;)",
                              {"T"});
    EXPECT_THAT(code.text, HasSubstr("#define STATES 1\n"));
    EXPECT_THAT(code.text, HasSubstr("#define PARAMETERS 1\n"));
    EXPECT_THAT(code.text, HasSubstr("= 1.0 / v[0];")) << "once for the parameters";
    EXPECT_THAT(code.text, HasSubstr(", 0.25);"));
    EXPECT_THAT(code.text, HasSubstr("/* der(y) */"));
}

TEST(CCode, SaysWhatAResultDependsOn) {
    const CCode code = codeOf(R"(model M
  parameter Real T = 2;
  parameter Real k = 3;
  parameter Real x0 = 0.5;
  parameter Real T_d = 0.1;
  input Real u;
  input Real v;
  output Real y;
  output Real z;
  Real x(start = x0, fixed = true);
  Real w(start = 0, fixed = true);
  Real i;
equation
  T*der(x) = u - x;
  der(w) = x - w;
  v = i + i^3 + 0.1*x;
  y = k*i;
  z = w + delay(v, T_d);
end M;)",
                              {"T", "k", "x0", "T_d"});
    ASSERT_EQ(code.derivatives.size(), 2u);
    EXPECT_THAT(code.derivatives[0].parameters, ElementsAre(0));
    EXPECT_THAT(code.derivatives[0].states, ElementsAre(0));
    EXPECT_THAT(code.derivatives[0].inputs, ElementsAre(0));
    EXPECT_THAT(code.derivatives[1].states, ElementsAre(0, 1));
    EXPECT_THAT(code.derivatives[1].inputs, IsEmpty());
    ASSERT_EQ(code.outputs.size(), 2u);
    EXPECT_THAT(code.outputs[0].parameters, ElementsAre(1)) << "through the algebraic loop";
    EXPECT_THAT(code.outputs[0].states, ElementsAre(0));
    EXPECT_THAT(code.outputs[0].inputs, ElementsAre(1));
    EXPECT_THAT(code.outputs[1].inputs, IsEmpty()) << "what is delayed is known beforehand";
    EXPECT_THAT(code.initialStates[0].parameters, ElementsAre(2));
    ASSERT_EQ(code.delayTimes.size(), 1u);
    EXPECT_THAT(code.delayTimes[0].parameters, ElementsAre(3));
}

TEST(CCode, NamesCannotEndACommentOrAString) {
    const CCode code = codeOf("model M\n  output Real 'a*/\"b';\nequation\n  'a*/\"b' = sin(time);\nend M;");
    EXPECT_THAT(code.text, HasSubstr("/* 'a* /\"b' */"));
    EXPECT_THAT(code.text, HasSubstr("\"'a*/\\\"b'\""));
}

}  // namespace
}  // namespace analogon
