#include "core/study/study_with.hpp"

#include <gtest/gtest.h>

namespace analogon {
namespace {

TEST(StudyWithLibraries, HasThemBehindItsOwnWhereTheyLie) {
    Study study;
    study.libraryPaths = {"own"};
    const Study widened = withLibraries(study, {"more", "/lib"});
    EXPECT_EQ(widened.libraryPaths,
              (std::vector<std::string>{"own", (std::filesystem::current_path() / "more").string(), "/lib"}));
}

TEST(FreeExperimentName, IsTheWantedOneOrNumbered) {
    Study study;
    EXPECT_EQ(freeExperimentName(study, "run"), "run");
    for (const char* name : {"run", "run 2"}) study.experiments.emplace_back().name = name;
    EXPECT_EQ(freeExperimentName(study, "run"), "run 3");
}

}  // namespace
}  // namespace analogon
