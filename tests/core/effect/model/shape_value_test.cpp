#include "core/effect/model/shape_value.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace analogon {
namespace {

ShapeContext context() {
    return {[](const std::string& name) { return name == "sample" ? 0.01 : std::nan(""); },
            [](const std::string& function, const std::string& variable) {
                return function == "maxabs" && variable == "w" ? 200.0 : std::nan("");
            }};
}

TEST(ShapeValue, ComputesArithmeticOverQuantitiesAndStatistics) {
    EXPECT_DOUBLE_EQ(*shapeValue("0.002*maxabs(w)", context()), 0.4);
    EXPECT_DOUBLE_EQ(*shapeValue("-8*sample + 1/2", context()), 0.42);
    EXPECT_DOUBLE_EQ(*shapeValue("max(sample, 3)^2", context()), 9);
}

TEST(ShapeValue, IsAFaultWhereAnythingIsUnknown) {
    EXPECT_FALSE(shapeValue("2*duration", context()));
    EXPECT_FALSE(shapeValue("range(w)", context()));
    EXPECT_FALSE(shapeValue("2*", context()));
    EXPECT_FALSE(shapeValue("1/0", context()));
}

TEST(ShapeValue, TellsTheVariablesItNeeds) {
    EXPECT_EQ(shapeVariables("0.1*range(port.T)/maxabs(w) + sample"), (std::vector<std::string>{"port.T", "w"}));
    EXPECT_EQ(shapeVariables("through(flange)/range(phi)"), (std::vector<std::string>{"phi"})) << "a port is none";
}

}  // namespace
}  // namespace analogon
