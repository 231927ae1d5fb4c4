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

/// A gear box that tells its twist, with a spring inside that tells the same.
TEST(Aliases, TwoStatesThatAreSetToTheSameAreOne) {
    const char* const text = R"(
        model M
          Real a(start = 1), b(start = 0, fixed = true), u(start = 0, fixed = true), m;
          Real outer_(start = 1, fixed = true, stateSelect = StateSelect.prefer);
          Real speed(start = 0, fixed = true, stateSelect = StateSelect.prefer);
          Real inner_(stateSelect = StateSelect.prefer), w(stateSelect = StateSelect.prefer);
          output Real y;
        equation
          der(b) = u; 3*der(u) = y; b = m;
          outer_ = a - m; speed = der(outer_);
          inner_ = a - m; w = der(inner_);
          y = 5*inner_ + 0.1*w;
          2*der(w) = -y + der(speed);
        end M;)";
    const Outcome<Library> library = Library().withSource(std::make_shared<const Source>("m.mo", text));
    ASSERT_TRUE(library) << format(library.diagnostics());
    Outcome<FlatModel> flat = flatten(*library, "M");
    ASSERT_TRUE(flat) << format(flat.diagnostics());
    const Structure s = analysed(std::make_shared<const FlatModel>(std::move(*flat)));
    EXPECT_EQ(s.states.size(), 4u);
    EXPECT_EQ(standIn(s, "inner_"), "outer_");
}

}  // namespace
}  // namespace analogon
