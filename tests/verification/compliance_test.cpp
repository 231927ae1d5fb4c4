#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <optional>
#include <set>

#include "core/eval/event_parts.hpp"
#include "core/eval/system.hpp"
#include "core/flat/flat_model.hpp"
#include "core/library/library.hpp"
#include "core/simulate/event_run.hpp"
#include "core/structure/hybrid.hpp"

/// The test cases of the Modelica Association's compliance library (package ModelicaCompliance): each says whether it
/// is sound Modelica, and what is sound asserts its own results. Where they lie is told by ANALOGON_COMPLIANCE: the
/// directory that holds the package. A case is judged right when what is sound runs without a fault for a second, and
/// what is not is refused.
namespace analogon {
namespace {

namespace fs = std::filesystem;

/// What the contract refuses, by the names of the library.
constexpr std::array refusedChapters{"Connections.Stream",     "Connections.Overconstrained",
                                     "Connections.Expandable", "OperatorOverloading",
                                     "StateMachines",          "Synchronous",
                                     "Operators.Overloading"};

struct Case {
    std::string name;
    bool isSound{};
};

std::optional<bool> saysSound(const LibraryClass& of) {
    const auto& annotation = of.definition->annotation;
    const syntax::Modification* const association = annotation ? annotation->find("__ModelicaAssociation") : nullptr;
    if (!association) return std::nullopt;
    for (const syntax::Modification& test : association->arguments)
        for (const syntax::Modification& said : test.arguments)
            if (said.name.text() == "shouldPass" && said.value) return said.value->number != 0;
    return std::nullopt;
}

/// Every file of the package whose class says whether it is sound, by the name that its place gives it.
std::vector<Case> casesOf(const Library& library, const fs::path& root) {
    std::vector<Case> cases;
    for (const auto& entry : fs::recursive_directory_iterator(root / "ModelicaCompliance")) {
        const fs::path& file = entry.path();
        if (file.extension() != ".mo" || file.filename() == "package.mo") continue;
        std::string name;
        const fs::path inside = fs::relative(file, root).replace_extension();
        for (const fs::path& part : inside) name += (name.empty() ? "" : ".") + part.string();
        const LibraryClass* const definition = library.find(name);
        const auto isSound = definition ? saysSound(*definition) : std::nullopt;
        if (isSound) cases.push_back({name, *isSound});
        // a file that cannot be read at all holds what is no Modelica
        else if (!definition && std::string(file.stem()).find("Illegal") != std::string::npos)
            cases.push_back({name, false});
    }
    std::sort(cases.begin(), cases.end(), [](const Case& a, const Case& b) { return a.name < b.name; });
    return cases;
}

Diagnostics faultsOf(const Library& library, const std::string& name) {
    const Outcome<FlatModel> flat = flatten(library, name);
    if (!flat) return flat.diagnostics();
    const Outcome<HybridModel> hybrid = partition(*flat);
    if (!hybrid) return hybrid.diagnostics();
    const Outcome<SystemPtr> system = systemBetween(*hybrid);
    if (!system) return system.diagnostics();
    EventRunOptions options;
    options.secondsLimit = 10;
    const Outcome<EventTrajectory> run = simulateWithEvents(*hybrid, **system, {}, options);
    return run ? Diagnostics() : run.diagnostics();
}

TEST(Compliance, TheCasesOfTheModelicaAssociationAreJudgedRight) {
    const char* const place = std::getenv("ANALOGON_COMPLIANCE");
    if (!place || !fs::exists(fs::path(place) / "ModelicaCompliance" / "package.mo"))
        GTEST_SKIP() << "ANALOGON_COMPLIANCE does not name the directory that holds ModelicaCompliance";
    const Library library = Library().withDirectories({place});
    struct Count {
        int right{}, all{};
        bool isRefused{};
    };
    std::map<std::string, Count> chapters;
    Count total;
    for (const Case& one : casesOf(library, place)) {
        const std::string within = one.name.substr(one.name.find('.') + 1);
        const auto second = within.find('.', within.find('.') + 1);
        Count& chapter = chapters[within.substr(0, second)];
        chapter.isRefused = std::any_of(refusedChapters.begin(), refusedChapters.end(),
                                        [&](std::string_view refused) { return within.starts_with(refused); });
        const Diagnostics faults = faultsOf(library, one.name);
        const bool isRight = one.isSound == faults.empty();
        for (Count* const count : {&chapter, &total}) {
            if (count == &total && chapter.isRefused) continue;
            count->right += isRight ? 1 : 0;
            ++count->all;
        }
        if (!isRight)
            std::cout << fmt::format("wrong {} {}: {}\n", one.isSound ? "refused " : "accepted", one.name,
                                     faults.empty() ? std::string() : faults.front().message.english())
                      << std::flush;
    }
    for (const auto& [name, count] : chapters)
        std::cout << fmt::format("{:40} {:4} of {:4} right{}\n", name, count.right, count.all,
                                 count.isRefused ? "  (refused by the contract)" : "");
    std::cout << fmt::format("{:40} {:4} of {:4} right\n", "without what is refused", total.right, total.all);
    constexpr double least = 0.9;
    EXPECT_GE(total.right, least * total.all);
}

}  // namespace
}  // namespace analogon
