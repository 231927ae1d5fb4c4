#include "core/structure/hidden_constraint.hpp"

#include <gtest/gtest.h>

#include "core/flat/flat_model.hpp"
#include "tests/core/structure/analysed.hpp"

namespace analogon {
namespace {

using test::analysed;

/// Three chokes from a grounded star, a bridge of branches that depend on the voltage as a cube, and a floating
/// capacitor; `leak` flows from the capacitor to ground.
Structure threePhases(const std::string& leak) {
    const std::string text = R"(
        model M
          Real i[3], w[3], a[3], b[3], p, n, u(start = 1, fixed = true), j;
          output Real y = u;
        equation
          for k in 1:3 loop
            0.1*der(i[k]) = sin(time + 2*k) - w[k];
            i[k] = a[k] - b[k];
            a[k] = (w[k] - p)^3;
            b[k] = (n - w[k])^3;
          end for;
          a[1] + a[2] + a[3] = j;
          b[1] + b[2] + b[3] = j)" +
                             leak +
                             R"(;
          u = p - n;
          2*der(u) = j - u;
        end M;)";
    const Outcome<Library> library = Library().withSource(std::make_shared<const Source>("m.mo", text));
    EXPECT_TRUE(library) << format(library.diagnostics());
    Outcome<FlatModel> flat = flatten(*library, "M");
    EXPECT_TRUE(flat) << format(flat.diagnostics());
    return flat ? analysed(std::make_shared<const FlatModel>(std::move(*flat))) : Structure{};
}

// Nothing but the chokes leads to ground: their currents add up to zero.
TEST(HiddenConstraints, CurrentsIntoAFloatingCircuitAreNotIndependent) { EXPECT_EQ(threePhases("").states.size(), 3u); }

TEST(HiddenConstraints, AreNoneWhereACurrentFindsAnotherWay) { EXPECT_EQ(threePhases(" - n").states.size(), 4u); }

}  // namespace
}  // namespace analogon
