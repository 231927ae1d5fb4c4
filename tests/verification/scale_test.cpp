#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdio>

#include "core/eval/system.hpp"
#include "tests/working_time.hpp"

/// What large models cost, from the text to the program, in CPU seconds of this thread.
namespace analogon {
namespace {

#if defined(__SANITIZE_ADDRESS__) || !defined(NDEBUG)
constexpr double slowness = 20;
#else
constexpr double slowness = 1;
#endif

struct Cost {
    double flat{}, structure{}, program{};
    double total() const { return flat + structure + program; }
};

double now() { return 1e-3 * test::workedMilliseconds(); }  // [s]

Cost costOf(const std::string& text) {
    const Outcome<Library> builtIn = builtInLibrary();
    Cost best{1e9, 1e9, 1e9};
    for (int turn = 0; turn < 3; ++turn) {
        Cost cost;
        const double start = now();
        const Outcome<Library> library = builtIn->withSource(std::make_shared<const Source>("m.mo", text));
        EXPECT_TRUE(library) << format(library.diagnostics());
        Outcome<FlatModel> flat = flatten(*library, "M");
        EXPECT_TRUE(flat) << format(flat.diagnostics());
        if (!flat) return cost;
        const double flattened = now();
        const Outcome<Structure> structure = analyse(std::make_shared<const FlatModel>(std::move(*flat)));
        EXPECT_TRUE(structure) << format(structure.diagnostics());
        if (!structure) return cost;
        const double analysed = now();
        const auto system = System::build(*structure);
        EXPECT_TRUE(system) << format(system.diagnostics());
        cost = {flattened - start, analysed - flattened, now() - analysed};
        if (cost.total() < best.total()) best = cost;
    }
    return best;
}

std::string thermalChain(int n) {
    return fmt::format(R"(model M
  parameter Integer n = {};
  Analogon.Thermal.HeatCapacitor mass[n](each C = 5);
  Analogon.Thermal.ThermalConductor link[n - 1](each G = 2);
equation
  for i in 1:n - 1 loop
    connect(mass[i].port, link[i].port_a);
    connect(link[i].port_b, mass[i + 1].port);
  end for;
end M;
)",
                       n);
}

/// The same as blocks of their own, as a diagram has them.
std::string thermalBlocks(int n) {
    std::string text = "model M\n", connections;
    for (int i = 1; i <= n; ++i) {
        text += fmt::format("  Analogon.Thermal.HeatCapacitor mass{}(C = {});\n", i, i);
        if (i == n) break;
        text += fmt::format("  Analogon.Thermal.ThermalConductor link{}(G = 2);\n", i);
        connections += fmt::format(
            "  connect(mass{0}.port, link{0}.port_a);\n  connect(link{0}.port_b, mass{1}.port);\n", i, i + 1);
    }
    return text + "equation\n" + connections + "end M;\n";
}

std::string shaft(int n) {
    return fmt::format(R"(model M
  parameter Integer n = {};
  Analogon.Mechanics.Inertia mass[n](each J = 1e-3);
  Analogon.Mechanics.SpringDamper link[n - 1](each c = 100, each d = 0.1);
equation
  for i in 1:n - 1 loop
    connect(mass[i].flange_b, link[i].flange_a);
    connect(link[i].flange_b, mass[i + 1].flange_a);
  end for;
end M;
)",
                       n);
}

void expectWithinASecond(const char* name, const std::string& text) {
    const Cost cost = costOf(text);
    std::printf("%-34s flat %.3f s, structure %.3f s, program %.3f s\n", name, cost.flat, cost.structure, cost.program);
    EXPECT_LT(cost.total(), slowness);
}

TEST(Scale, ChainsTakeLessThanASecond) {
    expectWithinASecond("200 thermal masses, an array", thermalChain(200));
    expectWithinASecond("200 thermal masses, blocks", thermalBlocks(200));
    expectWithinASecond("50 inertias on a shaft", shaft(50));
}

TEST(Scale, GrowsNearlyLinearly) {
    std::vector<double> structure, total;
    for (const int n : {250, 500, 1000, 2000}) {
        const Cost cost = costOf(thermalBlocks(n / 2));
        std::printf("%5d blocks: flat %.3f s, structure %.3f s, program %.3f s\n", n, cost.flat, cost.structure,
                    cost.program);
        structure.push_back(cost.structure);
        total.push_back(cost.total());
    }
    // Eight times the blocks; quadratic growth would be 64.
    EXPECT_LT(structure[3], 20 * structure[0] + 0.01);
    EXPECT_LT(total[3], 24 * total[0] + 0.02);
}

}  // namespace
}  // namespace analogon
