#include "core/fit/known_product.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/fit/uncertainty.hpp"

namespace analogon {
namespace {

/// Of a Jacobian with respect to logarithms of known quantities, each a product of powers of the parameters.
std::vector<KnownProduct> knownOf(const std::vector<FittedValue>& parameters, const Eigen::MatrixXd& powers,
                                  const Eigen::VectorXd& relativeErrors) {
    Eigen::MatrixXd jacobian(powers.rows(), powers.cols());
    std::vector<std::string> names;
    for (Eigen::Index i = 0; i < powers.cols(); ++i) {
        const FittedValue& p = parameters[static_cast<std::size_t>(i)];
        jacobian.col(i) = powers.col(i).cwiseQuotient(relativeErrors) / p.value;
        names.push_back(p.name);
    }
    const Uncertainty found = uncertaintyOf(jacobian, 1, names);
    return knownProducts(parameters, found.unseen, found.seen);
}

const std::vector<FittedValue> heater{{"P", 40, "W"}, {"G", 2.857, "W/K"}, {"C", 1200, "J/K"}};

TEST(KnownProducts, AreTheRatiosOfWhatScalesTogether) {
    const Eigen::MatrixXd powers{{1, -1, 0}, {0, -1, 1}};
    const std::vector<KnownProduct> known = knownOf(heater, powers, Eigen::VectorXd{{0.001, 0.002}});
    ASSERT_EQ(known.size(), 2u);
    EXPECT_EQ(known[0].name, "P/G");
    EXPECT_NEAR(known[0].value, 40 / 2.857, 1e-12);
    EXPECT_NEAR(known[0].standardError / known[0].value, 0.001, 1e-8);
    EXPECT_EQ(known[0].unit, "K");
    EXPECT_EQ(known[1].name, "C/G");
    EXPECT_NEAR(known[1].standardError / known[1].value, 0.002, 1e-8);
    EXPECT_EQ(known[1].unit, "s");
}

TEST(KnownProducts, HaveTheSignAndTheSizeOfTheirPowers) {
    const std::vector<FittedValue> two{{"R", 3, "Ohm"}, {"k", 0.05, "V.s"}};
    const std::vector<KnownProduct> product = knownOf(two, Eigen::MatrixXd{{1, 1}}, Eigen::VectorXd{{0.01}});
    ASSERT_EQ(product.size(), 1u);
    EXPECT_TRUE(product[0].name == "R*k" || product[0].name == "k*R") << product[0].name;
    EXPECT_NEAR(product[0].value, 0.15, 1e-12);
    const std::vector<KnownProduct> square = knownOf(two, Eigen::MatrixXd{{-1, 2}}, Eigen::VectorXd{{0.01}});
    ASSERT_EQ(square.size(), 1u);
    EXPECT_TRUE(square[0].name == "k^2/R" || square[0].name == "R/k^2") << square[0].name;
    EXPECT_NEAR(square[0].standardError / square[0].value, 0.01, 1e-8);
}

TEST(KnownProducts, AreNoneOfASumOrWhereAValueMayBeAnything) {
    const std::vector<FittedValue> lags{{"first.T", 0.2, "s"}, {"second.T", 0.31, "s"}};
    const Eigen::MatrixXd sum{{0.2, 0.31}};  // d(a + b) by the relative changes
    EXPECT_TRUE(knownOf(lags, sum, Eigen::VectorXd{{0.01}}).empty());
    const std::vector<FittedValue> offsets{{"a", -1, ""}, {"b", 2, ""}};
    EXPECT_TRUE(knownOf(offsets, Eigen::MatrixXd{{1, -1}}, Eigen::VectorXd{{0.01}}).empty());
}

TEST(KnownOfPairs, IsTheSumOfTwoLagsThatStandInForEachOther) {
    const std::vector<FittedValue> lags{{"first.T", 0.2, "s"}, {"second.T", 0.31, "s"}};
    // the sum to 0.002 s, the difference to 0.2 s
    const double sum = 4e-6, difference = 0.04, same = (sum + difference) / 4, other = (sum - difference) / 4;
    const std::vector<KnownProduct> known = knownOfPairs(lags, Eigen::MatrixXd{{same, other}, {other, same}});
    ASSERT_EQ(known.size(), 1u);
    EXPECT_EQ(known[0].name, "first.T + second.T");
    EXPECT_NEAR(known[0].value, 0.51, 1e-12);
    EXPECT_NEAR(known[0].standardError, 0.002, 1e-9);
    EXPECT_EQ(known[0].unit, "s");
}

TEST(KnownOfPairs, IsToldOfPrecisePairsThatCanHardlyBeToldApart) {
    const std::vector<FittedValue> lags{{"first.T", 12.0, "s"}, {"second.T", 11.0, "s"}};
    // the sum to 0.01 s, the difference to 1 s: each is known to a twentieth
    const double sum = 1e-4, difference = 1.0, same = (sum + difference) / 4, other = (sum - difference) / 4;
    const std::vector<KnownProduct> known = knownOfPairs(lags, Eigen::MatrixXd{{same, other}, {other, same}});
    ASSERT_EQ(known.size(), 1u);
    EXPECT_EQ(known[0].name, "first.T + second.T");
    EXPECT_NEAR(known[0].standardError, 0.01, 1e-9);
}

TEST(KnownOfPairs, IsNothingOfWhatIsKnownByItself) {
    const std::vector<FittedValue> two{{"R", 3, "Ohm"}, {"k", 0.05, "V.s"}};
    EXPECT_TRUE(knownOfPairs(two, Eigen::MatrixXd{{1e-4, 0}, {0, 1e-8}}).empty());
    EXPECT_TRUE(knownOfPairs(two, Eigen::MatrixXd{{1.0, 0}, {0, 1e-3}}).empty()) << "uncertain, but not together";
}

}  // namespace
}  // namespace analogon
