#include "core/structure/quadratic.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "core/structure/structure.hpp"

namespace analogon {
namespace {

/// A model whose unknown z follows from `equation` over the input u and the parameters k >= 0, d >= 0, f (any).
Structure structureOf(const std::string& equation) {
    const std::string text = fmt::format(
        "model M\n  input Real u;\n  output Real z;\n  parameter Real k(min=0) = 2;\n  parameter Real d(min=0) = 3;\n"
        "  parameter Real f = 1;\nequation\n  {};\nend M;\n",
        equation);
    const Outcome<Library> library = Library().withSource(std::make_shared<const Source>("m.mo", text));
    EXPECT_TRUE(library) << format(library.diagnostics());
    Outcome<FlatModel> flat = flatten(*library, "M");
    EXPECT_TRUE(flat) << format(flat.diagnostics());
    Outcome<Structure> structure = analyse(std::make_shared<const FlatModel>(std::move(*flat)), {{"k", "d", "f"}});
    EXPECT_TRUE(structure) << format(structure.diagnostics());
    return structure ? std::move(*structure) : Structure{};
}

bool isClosed(const Structure& s) {
    for (const SolutionBlock& block : s.blocks)
        if (!block.isExplicit) return false;
    return true;
}

/// z at these values, by the blocks in their order.
double solutionOf(const Structure& s, std::map<std::string, double> values) {
    for (const SolutionBlock& block : s.blocks) {
        const auto leaf = [&](const ExpressionNode& node) { return values.at((*s.model)[node.variable].name); };
        values[(*s.model)[(*s.pool)[block.unknowns[0]].variable].name] = s.pool->evaluate(block.expressions[0], leaf);
    }
    return values.at("z");
}

TEST(QuadraticSolution, MeetsTheEquationWhateverItsTerms) {
    const std::map<std::string, double (*)(double, double, double, double)> residuals{
        {"k*z*abs(z) + d*z = u",
         [](double z, double k, double d, double u) { return k * z * std::fabs(z) + d * z - u; }},
        {"u - d*(z - 2*u) = noEvent(abs(z))*z*k/5",
         [](double z, double k, double d, double u) { return u - d * (z - 2 * u) - std::fabs(z) * z * k / 5; }},
        {"k*(z - u)*abs(z - u) + d*z = 4*u",
         [](double z, double k, double d, double u) { return k * (z - u) * std::fabs(z - u) + d * z - 4 * u; }},
        {"-k*abs(3*z)*z = u + 1",
         [](double z, double k, double, double u) { return -k * std::fabs(3 * z) * z - u - 1; }}};
    for (const auto& [equation, residual] : residuals) {
        const Structure s = structureOf(equation);
        ASSERT_TRUE(isClosed(s)) << print(s);
        for (const double u : {-1e6, -3.0, -1e-9, 1e-9, 0.5, 40.0})
            for (const auto& [k, d] : {std::pair(2.0, 3.0), {1e-8, 2.0}, {5.0, 1e-9}}) {
                const double z = solutionOf(s, {{"u", u}, {"k", k}, {"d", d}, {"f", 1}});
                const double size = std::fabs(z) + std::fabs(u);
                const double scale = std::fabs(u) + d * size + k * size * size;
                EXPECT_LE(std::fabs(residual(z, k, d, u)), 1e-13 * (scale + 1)) << equation << " at u = " << u;
            }
    }
}

TEST(QuadraticSolution, LeadsThroughStandstillWithAndWithoutTheLinearTerm) {
    const Structure s = structureOf("k*z*abs(z) + d*z = u");
    EXPECT_EQ(solutionOf(s, {{"u", 0}, {"k", 2}, {"d", 3}, {"f", 1}}), 0);
    EXPECT_EQ(solutionOf(s, {{"u", 0}, {"k", 2}, {"d", 0}, {"f", 1}}), 0);
    EXPECT_EQ(solutionOf(s, {{"u", 6}, {"k", 0}, {"d", 3}, {"f", 1}}), 2);
    EXPECT_EQ(solutionOf(s, {{"u", -8}, {"k", 2}, {"d", 0}, {"f", 1}}), -2);
}

TEST(QuadraticSolution, IsNotTakenWhereThereMayBeSeveralOrTheTermsAreOthers) {
    for (const char* const equation :
         {"k*z*abs(z) - d*z = u", "f*z*abs(z) + d*z = u", "k*z*abs(z) + d*z^3 = u", "k*z*abs(z) + d*tanh(z) = u",
          "k*z*abs(z) + d*abs(z) = u", "k*z*abs(z) + d*(z + u)*abs(z + u) = u"})
        EXPECT_FALSE(isClosed(structureOf(equation))) << equation;
}

}  // namespace
}  // namespace analogon
