#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ctime>

#include "tests/core/structure/analysed.hpp"
#include "tests/core/structure/model_builder.hpp"

namespace analogon {
namespace {

using test::ModelBuilder;
using test::refusal;
using ::testing::AllOf;
using ::testing::HasSubstr;

/// A sum that all equations share: each of them holds all variables.
TEST(LargeModel, RefusesEquationsThatReferToTooMuchTogether) {
    constexpr int count = 4000;
    ModelBuilder m;
    const auto name = [](int i) { return "v" + std::to_string(i); };
    for (int i = 0; i < count; ++i) m.variable(name(i));
    ModelBuilder::E sum = m.v("v0");
    for (int i = 1; i < count; ++i) sum = sum + m.v(name(i));
    for (int i = 0; i < count; ++i) m.eq(m.v(name(i)) * m.v(name(i)) + sum, m.c(i));
    const std::clock_t begin = std::clock();
    EXPECT_THAT(refusal(m.model()), HasSubstr("the equations of the model refer to its variables more than 20000000 "
                                              "times"));
    EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 5);
}

TEST(LargeModel, RefusesALoopOfTooManyUnknowns) {
    constexpr int count = 550;
    ModelBuilder m;
    const auto name = [](int i) { return "v" + std::to_string(i); };
    for (int i = 0; i < count; ++i) m.variable(name(i));
    for (int i = 0; i < count; ++i) {
        ModelBuilder::E sum = m.v(name(i));
        for (int j = 0; j < count; ++j) sum = sum + m.f(Operation::Sin, (i + j) * m.v(name(j)));
        m.eq(sum, m.time());
    }
    EXPECT_THAT(refusal(m.model()),
                AllOf(HasSubstr("must be solved at once, in more than 500 unknowns"), HasSubstr("Break the loop")));
}

}  // namespace
}  // namespace analogon
