#include "core/structure/alias.hpp"

#include <gtest/gtest.h>

#include <ctime>

#include "tests/core/structure/analysed.hpp"
#include "tests/core/structure/model_builder.hpp"

namespace analogon {
namespace {

using test::analysed;
using test::ModelBuilder;
using test::standIn;

/// v[i] = v[i-1] beside equations that wait for what the chain tells: w[i] = v[i] + z[i], z[i] = v[i] - v[i-1].
TEST(Aliases, ManyEqualVariablesAreMergedInTheTimeThatTheirNumberTakes) {
    constexpr int count = 50000;
    ModelBuilder m;
    m.output("y");
    const auto name = [](const char* of, int i) { return of + std::to_string(i); };
    for (int i = 0; i < count; ++i)
        for (const char* of : {"v", "w", "z"}) m.variable(name(of, i));
    m.eq(m.v("v0"), m.time());
    m.eq(m.v("z0"), m.c(0));
    m.eq(m.v("w0"), m.v("v0") + m.v("z0"));
    for (int i = 1; i < count; ++i) {
        m.eq(m.v(name("w", i)), m.v(name("v", i)) + m.v(name("z", i)));
        m.eq(m.v(name("v", i)), m.v(name("v", i - 1)));
        m.eq(m.v(name("z", i)), m.v(name("v", i)) - m.v(name("v", i - 1)));
    }
    m.eq(m.v("y"), m.v(name("w", count - 1)));
    const std::clock_t begin = std::clock();
    const Structure s = analysed(m.model());
    EXPECT_EQ(s.equationsAfter, 1);
    EXPECT_EQ(standIn(s, "w7"), "y");
    EXPECT_EQ(standIn(s, "z7"), "0");
    EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 5);
}

}  // namespace
}  // namespace analogon
