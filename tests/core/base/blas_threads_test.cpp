#include "core/base/blas_threads.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace analogon {
namespace {

using testing::ElementsAre;

std::optional<std::vector<std::string>> changed(std::vector<std::string> entries) {
    std::vector<char*> environment;
    for (std::string& entry : entries) environment.push_back(entry.data());
    environment.push_back(nullptr);
    return withOneBlasThread(environment.data());
}

TEST(BlasThreads, AreOneWhereNobodyAskedForANumber) {
    EXPECT_THAT(changed({}).value(), ElementsAre("OPENBLAS_NUM_THREADS=1"));
    EXPECT_THAT(changed({"A=1", "B="}).value(), ElementsAre("A=1", "B=", "OPENBLAS_NUM_THREADS=1"));
    EXPECT_THAT(changed({"OPENBLAS_NUM_THREADS=", "A=1"}).value(), ElementsAre("A=1", "OPENBLAS_NUM_THREADS=1"));
    EXPECT_THAT(changed({"OPENBLAS_NUM_THREADS=0"}).value(), ElementsAre("OPENBLAS_NUM_THREADS=1"));
}

TEST(BlasThreads, AreAsManyAsWasAskedFor) {
    EXPECT_FALSE(changed({"A=1", "OPENBLAS_NUM_THREADS=4"}));
    EXPECT_FALSE(changed({"OPENBLAS_NUM_THREADS=1"}));
}

}  // namespace
}  // namespace analogon
