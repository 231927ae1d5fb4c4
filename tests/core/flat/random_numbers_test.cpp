#include "core/flat/random_numbers.hpp"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>

#include "flat_support.hpp"

namespace analogon {
namespace {

using Words = std::vector<std::uint64_t>;

std::uint64_t nextOf64star(Words& s) {
    s[0] ^= s[0] >> 12;
    s[0] ^= s[0] << 25;
    s[0] ^= s[0] >> 27;
    s[0] *= 2685821657736338717u;
    return s[0];
}

std::uint64_t nextOf128plus(Words& s) {
    std::uint64_t a = s[0];
    const std::uint64_t b = s[1];
    a ^= a << 23;
    s = {b, (a ^ b ^ (a >> 17) ^ (b >> 26)) + b};
    return s[1];
}

/// The last word counts the turns.
std::uint64_t nextOf1024star(Words& s) {
    std::uint64_t a = s[s[16]];
    s[16] = (s[16] + 1) % 16;
    std::uint64_t b = s[s[16]];
    b ^= b << 31;
    b ^= b >> 11;
    a ^= a >> 30;
    s[s[16]] = a ^ b;
    return s[s[16]] * 1181783497276652981u;
}

double fractionOf(std::uint64_t word) {
    return static_cast<double>(std::bit_cast<std::int64_t>(word)) * std::ldexp(1, -64) + 0.5;
}

double lowOf(std::uint64_t word) { return static_cast<std::int32_t>(static_cast<std::uint32_t>(word)); }

using Generator = RandomStep (*)(ExpressionPool&, std::span<const ExpressionId>);
using Next = std::uint64_t (*)(Words&);

/// The generator once over variables, then run by evaluating them, beside 64-bit integers.
void expectSame(Generator generator, Next next, Words words, std::size_t wordCount, int steps) {
    ExpressionPool pool;
    std::vector<ExpressionId> variables;
    std::vector<double> values;
    for (std::size_t i = 0; i < wordCount; ++i)
        for (const std::uint64_t half : {words[i], words[i] >> 32}) values.push_back(lowOf(half));
    if (words.size() > wordCount) values.push_back(static_cast<double>(words.back()));
    for (std::uint32_t i = 0; i < values.size(); ++i) variables.push_back(pool.variable({i}));
    const RandomStep step = generator(pool, variables);
    for (int k = 0; k < steps; ++k) {
        const auto leaf = [&](const ExpressionNode& node) { return values[node.variable.value]; };
        const double number = pool.evaluate(step.number, leaf);
        std::vector<double> after;
        for (const ExpressionId id : step.state) after.push_back(pool.evaluate(id, leaf));
        values = after;
        ASSERT_EQ(number, fractionOf(next(words))) << "step " << k;
        for (std::size_t i = 0; i < wordCount; ++i) {
            ASSERT_EQ(values[2 * i], lowOf(words[i])) << "step " << k;
            ASSERT_EQ(values[2 * i + 1], lowOf(words[i] >> 32)) << "step " << k;
        }
    }
}

TEST(RandomNumbers, AreThoseOfArithmeticWithWords) {
    for (const std::uint64_t seed : {0x1ull, 0xffffffffffffffffull, 0x8000000000000000ull, 0x40bda1f0075bcd15ull}) {
        expectSame(xorshift64star, nextOf64star, {seed}, 1, 200);
        expectSame(xorshift128plus, nextOf128plus, {seed, ~seed >> 3}, 2, 200);
        Words many{seed}, filling{seed};
        for (int i = 1; i < 16; ++i) many.push_back(nextOf64star(filling));
        many.push_back(13);
        expectSame(xorshift1024star, nextOf1024star, many, 16, 60);
    }
}

TEST(RandomNumbers, OfKnownSeedsAreNumbers) {
    ExpressionPool pool;
    std::vector<ExpressionId> state{pool.constant(614657), pool.constant(-30020221)};
    Words words{(std::uint64_t{static_cast<std::uint32_t>(-30020221)} << 32) | 614657u};
    for (int k = 0; k < 10; ++k) {
        const RandomStep step = xorshift64star(pool, state);
        ASSERT_TRUE(pool.isConstant(step.number));
        EXPECT_EQ(pool[step.number].value, fractionOf(nextOf64star(words)));
        state = step.state;
    }
}

// The first two stand in the documentation of Modelica.Utilities.Strings.hashString.
TEST(RandomNumbers, HashesOfTextsAreThePublishedOnes) {
    const std::vector<std::pair<std::string, int>> known{{"this is a test", 1827717433},
                                                         {"Controller.noise1", -1025762750},
                                                         {"", -1431655766},
                                                         {"a", -357913953},
                                                         {"Vehicle.engine.controller", -185211601},
                                                         {"öl 1234", -414062376}};
    for (const auto& [text, hash] : known) EXPECT_EQ(hashOf(text), hash) << text;
}

TEST(RandomNumbers, ADiscreteParameterHasTheValueOfItsInitialEquation) {
    const FlatModel flat = test::flatOf(R"(
        model Part
          parameter Integer seed(fixed = false), twice = 2*seed;
          parameter Boolean isOdd(fixed = false);
        initial equation
          seed = if getInstanceName() == "M.part" then 7 else 8;
          isOdd = mod(seed, 2) == 1;
        end Part;
        model M Part part; Real y = part.twice*time; end M;)");
    EXPECT_EQ(test::valueOf(flat, "part.twice"), 14);
    EXPECT_EQ(test::valueOf(flat, "part.isOdd"), 1);
    EXPECT_TRUE(flat.initialEquations.empty());
}

TEST(RandomNumbers, ThatFollowFromANameAreSaidToDoSo) {
    const std::string text = R"(
        function hash input String s; output Integer h; external "C" h = ModelicaStrings_hashString(s); end hash;
        model Part parameter String name = getInstanceName(); parameter Integer seed = hash(%); Real y = seed*time;
        end Part;
        model M Part part; end M;)";
    const auto remarksOf = [&](const std::string& hashed) {
        std::string model = text;
        model.replace(model.find('%'), 1, hashed);
        const Outcome<FlatModel> flat = flatten(test::libraryOf(model), "M");
        EXPECT_TRUE(flat) << format(flat.diagnostics());
        return format(flat.diagnostics());
    };
    EXPECT_THAT(remarksOf("name"), ::testing::HasSubstr("random numbers follow from the name 'M.part'"));
    EXPECT_EQ(remarksOf("\"M\""), "");
}

TEST(RandomNumbers, OfAHiddenStateAreRefused) {
    const auto faults = test::faultsOf(R"(
        function f input Integer id; output Real y;
          external "C" y = ModelicaRandom_impureRandom_xorshift1024star(id); end f;
        model M Real y = f(1); end M;)");
    ASSERT_FALSE(faults.empty());
    EXPECT_THAT(faults[0], ::testing::HasSubstr("a hidden state"));
}

}  // namespace
}  // namespace analogon
