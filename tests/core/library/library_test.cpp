#include "core/library/library.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <thread>

namespace analogon {
namespace {

namespace fs = std::filesystem;

SourcePtr sourceOf(std::string text, std::string name = "m.mo") {
    return std::make_shared<const Source>(std::move(name), std::move(text));
}

/// A package in a directory of its own that goes when the test ends.
class LibraryTest : public testing::Test {
protected:
    void SetUp() override {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        root_ = fs::temp_directory_path() / ("analogon-library-" + std::to_string(getpid()) + "-" + info->name());
        fs::remove_all(root_);
        fs::create_directories(root_);
    }
    void TearDown() override { fs::remove_all(root_); }

    void write(const std::string& file, const std::string& text) {
        fs::create_directories((root_ / file).parent_path());
        std::ofstream(root_ / file, std::ios::binary) << text;
    }

    /// Two sub-packages, one as a directory, one within package.mo.
    void writePlant() {
        write("Plant/package.mo",
              "within ;\npackage Plant\n  model Top end Top;\n  constant Real g = 9.81;\nend Plant;\n");
        write("Plant/package.order", "g\nInterfaces\nDrives\nTop\n");
        write("Plant/Interfaces/package.mo", "within Plant;\npackage Interfaces end Interfaces;\n");
        write("Plant/Interfaces/package.order", "Port\nPartialPort\n");
        write("Plant/Interfaces/Port.mo", "within Plant.Interfaces;\nconnector Port extends PartialPort; end Port;\n");
        write("Plant/Interfaces/PartialPort.mo",
              "within Plant.Interfaces;\npartial connector PartialPort\n  type Angle = Real(unit=\"rad\");\nend "
              "PartialPort;\n");
        write("Plant/Drives/package.mo", "within Plant;\npackage Drives end Drives;\n");
        write("Plant/Drives/package.order", "Motor\n");
        write("Plant/Drives/Motor.mo",
              "within Plant.Drives;\nmodel Motor\n  extends Interfaces.Port;\n  model Winding end Winding;\nend "
              "Motor;\n");
    }

    Library load(const std::string& directory = "Plant") {
        auto library = Library().withPath(root_ / directory);
        EXPECT_TRUE(library) << format(library.diagnostics());
        EXPECT_TRUE(library.diagnostics().empty()) << format(library.diagnostics());
        return library ? *library : Library();
    }

