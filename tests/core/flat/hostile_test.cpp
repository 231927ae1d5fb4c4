#include <ctime>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "tests/core/flat/flat_support.hpp"

namespace analogon {
namespace {

using namespace test;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr double slowness = 10;  // of a build that watches every access
#else
constexpr double slowness = 1;
#endif

/// Time of the processor, not of the clock: other work on the machine does not count.
double secondsSince(std::clock_t start) { return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC; }

TEST(Hostile, CirclesOfClassesAreRefused) {
    EXPECT_THAT(faultsOf("model M extends M; end M;"), Contains(HasSubstr("'M' extends itself: M extends M")));
    EXPECT_THAT(faultsOf("model A extends M; end A; model M extends A; end M;"),
                Contains(HasSubstr("'M' extends itself: M extends A extends M")));
    EXPECT_THAT(faultsOf("model M A a; end M; model A M m; end A;"),
                Contains(HasSubstr("'M' contains itself: M has A has M")));
    EXPECT_THAT(
        faultsOf("model A replaceable model R = A; R r; end A; model M extends A(redeclare model R = M); end M;"),
        Contains(HasSubstr("contains itself")));
    EXPECT_THAT(faultsOf("type A = B; type B = A; model M A a; end M;"), Contains(HasSubstr("defined through itself")));
    EXPECT_THAT(faultsOf("package P constant Real a = b; constant Real b = a; end P; model M Real x = P.a; end M;"),
                Contains(HasSubstr("depends on itself")));
}

TEST(Hostile, HugeModelsAreRefusedAtOnce) {
    const auto start = std::clock();
    EXPECT_THAT(faultsOf("model M Real x[1000000000]; equation for i in 1:1000000000 loop x[i] = i; end for; end M;"),
                Contains(HasSubstr("larger than 1000000 scalars")));
    EXPECT_THAT(faultsOf("model M Real x[100000, 100000, 100000] = 1; end M;"), Contains(HasSubstr("larger than")));
    EXPECT_THAT(faultsOf("model M Real x; equation for i in 1:1000000000 loop x = i; end for; end M;"),
                Contains(HasSubstr("the range has more than 1000000 values")));
    EXPECT_THAT(faultsOf("model M Real x = sum(fill(1, 100000, 100000)); end M;"), Not(IsEmpty()));
    EXPECT_THAT(faultsOf("model M Real x = sum(i*j for i in 1:1000000, j in 1:1000000); end M;"),
                Contains(HasSubstr("too large to be worked out")));
    EXPECT_THAT(faultsOf("model M Real x = sum(fill(1, 1000, 1000)*fill(2, 1000, 1000)); end M;"),
                Contains(HasSubstr("too large to be worked out")));
    EXPECT_THAT(
        faultsOf("model M Real x[100000]; equation for i in 1:1000000 loop x = fill(1, 100000); end for; end M;"),
        Contains(HasSubstr("has more than 1000000 equations")));
    std::string doubled = "model D0 Real x = 1; end D0;";
    for (int i = 1; i <= 40; ++i) {
        const std::string n = std::to_string(i), p = std::to_string(i - 1);
        doubled += "model D" + n + " extends D" + p + "; extends D" + p + "; end D" + n + ";";
    }
    EXPECT_THAT(faultsOf(doubled, "D40"), Contains(HasSubstr("inherits too many classes")));
    // 10^7 components, ten in each of seven levels
    std::string levels = "model L0 Real x = 1; end L0;";
    for (int i = 1; i <= 7; ++i)
        levels +=
            "model L" + std::to_string(i) + " L" + std::to_string(i - 1) + " part[10]; end L" + std::to_string(i) + ";";
    EXPECT_THAT(faultsOf(levels, "L7"), Contains(HasSubstr("larger than")));
    EXPECT_LT(secondsSince(start), 6 * slowness);
}

TEST(Hostile, DeepNestingIsRefused) {
    std::string chain = "model L0 Real x = 1; end L0;", heirs = "model H0 Real x = 1; end H0;";
    for (int i = 1; i <= 300; ++i) {
        const std::string n = std::to_string(i), p = std::to_string(i - 1);
        chain += "model L" + n + " L" + p + " part; end L" + n + ";";
        heirs += "model H" + n + " extends H" + p + "; end H" + n + ";";
    }
    EXPECT_THAT(faultsOf(chain, "L300"), Contains(HasSubstr("nested more than")));
    EXPECT_THAT(faultsOf(heirs, "H300"), Contains(HasSubstr("inherits through more than")));
}

TEST(Hostile, LongSumsAndLongParameterChainsAreFast) {
    const auto start = std::clock();
    std::string sum = "model M Real x; equation x = time";
    for (int i = 0; i < 100000; ++i) sum += i % 2 ? "+1" : "+time";
    EXPECT_EQ(flatOf(sum + "; end M;").equations.size(), 1u);
    std::string chain = "model M parameter Real p0 = 1;";
    for (int i = 1; i <= 5000; ++i)
        chain += "parameter Real p" + std::to_string(i) + " = p" + std::to_string(i - 1) + " + p" +
                 std::to_string(i / 2) + "/2;";
    const FlatModel m = flatOf(chain + "end M;");
    EXPECT_TRUE(m.parameterValue(m.find("p100")).has_value());
    EXPECT_TRUE(m.parameterValue(m.find("p5000")).has_value());
    EXPECT_LT(secondsSince(start), 5 * slowness);
}

TEST(Hostile, TwoHundredBlocksTakeMilliseconds) {
    std::string source = "model M ";
    for (int i = 0; i < 200; ++i)
        source += "Parts.Inertia i" + std::to_string(i) + "(J = " + std::to_string(i + 1) + ");";
    source += "equation ";
    for (int i = 1; i < 200; ++i) source += "connect(i" + std::to_string(i - 1) + ".b, i" + std::to_string(i) + ".a);";
    const Library library = libraryOf(source + "end M;");
    double best = 1;
    for (int run = 0; run < 5; ++run) {
        const auto start = std::clock();
        const auto model = flatten(library, "M");
        ASSERT_TRUE(model) << format(model.diagnostics());
        EXPECT_EQ(model->equations.size(), 6u * 200);
        best = std::min(best, secondsSince(start));
    }
    EXPECT_LT(best, 0.05 * slowness);
}

/// Every text of the corpus ends with a model or with messages, soon.
TEST(Hostile, TheCorpusEndsCleanly) {
    const std::filesystem::path folder = ANALOGON_ROOT "/../shared/verification/hostile/model";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not here";
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        std::ifstream file(entry.path());
        std::stringstream text;
        text << file.rdbuf();
        const auto start = std::clock();
        const auto library = Library{}.withSource(std::make_shared<Source>(entry.path().filename(), text.str()));
        bool accepted = bool(library);
        for (std::size_t i = 0; library && i < library->classes().size(); ++i) {
            const auto model = flatten(*library, library->classes()[i]->qualifiedName);
            if (!model) {
                EXPECT_FALSE(model.diagnostics().empty());
                EXPECT_LE(model.diagnostics().size(), 20u);
                accepted = false;
            }
        }
        EXPECT_LT(secondsSince(start), 4 * slowness) << entry.path();
        const std::set<std::string> sound{"ok_base", "terms_100k", "anno_1M", "num_sing"};
        const std::set<std::string> faulty{"extends_self", "contain_cycle",   "array_1e9", "param_cycle", "dup", "over",
                                           "sys_cmd",      "redeclare_cycle", "binary",    "open_string"};
        const std::string name = entry.path().stem();
        EXPECT_FALSE(sound.count(name) && !accepted) << name;
        EXPECT_FALSE(faulty.count(name) && accepted) << name;
    }
}

/// The composed models of the public cases.
TEST(Cases, FlattenBalanced) {
    const std::filesystem::path folder = ANALOGON_ROOT "/../shared/cases";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not here";
    const auto builtIn = builtInLibrary();
    ASSERT_TRUE(builtIn) << format(builtIn.diagnostics());
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        std::ifstream file(entry.path() / "model.mo");
        if (!file) continue;
        std::stringstream text;
        text << file.rdbuf();
        const auto source = std::make_shared<Source>("model.mo", text.str());
        const auto library = builtIn->withSource(source);
        ASSERT_TRUE(library) << format(library.diagnostics());
        const std::string name = text.str().substr(6, text.str().find(' ', 6) - 6);
        const auto model = flatten(*library, name);
        ASSERT_TRUE(model) << format(model.diagnostics());
        ++count;
        for (const FlatComponent& c : model->components) EXPECT_EQ(c.unknowns, c.equations) << c.name;
    }
    EXPECT_GT(count, 0);
}

/// Each class of the library that can stand alone is balanced by itself.
TEST(BlockLibrary, EveryModelFlattens) {
    const auto library = builtInLibrary();
    ASSERT_TRUE(library) << format(library.diagnostics());
    int count = 0;
    for (const LibraryClass* c : library->classes()) {
        const auto restriction = c->definition->restriction;
        if (restriction != syntax::ClassDefinition::Restriction::Model &&
            restriction != syntax::ClassDefinition::Restriction::Block)
            continue;
        if (c->definition->isPartial) continue;
        const auto model = flatten(*library, c->qualifiedName);
        EXPECT_TRUE(model) << format(model.diagnostics());
        ++count;
    }
    EXPECT_GT(count, 10);
}

}  // namespace
}  // namespace analogon
