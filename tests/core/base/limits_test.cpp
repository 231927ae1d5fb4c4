#include "core/base/limits.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace analogon {
namespace {

/// A machine of a thousand MiB.
class Limits : public ::testing::Test {
protected:
    void SetUp() override { setenv("ANALOGON_MEMORY", "1000", 1); }
    void TearDown() override { unsetenv("ANALOGON_MEMORY"); }

    static void expectRefused(const Outcome<Done>& refused, const char* message, const char* hint) {
        ASSERT_FALSE(refused);
        EXPECT_EQ(refused.diagnostics().front().message, message);
        EXPECT_EQ(refused.diagnostics().front().hint, hint);
    }
};

TEST_F(Limits, SayHowMuchMemoryAStageWouldTake) {
    EXPECT_EQ(limits::memory(), 1000u << 20);
    EXPECT_TRUE(limits::checkMemory("the stage", 500e6, "Take less."));
    expectRefused(limits::checkMemory("the stage", 2e9, "Take less."),
                  "the stage would take 1.86 GB of memory, of 0.977 GB that the machine has", "Take less.");
    unsetenv("ANALOGON_MEMORY");
    EXPECT_GT(limits::memory(), 100u << 20);
}

TEST_F(Limits, EachStageHasAMessageAndARemedy) {
    EXPECT_TRUE(limits::checkTable(1e6, 50, 50e6, 300e6));
    expectRefused(limits::checkTable(1e6, 200, 200e6, 1e9),
                  "the table of 1e+06 rows and 200 columns would take 2.42 GB of memory, of 0.977 GB that the machine "
                  "has",
                  "Export fewer channels, or a part of the recording.");
    EXPECT_TRUE(limits::checkTraces(1e6, 4, 20));
    expectRefused(limits::checkTraces(1e7, 4, 20),
                  "the traces of 4 inputs and 20 outputs over 1e+07 samples would take 4.77 GB of memory, of 0.977 GB "
                  "that the machine has",
                  "Use a part of the recordings (\"range\"), fewer of their rows, or fewer outputs of the model.");
    EXPECT_TRUE(limits::checkSlopes(1e6, 80));
    expectRefused(limits::checkSlopes(1e7, 80),
                  "the slopes of 1e+07 measured values along 80 parameters would take 6.03 GB of memory, of 0.977 GB "
                  "that the machine has",
                  "Use a part of the recordings (\"range\"), fewer of their rows, or fit fewer parameters.");
    EXPECT_TRUE(limits::checkExpressions(1'000'000, 100));
    expectRefused(limits::checkExpressions(10'000'000, 100),
                  "the 10000000 expressions of the model would take 0.931 GB of memory, of 0.977 GB that the machine "
                  "has",
                  "Shorten the longest equations and loops, or give intermediate results names of their own.");
}

}  // namespace
}  // namespace analogon