    fs::path root_;
};

std::string found(const LibraryClass* one) { return one ? one->qualifiedName : "-"; }

std::string lookedUp(const Library& library, std::string_view name, std::string_view scope) {
    return found(library.lookup(name, scope));
}

TEST_F(LibraryTest, ReadsAPackageDirectoryInItsOrder) {
    writePlant();
    const Library library = load();
    EXPECT_EQ(library.names(), (std::vector<std::string>{
                                   "Plant", "Plant.Interfaces", "Plant.Interfaces.Port", "Plant.Interfaces.PartialPort",
                                   "Plant.Interfaces.PartialPort.Angle", "Plant.Drives", "Plant.Drives.Motor",
                                   "Plant.Drives.Motor.Winding", "Plant.Top"}));
    const LibraryClass* motor = library.find("Plant.Drives.Motor");
    ASSERT_NE(motor, nullptr);
    EXPECT_EQ(motor->scope, "Plant.Drives");
    EXPECT_EQ(motor->definition->name, "Motor");
    EXPECT_EQ(library.find("Motor"), nullptr);
}

TEST_F(LibraryTest, WarnsWhenPackageOrderAndDirectoryDiffer) {
    writePlant();
    write("Plant/Interfaces/package.order", "PartialPort\nPortt\n");
    const auto library = Library().withPath(root_ / "Plant");
    ASSERT_TRUE(library) << format(library.diagnostics());
    ASSERT_EQ(library.diagnostics().size(), 2u) << format(library.diagnostics());
    EXPECT_EQ(library.diagnostics()[0].message, "\"Portt\" is listed but not there");
    EXPECT_EQ(library.diagnostics()[0].place.line, 2);
    EXPECT_EQ(library.diagnostics()[0].hint, "did you mean \"Port\"?");
    EXPECT_EQ(library.diagnostics()[1].message, "\"Port\" is not listed");
    EXPECT_EQ(library.diagnostics()[1].severity, Severity::Warning);
    EXPECT_NE(library->find("Plant.Interfaces.Port"), nullptr);
}

TEST_F(LibraryTest, APackageWithoutOrderIsReadByName) {
    write("P/package.mo", "package P end P;");
    write("P/B.mo", "within P; model B end B;");
    write("P/A.mo", "within P; model A end A;");
    EXPECT_EQ(load("P").names(), (std::vector<std::string>{"P", "P.A", "P.B"}));
}

TEST_F(LibraryTest, NamesFaultsOfAPackage) {
    const auto messageOf = [&](const std::string& directory) {
        const auto library = Library().withPath(root_ / directory);
        return library ? std::string("none") : library.diagnostics().front().message.english();
    };
    write("Empty/readme.txt", "x");
    EXPECT_EQ(messageOf("Empty"), "the directory holds no package.mo");
    EXPECT_EQ(messageOf("Nowhere"), "no such file or directory");
    write("P/package.mo", "package P end P;");
    write("P/A.mo", "within Q; model A end A;");
    EXPECT_EQ(messageOf("P"), "the file belongs to \"P\" and must say so");
    write("P/A.mo", "within P; model B end B;");
    EXPECT_EQ(messageOf("P"), "the class is called \"B\", its place on the disk \"A\"");
    write("P/A.mo", "within P; model A Real x end A;");
    const auto broken = Library().withPath(root_ / "P");
    ASSERT_FALSE(broken);
    EXPECT_EQ(broken.diagnostics().front().place.file, (root_ / "P/A.mo").string());
    write("P/A.mo", "within P; model A end A; model B end B;");
    EXPECT_EQ(messageOf("P"), "a file of a package holds one class");
    write("P/package.mo", "package P model A end A; end P;");
    write("P/A.mo", "within P; model A end A;");
    EXPECT_EQ(messageOf("P"), "\"A\" stands in package.mo and in a file of its own");
}

TEST_F(LibraryTest, ReadsASingleFile) {
    write("own.mo", "model A end A; package P model B end B; end P;");
    const auto library = Library().withPath(root_ / "own.mo");
    ASSERT_TRUE(library);
    EXPECT_EQ(library->names(), (std::vector<std::string>{"A", "P", "P.B"}));
}

TEST_F(LibraryTest, LooksUpFromTheScopeOutward) {
    writePlant();
    const Library library = load();
    EXPECT_EQ(lookedUp(library, "Interfaces.Port", "Plant.Drives.Motor"), "Plant.Interfaces.Port");
    EXPECT_EQ(lookedUp(library, "Motor", "Plant.Drives"), "Plant.Drives.Motor");
    EXPECT_EQ(lookedUp(library, "Winding", "Plant.Drives.Motor"), "Plant.Drives.Motor.Winding");
    EXPECT_EQ(lookedUp(library, "Winding", "Plant.Drives"), "-");
    EXPECT_EQ(lookedUp(library, "Plant.Top", "Plant.Drives.Motor"), "Plant.Top");
    EXPECT_EQ(lookedUp(library, ".Plant.Top", "Plant.Drives.Motor"), "Plant.Top");
    EXPECT_EQ(lookedUp(library, ".Top", "Plant"), "-");
    EXPECT_EQ(lookedUp(library, "Plant.Drives", ""), "Plant.Drives");
    EXPECT_EQ(lookedUp(library, "Nothing", "Plant.Drives.Motor"), "-");
    EXPECT_EQ(lookedUp(library, "", "Plant"), "-");
}

TEST_F(LibraryTest, FindsInheritedClasses) {
    writePlant();
    const Library library = load();
    // Motor extends Port extends PartialPort, which declares Angle.
    EXPECT_EQ(lookedUp(library, "Angle", "Plant.Drives.Motor"), "Plant.Interfaces.PartialPort.Angle");
    EXPECT_EQ(lookedUp(library, "Drives.Motor.Angle", "Plant"), "Plant.Interfaces.PartialPort.Angle");
    EXPECT_EQ(lookedUp(library, "Angle", "Plant.Drives.Motor.Winding"), "Plant.Interfaces.PartialPort.Angle");
}

TEST(Library, FindsImportedClassesBehindDeclaredOnes) {
    const auto library = Library().withSource(
        sourceOf("package P model A end A; model B end B; package Q model C end C; end Q; end P;\n"
                 "model M import P.A; import D = P.B; import P.Q.*; model B end B; model Inner end Inner; end M;\n"
                 "model C end C;"));
    ASSERT_TRUE(library) << format(library.diagnostics());
    EXPECT_EQ(lookedUp(*library, "A", "M"), "P.A");
    EXPECT_EQ(lookedUp(*library, "D", "M"), "P.B");
    EXPECT_EQ(lookedUp(*library, "B", "M"), "M.B");
    EXPECT_EQ(lookedUp(*library, "C", "M"), "P.Q.C");
    EXPECT_EQ(lookedUp(*library, "C", "M.Inner"), "P.Q.C");
    EXPECT_EQ(lookedUp(*library, "C", ""), "C");
    // Imports are not inherited and not seen from outside (section 13.2.1).
    EXPECT_EQ(lookedUp(*library, "M.A", ""), "-");
}

TEST(Library, AnEncapsulatedClassDoesNotSeeOutward) {
    const auto library = Library().withSource(
        sourceOf("package P model A end A; encapsulated model M import P; model N end N; end M; end P;"));
    ASSERT_TRUE(library);
    EXPECT_EQ(lookedUp(*library, "A", "P.M"), "-");
    EXPECT_EQ(lookedUp(*library, "A", "P.M.N"), "-");
    EXPECT_EQ(lookedUp(*library, "P.A", "P.M"), "P.A");
}

TEST(Library, ABaseIsNotLookedForInWhatItBringsItself) {
    // The base A of M is the outer A, although that A declares an A of its own.
    const auto library = Library().withSource(sourceOf("model A model A end A; end A; model M extends A; end M;"));
    ASSERT_TRUE(library);
    const auto bases = library->bases(*library->find("M"));
    ASSERT_EQ(bases.size(), 1u);
    EXPECT_EQ(bases[0]->qualifiedName, "A");
    EXPECT_EQ(lookedUp(*library, "A", "M"), "A.A");
}

TEST(Library, CirclesOfInheritanceEnd) {
    const auto library = Library().withSource(sourceOf(
        "model A extends B; extends A; end A; model B extends C; end B; model C extends A; end C; model D = D;"));
    ASSERT_TRUE(library);
    EXPECT_EQ(lookedUp(*library, "Nothing", "A"), "-");
    EXPECT_EQ(lookedUp(*library, "A.Nothing", ""), "-");
    EXPECT_EQ(lookedUp(*library, "Nothing", "D"), "-");
    EXPECT_TRUE(library->isDerived("A", "C"));
    EXPECT_TRUE(library->isDerived("C", "B"));
    EXPECT_FALSE(library->isDerived("A", "D"));
}

TEST(Library, ManyWaysToOneBaseAreWalkedOnce) {
    // 2^60 ways lead from the last class to the first.
    std::string text = "model M0 end M0;\n";
    for (int i = 1; i <= 60; ++i) {
        const std::string name = "M" + std::to_string(i), base = "M" + std::to_string(i - 1);
        text += "model " + name + " extends " + base + "; extends " + base + "; end " + name + ";\n";
    }
    const auto library = Library().withSource(sourceOf(text));
    ASSERT_TRUE(library);
    EXPECT_EQ(lookedUp(*library, "Nothing", "M60"), "-");
    EXPECT_TRUE(library->isDerived("M60", "M0"));
}

TEST(Library, ManyTextsGiveWhatOneBehindTheOtherGives) {
    const std::vector<SourcePtr> sources{sourceOf("package P model A end A; model B end B; end P;"),
                                         sourceOf("model C end C;"),
                                         sourceOf("within P; model A model Inner end Inner; end A;"),
                                         sourceOf("model C Real x; end C;"),
                                         sourceOf("within Q; model D end D;"),
                                         sourceOf("package Q model E end E; end Q;")};
    Library behind;
    for (const SourcePtr& source : sources) behind = *behind.withSource(source);
    const auto together = Library().withSources(sources);
    ASSERT_TRUE(together);
    EXPECT_EQ(together->names(), behind.names());
    EXPECT_EQ(together->names(), (std::vector<std::string>{"P", "P.A", "P.A.Inner", "P.B", "C", "Q", "Q.E"}));
    const auto faulty = Library().withSources({sourceOf("model"), sources[0], sourceOf("end")});
    EXPECT_FALSE(faulty);
    EXPECT_EQ(faulty.diagnostics().size(), 2u) << format(faulty.diagnostics());
}

TEST(Library, TimeGrowsWithTheNumberOfTextsAndNotAsItsSquare) {
    const auto secondsOf = [](int count) {
        std::vector<SourcePtr> sources;
        for (int i = 0; i < count; ++i)
            sources.push_back(sourceOf("model M" + std::to_string(i) + " end M" + std::to_string(i) + ";"));
        double least = 1e9;
        for (int repeated = 0; repeated < 3; ++repeated) {
            const std::clock_t begin = std::clock();
            EXPECT_EQ(Library().withSources(sources)->classes().size(), static_cast<std::size_t>(count));
            least = std::min(least, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
        }
        return least;
    };
    EXPECT_LT(secondsOf(8000), 24 * secondsOf(1000)) << "8 times as many";
}

TEST(Library, KnowsWhatDerivesFromWhat) {
    const auto library = Library().withSource(sourceOf(
        "package P partial model Base end Base; model Basic extends Base; end Basic; model Other end Other; end P;\n"
        "model Own extends P.Basic; end Own; model Short = Own(x=1);"));
    ASSERT_TRUE(library);
    EXPECT_TRUE(library->isDerived("Own", "P.Base"));
    EXPECT_TRUE(library->isDerived("Short", "P.Base"));
    EXPECT_TRUE(library->isDerived("P.Base", "P.Base"));
    EXPECT_FALSE(library->isDerived("P.Base", "Own"));
    EXPECT_FALSE(library->isDerived("P.Other", "P.Base"));
    EXPECT_FALSE(library->isDerived("Nothing", "P.Base"));
    EXPECT_FALSE(library->isDerived("Own", "Nothing"));
}

TEST(Library, ASourceReplacesTheClassOfItsName) {
    const auto first = Library().withSource(sourceOf("model A model Old end Old; end A; model B end B;"));
    ASSERT_TRUE(first);
    const auto second = first->withSource(sourceOf("model A \"new\" model New end New; end A;"));
    ASSERT_TRUE(second);
    EXPECT_EQ(second->names(), (std::vector<std::string>{"A", "A.New", "B"}));
    EXPECT_EQ(second->find("A")->definition->description, "new");
    // The library before is what it was, and shares what did not change.
    EXPECT_EQ(first->names(), (std::vector<std::string>{"A", "A.Old", "B"}));
    EXPECT_EQ(first->find("B"), second->find("B"));
}

TEST(Library, ASourceWithinAPackageBelongsToIt) {
    const auto library = Library().withSource(sourceOf("package P model A end A; end P;"));
    const auto extended = library->withSource(sourceOf("within P; model B extends A; end B;"));
    ASSERT_TRUE(extended);
    EXPECT_EQ(found(extended->find("P.B")), "P.B");
    EXPECT_TRUE(extended->isDerived("P.B", "P.A"));
    EXPECT_EQ(lookedUp(*extended, "B", "P.A"), "P.B");
}

TEST(Library, AFaultySourceIsAFaultNotHalfALibrary) {
    const auto library = Library().withSource(sourceOf("model A Real x; end A; model B Real end B;"));
    ASSERT_FALSE(library);
    EXPECT_EQ(library.diagnostics().front().place.file, "m.mo");
    const auto twice = Library().withSource(sourceOf("model A end A; model A end A;"));
    ASSERT_FALSE(twice);
    EXPECT_EQ(twice.diagnostics().front().message, "the class \"A\" is defined twice");
}

TEST(Library, QuotedNamesMayHoldDots) {
    const auto library = Library().withSource(sourceOf("package P package 'a.b' model C end C; end 'a.b'; end P;"));
    ASSERT_TRUE(library) << format(library.diagnostics());
    EXPECT_EQ(lookedUp(*library, "'a.b'.C", "P"), "P.'a.b'.C");
    EXPECT_EQ(lookedUp(*library, "C", "P.'a.b'.C"), "P.'a.b'.C");
}

class BuiltInLibrary : public testing::Test {
protected:
    void SetUp() override {
        if (!fs::exists(builtInLibraryPath() / "Analogon" / "package.mo"))
            GTEST_SKIP() << "no library beside the sources";
    }
};

TEST_F(BuiltInLibrary, HoldsTheBasicClasses) {
    const auto library = builtInLibrary();
    ASSERT_TRUE(library) << format(library.diagnostics());
    EXPECT_TRUE(library.diagnostics().empty()) << format(library.diagnostics());
    for (const char* name :
         {"Analogon.Interfaces.Flange_a", "Analogon.Interfaces.HeatPort_b", "Analogon.Interfaces.RealInput",
          "Analogon.Mechanics.BasicMechanics", "Analogon.ElectricMechanical.BasicElectricMechanical",
          "Analogon.ElectricThermal.BasicElectricThermal", "Analogon.ThermalFluid.BasicThermalFluid",
          "Analogon.MechanicThermal.BasicMechanicThermal", "Analogon.Effects.Thermal.Radiation"}) {
        EXPECT_NE(library->find(name), nullptr) << name;
    }
}

TEST_F(BuiltInLibrary, EveryBaseAndTypeOfItIsFound) {
    const auto library = builtInLibrary();
    ASSERT_TRUE(library);
    for (const LibraryClass* one : library->classes()) {
        if (!one->definition->isShort) {
            EXPECT_EQ(library->bases(*one).size(), one->definition->bases.size()) << one->qualifiedName;
        }
        for (const syntax::Component& component : one->definition->components) {
            const std::string type = component.type.text();
            if (type == "Real" || type == "Integer" || type == "Boolean" || type == "String") continue;
            EXPECT_NE(library->lookup(component.type, one->qualifiedName), nullptr)
                << one->qualifiedName << ": " << type;
        }
    }
}

TEST_F(BuiltInLibrary, IsReadOnceForAllThreads) {
    std::vector<std::thread> threads;
    std::vector<const LibraryClass*> seen(4);
    for (std::size_t i = 0; i < seen.size(); ++i) {
        threads.emplace_back([&seen, i] { seen[i] = builtInLibrary()->find("Analogon"); });
    }
    for (std::thread& thread : threads) thread.join();
    for (const LibraryClass* one : seen) EXPECT_EQ(one, seen[0]);
}

TEST_F(LibraryTest, ADirectoryOfPackagesIsReadByNeed) {
    writePlant();
    write("Broken/package.mo", "within ; package Broken Real x end Broken;");
    write("Single.mo",
          "within ; package Single import Plant.Interfaces.*; import D = Plant.Drives; model B end B; end Single;");
    const auto read = Library().withPath(root_);
    ASSERT_TRUE(read) << format(read.diagnostics());
    EXPECT_TRUE(read->classes().empty());
    EXPECT_EQ(found(read->find("Plant.Drives.Motor.Winding")), "Plant.Drives.Motor.Winding");
    EXPECT_EQ(read->find("Plant.Drives.Motor")->scope, "Plant.Drives");
    EXPECT_EQ(lookedUp(*read, "Interfaces.Port", "Plant.Drives.Motor"), "Plant.Interfaces.Port");
    EXPECT_EQ(lookedUp(*read, "Port", "Single.B"), "Plant.Interfaces.Port");
    EXPECT_EQ(lookedUp(*read, "D.Motor", "Single.B"), "Plant.Drives.Motor");
    EXPECT_EQ(read->find("Plant.Nothing"), nullptr);
    EXPECT_TRUE(read->lazyFaults().empty());
    EXPECT_EQ(read->find("Broken"), nullptr);
    ASSERT_FALSE(read->lazyFaults().empty());
    EXPECT_EQ(read->lazyFaults().front().place.file, (root_ / "Broken/package.mo").string());
    // a value: what is added afterwards sees the same directories
    const auto more = read->withSource(sourceOf("model Own extends Plant.Top; end Own;"));
    ASSERT_TRUE(more);
    EXPECT_TRUE(more->isDerived("Own", "Plant.Top"));
}

TEST_F(LibraryTest, AnOlderNameLeadsToWhatTheClassIsCalledNow) {
    // a library of the names of today, read by need
    write("lib/Modelica/package.mo", "package Modelica end Modelica;");
    write("lib/Modelica/Units.mo", "within Modelica; package Units package SI type Angle = Real; end SI; end Units;");
    const auto library = Library().withPath(root_ / "lib");
    ASSERT_TRUE(library) << format(library.diagnostics());
    const LibraryClass* angle = library->lookup("Modelica.SIunits.Angle", "");
    ASSERT_NE(angle, nullptr);
    EXPECT_EQ(angle->qualifiedName, "Modelica.Units.SI.Angle");
    EXPECT_EQ(library->find("Modelica.SIunits.Length"), nullptr);
}

TEST_F(LibraryTest, WhatANameMeansIsFoundAnewWhereTheStudyHasItsOwn) {
    write("lib/Plant/package.mo",
          "package Plant model Motor Parts.Rotor rotor; Lost.Stator stator; end Motor; end Plant;");
    write("lib/Parts/package.mo", "package Parts model Rotor end Rotor; end Parts;");
    const Library library = Library().withDirectories({root_ / "lib"});
    const auto meaning = [](const Library& in, const char* name) { return in.lookup(name, "Plant.Motor"); };
    for (int k = 0; k < 2; ++k) {
        ASSERT_NE(meaning(library, "Parts.Rotor"), nullptr);
        EXPECT_EQ(meaning(library, "Parts.Rotor")->definition->classes.size(), 0u);
        EXPECT_EQ(meaning(library, "Lost.Stator"), nullptr);
        // another study over the same directories
        const auto own =
            library.withSources({sourceOf("package Parts model Rotor model Inner end Inner; end Rotor; end Parts;"),
                                 sourceOf("package Lost model Stator end Stator; end Lost;")});
        ASSERT_TRUE(own);
        EXPECT_EQ(meaning(*own, "Parts.Rotor")->definition->classes.size(), 1u);
        EXPECT_NE(meaning(*own, "Lost.Stator"), nullptr);
    }
}

TEST_F(LibraryTest, OfSeveralVersionsTheUsedOneIsTaken) {
    for (const char* version : {"3.2.3", "4.0.0", "4.1.0", "10.0.0"})
        write(std::string("Mo ") + version + "/package.mo",
              std::string("within ; package Mo \"") + version + "\" end Mo;");
    const auto versionOf = [&](const std::string& uses) {
        const auto library =
            Library().withDirectories({root_}).withSource(sourceOf("model A annotation (" + uses + "); end A;"));
        return library ? library->find("Mo")->definition->description : std::string();
    };
    EXPECT_EQ(versionOf("uses(Mo(version=\"4.0.0\"))"), "4.0.0");
    EXPECT_EQ(versionOf("uses(Other(version=\"4.0.0\"))"), "10.0.0");
}

TEST_F(BuiltInLibrary, LoadsQuickly) {
    auto best = std::chrono::steady_clock::duration::max();
    for (int run = 0; run < 5; ++run) {
        const auto begin = std::chrono::steady_clock::now();
        const auto library = Library().withPath(builtInLibraryPath() / "Analogon");
        best = std::min(best, std::chrono::steady_clock::now() - begin);
        ASSERT_TRUE(library);
    }
    const double milliseconds = std::chrono::duration<double, std::milli>(best).count();
    RecordProperty("milliseconds", std::to_string(milliseconds));
    EXPECT_LT(milliseconds, 500) << "generous: other work may share the machine";
}

}  // namespace
}  // namespace analogon
