/// A campaign as its own process: what it leaves, what ends it, and what the next run does.
#include <gmock/gmock.h>

#include <chrono>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>
#include <thread>

#include "core/base/owned_directory.hpp"
#include "core/base/whole_file.hpp"
#include "tests/app/campaign_command_line.hpp"

namespace analogon::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST_F(CampaignCommandLine, LeavesARowAndAReportOfEachUnitWhateverTheNumberOfJobs) {
    units(5);
    ASSERT_EQ(run("one", 1), 0) << said_;
    ASSERT_EQ(run("three", 3), 0) << said_;
    const std::string table = read("one/results.csv");
    EXPECT_EQ(read("three/results.csv"), table);
    EXPECT_THAT(table, HasSubstr("unit,state,finding,effects,error_before [%],error_after [%]"));
    EXPECT_THAT(table, HasSubstr(",T [s],T.std [s],k [1],k.std [1],supplier,seconds,fault\nU0,done,"));
    for (const char* file : {"report.json", "report.html", "traces.csv", "study/study.json", "unit.json"})
        EXPECT_TRUE(fs::exists(at("one") / "units/U3" / file)) << file;
    EXPECT_THAT(read("one/campaign.json"), HasSubstr("\"U4\": {\"state\":\"done\""));
}

TEST_F(CampaignCommandLine, LosesOneUnitForOneThatIsFaulty) {
    units(3);
    fs::remove(at("U1.csv"));
    write("units.csv", read("units.csv") + "../x,U0.csv,A\n");
    ASSERT_EQ(run("out"), 0) << said_;
    EXPECT_THAT(read("out/results.csv"), HasSubstr("U1,failed,"));
    EXPECT_THAT(read("out/results.csv"), HasSubstr("there is no recording"));
    EXPECT_THAT(read("out/results.csv"), HasSubstr("U2,done,"));
    EXPECT_THAT(read("out/campaign.json"), HasSubstr("\"../x\": {\"state\":\"failed\""));
    EXPECT_FALSE(fs::exists(at("out/x")));
}

TEST_F(CampaignCommandLine, WritesNothingWhereTheCampaignIsFaulty) {
    units(2);
    campaign(R"({"unit": "serial", "files": {"stop": "file"}})");
    EXPECT_EQ(run("out"), 2);
    EXPECT_THAT(said_, HasSubstr("the study has no experiment \"stop\""));
    EXPECT_FALSE(fs::exists(at("out")));
}

TEST_F(CampaignCommandLine, TellsWhatACampaignIsWhereSomethingElseIsGiven) {
    units(1);
    for (const char* given : {"lag/study.json", "lag"}) {
        Process process({"campaign", at(given).string(), "--out", at("out").string()}, folder_);
        EXPECT_EQ(process.wait(), 2) << given;
        EXPECT_THAT(process.err(), HasSubstr("names a study and a table of units")) << given;
        EXPECT_THAT(process.err(), Not(HasSubstr("columns"))) << "one message, not one for each member";
    }
    EXPECT_EQ(run("out", 0), 2);
    EXPECT_THAT(said_, HasSubstr("--jobs: a number above 0 is expected, not \"0\""));
}

/// Units that fail, and those of a run before, are told in lines that a program can read, too.
TEST_F(CampaignCommandLine, TellsItsProgressAsOneObjectALine) {
    units(3);
    fs::remove(at("U1.csv"));
    std::string notes;
    for (int times = 0; times < 2; ++times) {
        std::vector<std::string> words = arguments("out");
        words.insert(words.end(), {"--progress", "json"});
        Process process(words, folder_);
        ASSERT_EQ(process.wait(), 0) << process.err();
        std::istringstream lines(process.err());
        for (std::string line; std::getline(lines, line);) {
            const nlohmann::json json = nlohmann::json::parse(line, nullptr, false);
            ASSERT_TRUE(json.is_object()) << line;
            if (!json.contains("note")) continue;
            const std::string pattern = json.at("pattern");
            notes += json.at("note").get<std::string>() + " | " + pattern + " | " + json.at("arguments").dump() + "\n";
        }
    }
    EXPECT_THAT(notes, HasSubstr("failed: U1: "));
    EXPECT_THAT(notes, HasSubstr("2 units are done already | {} units are done already | [\"2\"]"));
}

TEST_F(CampaignCommandLine, TouchesNoDirectoryThatIsNotACampaigns) {
    units(1);
    EXPECT_EQ(run("."), 2);
    EXPECT_THAT(said_, HasSubstr("something else than a campaign's results"));
    EXPECT_FALSE(fs::exists(at("results.csv")));
}

