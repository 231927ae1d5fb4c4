#include "core/campaign/slurm/command_run.hpp"

#include <gmock/gmock.h>

#include <chrono>
#include <thread>

namespace analogon {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Optional;

TEST(SplitWords, TakesALineApartAsAShellDoes) {
    EXPECT_THAT(splitWords("--partition=short  --time=60"), Optional(ElementsAre("--partition=short", "--time=60")));
    EXPECT_THAT(splitWords(R"(--comment='a "b"' -J "x \"y\"" z\ z '')"),
                Optional(ElementsAre("--comment=a \"b\"", "-J", "x \"y\"", "z z", "")));
    EXPECT_THAT(splitWords("  "), Optional(IsEmpty()));
    EXPECT_FALSE(splitWords("--comment='two").has_value());
}

TEST(ShellWord, IsOneWordForAShellWhateverItHolds) {
    for (const std::string text : {"a b", "it's", "$HOME `x` \\ \"", ""}) {
        const CommandOutput said = runCommand({"/bin/sh", "-c", "printf %s " + shellWord(text)});
        EXPECT_EQ(said.out, text);
    }
}

TEST(RunCommand, KeepsWhatIsSaidAndHowItEnded) {
    const CommandOutput output = runCommand({"/bin/sh", "-c", "echo out; echo fault >&2; exit 3"});
    EXPECT_EQ(output.status, 3);
    EXPECT_EQ(output.out, "out\n");
    EXPECT_EQ(output.words(), "fault");
    EXPECT_EQ(runCommand({"/bin/sh", "-c", "kill -9 $$"}).status, -1);
    EXPECT_EQ(runCommand({"/nowhere/at/all"}).status, 127);
    EXPECT_EQ(runCommand({"/bin/sh", "-c", "head -c 300000 /dev/zero | tr '\\0' x"}).out.size(), 300000u);
}

TEST(RunCommand, EndsTheProgramWhenTheWorkIsToStop) {
    std::stop_source stop;
    std::jthread stopping([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        stop.request_stop();
    });
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_FALSE(runCommand({"/bin/sleep", "20"}, stop.get_token()).isGood());
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));
}

TEST(ProgramOnPath, IsOneThatCanBeRun) {
    EXPECT_TRUE(programOnPath("sh").has_value());
    EXPECT_FALSE(programOnPath("no-such-program-here").has_value());
}

}  // namespace
}  // namespace analogon