TEST_F(CampaignCommandLine, WorksAgainOnWhatChangedAndOnNothingElse) {
    units(4);
    ASSERT_EQ(run("out"), 0) << said_;
    const auto before = records("out");
    record("U2.csv", 4, 0.9);
    ASSERT_EQ(run("out"), 0) << said_;
    EXPECT_THAT(said_, HasSubstr("1 unit has changed since it was worked on"));
    const auto after = records("out");
    for (const auto& [unit, time] : before) EXPECT_EQ(after.at(unit) == time, unit != "U2") << unit;
}

TEST_F(CampaignCommandLine, EndsWithinAFifthOfASecondWhenInterruptedAndGoesOn) {
    units(40);
    ASSERT_EQ(run("whole"), 0) << said_;
    Process process(arguments("out", 1), folder_);
    while (records("out").size() < 3) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    const auto begin = std::chrono::steady_clock::now();
    process.interrupt();
    EXPECT_EQ(process.wait(), 130);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(600));  // the machine may be busy
    EXPECT_THAT(process.err(), HasSubstr("goes on where it was"));
    const auto before = records("out");
    EXPECT_LT(before.size(), 40u);
    ASSERT_EQ(run("out"), 0) << said_;
    const auto after = records("out");
    EXPECT_EQ(after.size(), 40u);
    for (const auto& [unit, time] : before) EXPECT_EQ(after.at(unit), time) << unit;
    EXPECT_EQ(read("out/results.csv"), read("whole/results.csv"));
}

/// As often as ANALOGON_KILLS says.
TEST_F(CampaignCommandLine, LosesNothingAndDoesNothingTwiceWhenItIsKilled) {
    units(24);
    ASSERT_EQ(run("whole"), 0) << said_;
    const char* wanted = std::getenv("ANALOGON_KILLS");
    std::mt19937 random(5);
    std::map<std::string, fs::file_time_type> known;
    for (int kills = wanted ? std::atoi(wanted) : 8; kills > 0; --kills) {
        if (known.size() == 24) {
            fs::remove_all(at("out"));
            known.clear();
        }
        Process process(arguments("out"), folder_);
        std::this_thread::sleep_for(std::chrono::milliseconds(50 + random() % 400));
        process.end();
        process.wait();
        std::this_thread::sleep_for(std::chrono::milliseconds(60));  // its workers end with it
        const auto now = records("out");
        for (const auto& [unit, time] : known) {
            ASSERT_TRUE(now.contains(unit)) << unit;
            EXPECT_EQ(now.at(unit), time) << unit;
        }
        known = now;
    }
    ASSERT_EQ(run("out"), 0) << said_;
    for (const auto& [unit, time] : known) EXPECT_EQ(records("out").at(unit), time) << unit;
    EXPECT_EQ(read("out/results.csv"), read("whole/results.csv"));
    for (const auto& entry : fs::recursive_directory_iterator(at("out")))
        EXPECT_THAT(entry.path().filename().string(), Not(HasSubstr(".analogon-results-")));
}

TEST_F(CampaignCommandLine, GoesOnWhereItWasKilledBeforeItsStateWasWritten) {
    units(4);
    fs::create_directories(at("out"));
    Outcome<OwnedDirectory> left = OwnedDirectory::make(at("out"), writingPrefix);
    ASSERT_TRUE(left);
    EXPECT_NE(run("out"), 0) << "somebody writes there";
    left->release();
    ASSERT_EQ(run("out"), 0) << said_;
    std::ofstream(at("out") / "foreign.txt") << "mine";
    fs::remove(at("out") / "campaign.json");
    EXPECT_NE(run("out"), 0);
    EXPECT_EQ(read("out/foreign.txt"), "mine");
}

/// The processes that a process has started, from /proc.
std::vector<pid_t> childrenOf(pid_t parent) {
    std::vector<pid_t> children;
    std::ifstream list("/proc/" + std::to_string(parent) + "/task/" + std::to_string(parent) + "/children");
    for (pid_t child; list >> child;) children.push_back(child);
    return children;
}

TEST_F(CampaignCommandLine, LosesTheUnitsAtWorkWhenTheirProcessesCrash) {
    units(60);
    Process process(arguments("out", 1), folder_);
    while (records("out").size() < 5) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    for (const pid_t worker : childrenOf(process.id())) kill(worker, SIGSEGV);
    EXPECT_EQ(process.wait(), 0);
    const std::string table = read("out/results.csv");
    EXPECT_THAT(process.out(), HasSubstr("60 units: "));
    std::size_t failed = 0;
    for (std::size_t at = 0; (at = table.find(",failed,", at)) != std::string::npos; ++at) ++failed;
    EXPECT_LE(failed, 1u);  // none where it was between two units
    EXPECT_EQ(table.find(",waiting,"), std::string::npos);
    if (failed == 1) {
        EXPECT_THAT(table, HasSubstr("signal 11"));
    }
}

}  // namespace
}  // namespace analogon::cli
