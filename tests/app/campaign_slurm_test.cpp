/// A campaign on a cluster: against programs that act as Slurm's, and against a real one where tests/slurm/start.sh has
/// started it (ANALOGON_SLURM).
#include <gmock/gmock.h>

#include <chrono>
#include <sstream>
#include <thread>

#include "tests/app/campaign_command_line.hpp"

namespace analogon::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;
using testing::StartsWith;

void pause(int milliseconds) { std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds)); }

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

std::size_t countOf(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; ++at) ++count;
    return count;
}

/// What a campaign on a cluster shares, whichever it is.
class SlurmCommandLine : public CampaignCommandLine {
protected:
    std::vector<std::string> slurmArguments(const std::string& out, std::vector<std::string> more = {}) const {
        std::vector<std::string> arguments{"campaign", at("campaign.json").string(), "--out", at(out).string(),
                                           "--slurm"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return arguments;
    }
    int runSlurm(const std::string& out, std::vector<std::string> more = {}) {
        Process process(slurmArguments(out, std::move(more)), folder_);
        const int status = process.wait();
        said_ = process.out() + process.err();
        return status;
    }
    std::size_t taskCount(const std::string& out) const {
        const std::vector<std::string> lines = linesOf(read(out + "/slurm/units.txt"));
        return lines.empty() ? 0 : std::stoul(lines.back()) + 1;
    }
};

/// Programs on PATH that answer as those of Slurm do (tests/slurm/pretended). What they shall do is in files beside
/// them: `array` (MaxArraySize), `delay` [s] before each task, `lose-N` (a line with an ending for each time that task
/// N is lost), `accounting` (what sacct says), `mine` (what squeue says of this user's jobs), `refuse`, `broken` (no
/// task can begin), `silent` (no answer), `held` (state and reason of all tasks), `cancelled`, `forgetful` (an ended
/// job is not known any more).
class CampaignOnAPretendedCluster : public SlurmCommandLine {
protected:
    void SetUp() override {
        SlurmCommandLine::SetUp();
        fs::copy(root / "tests/slurm/pretended", at("bin"));
        const char* path = std::getenv("PATH");
        path_ = path ? path : "";
        setenv("PATH", (at("bin").string() + ":/usr/bin:/bin").c_str(), 1);
        write("bin/array", "1001");
    }
    void TearDown() override {
        write("bin/cancelled", "");  // tasks that are still to come
        setenv("PATH", path_.c_str(), 1);
        SlurmCommandLine::TearDown();
    }
    std::vector<std::string> calls() const { return linesOf(read("bin/calls")); }

    std::string path_;
};

TEST_F(CampaignOnAPretendedCluster, GivesTheSameTableAsThisMachine) {
    units(7);
    ASSERT_EQ(run("local"), 0) << said_;
    ASSERT_EQ(runSlurm("out"), 0) << said_;
    EXPECT_EQ(read("out/results.csv"), read("local/results.csv"));
    EXPECT_THAT(read("out/slurm/array.sh"), HasSubstr("\n#SBATCH --array=0-6\n"));
    EXPECT_THAT(read("out/slurm/array.sh"), StartsWith("#!/bin/sh\n"));
    EXPECT_THAT(calls(), ElementsAre("--parsable " + at("out/slurm/array.sh").string()));
    EXPECT_THAT(said_, HasSubstr("Slurm job 100: 7 units in 7 tasks"));
    EXPECT_THAT(said_, HasSubstr("7 units: 7 done, 0 failed, 0 waiting"));
    EXPECT_TRUE(fs::exists(at("out/campaign.html")));
    EXPECT_FALSE(fs::exists(at("out/slurm/job.json")));
    EXPECT_THAT(read("out/slurm/output.txt"), IsEmpty());
    ASSERT_EQ(runSlurm("out"), 0) << said_;  // nothing is left to do
    EXPECT_THAT(calls(), SizeIs(1));
}

TEST_F(CampaignOnAPretendedCluster, KeepsToTheSizeThatAnArrayMayHave) {
    units(8);
    write("bin/array", "3");
    ASSERT_EQ(run("local"), 0) << said_;
    ASSERT_EQ(runSlurm("out"), 0) << said_;
    EXPECT_EQ(read("out/results.csv"), read("local/results.csv"));
    EXPECT_THAT(read("out/slurm/array.sh"), HasSubstr("\n#SBATCH --array=0-2\n"));
    EXPECT_THAT(linesOf(read("out/slurm/units.txt")), ElementsAre("0 0 0 U0", "0 0 1 U1", "1 0 2 U2", "1 0 3 U3",
                                                                  "1 0 4 U4", "2 0 5 U5", "2 0 6 U6", "2 0 7 U7"));
}

TEST_F(CampaignOnAPretendedCluster, PassesOptionsToSbatchWordByWord) {
    units(1);
    ASSERT_EQ(runSlurm("one", {"--partition=short --comment='two words'"}), 0) << said_;
    ASSERT_EQ(runSlurm("two", {"--partition=short", "--progress", "none"}), 0) << said_;
    ASSERT_EQ(runSlurm("three", {"--progress", "none"}), 0) << said_;
    EXPECT_THAT(calls(),
                ElementsAre("--parsable --partition=short --comment=two words " + at("one/slurm/array.sh").string(),
                            "--parsable --partition=short " + at("two/slurm/array.sh").string(),
                            "--parsable " + at("three/slurm/array.sh").string()));
    EXPECT_EQ(runSlurm("four", {"--array=0-3"}), 2);
    EXPECT_THAT(said_, HasSubstr("--array is set by the campaign itself"));
    EXPECT_EQ(runSlurm("four", {"--comment='two"}), 2);
    EXPECT_THAT(said_, HasSubstr("a quote is not closed"));
    EXPECT_EQ(runSlurm("four", {"--jobs", "2"}), 2);
    EXPECT_FALSE(fs::exists(at("four")));
}

TEST_F(CampaignOnAPretendedCluster, WorksInFoldersOfAnyName) {
    units(2);
    ASSERT_EQ(run("local"), 0) << said_;
    ASSERT_EQ(runSlurm("it's 100% \"odd\" $here"), 0) << said_;
    EXPECT_EQ(read("it's 100% \"odd\" $here/results.csv"), read("local/results.csv"));
}

TEST_F(CampaignOnAPretendedCluster, SubmitsAgainWhatANodeLost) {
    units(5);
    write("bin/lose-1", "NODE_FAIL\n");
    write("bin/lose-3", "TIMEOUT\n");
    ASSERT_EQ(run("local"), 0) << said_;
    ASSERT_EQ(runSlurm("out"), 0) << said_;
    EXPECT_EQ(read("out/results.csv"), read("local/results.csv"));
    EXPECT_THAT(calls(), SizeIs(2));
    EXPECT_THAT(linesOf(read("out/slurm/units.txt")), ElementsAre("0 1 1 U1", "1 1 3 U3"));
    EXPECT_THAT(said_, HasSubstr("2 tasks of Slurm job 100 ended before their units were done"));
}

TEST_F(CampaignOnAPretendedCluster, GivesAUnitUpAfterThreeTasks) {
    units(3);
    write("bin/lose-0", "NODE_FAIL\nNODE_FAIL\nNODE_FAIL\nNODE_FAIL\n");
    ASSERT_EQ(runSlurm("out"), 0) << said_;
    EXPECT_THAT(calls(), SizeIs(3));
    EXPECT_THAT(read("out/results.csv"), HasSubstr("its task ended 3 times before the unit was done (NODE_FAIL)"));
    EXPECT_THAT(said_, HasSubstr("3 units: 2 done, 1 failed, 0 waiting"));
    fs::remove(at("bin/lose-0"));
    ASSERT_EQ(runSlurm("out"), 0) << said_;
    EXPECT_THAT(calls(), SizeIs(3));
    ASSERT_EQ(runSlurm("out", {"--retry"}), 0) << said_;
    EXPECT_THAT(said_, HasSubstr("3 units: 3 done, 0 failed, 0 waiting"));
}

/// A task works on its units in their order: what it did not come to is not to blame for its end.
TEST_F(CampaignOnAPretendedCluster, CountsTheUnitAtWorkAloneAsLost) {
    units(4);
    write("bin/array", "2");
    write("bin/lose-1", "TIMEOUT\n");
    ASSERT_EQ(runSlurm("out"), 0) << said_;
    EXPECT_THAT(linesOf(read("out/slurm/units.txt")), ElementsAre("0 1 2 U2", "1 0 3 U3"));
}

TEST_F(CampaignOnAPretendedCluster, AsksTheAccountingHowTasksEndedAndElseTheController) {
    units(2);
    const std::string often = "NODE_FAIL\nNODE_FAIL\nNODE_FAIL\n";
    write("bin/lose-0", often);
    write("bin/accounting", "102_0|OUT_OF_MEMORY\n102_[1-4]|PENDING\n");
    ASSERT_EQ(runSlurm("accounted"), 0) << said_;
    EXPECT_THAT(read("accounted/results.csv"), HasSubstr("before the unit was done (OUT_OF_MEMORY)"));
    fs::remove(at("bin/accounting"));
    write("bin/lose-0", often);
    ASSERT_EQ(runSlurm("shown"), 0) << said_;
    EXPECT_THAT(read("shown/results.csv"), HasSubstr("before the unit was done (NODE_FAIL)"));
    write("bin/forgetful", "");
    write("bin/lose-0", often);
    ASSERT_EQ(runSlurm("unknown"), 0) << said_;
    EXPECT_THAT(read("unknown/results.csv"), HasSubstr("before the unit was done\n"));
}

TEST_F(CampaignOnAPretendedCluster, SaysWhatToDoWhereThereIsNoSlurm) {
    units(1);
    fs::remove(at("bin/sbatch"));
    setenv("PATH", at("bin").c_str(), 1);
    EXPECT_EQ(runSlurm("out"), 2);
    EXPECT_THAT(said_, HasSubstr("there is no Slurm here"));
    EXPECT_THAT(said_, HasSubstr("--jobs N"));
    EXPECT_FALSE(fs::exists(at("out")));
}

TEST_F(CampaignOnAPretendedCluster, TellsWhatSbatchSaysAgainstTheJob) {
    units(1);
    write("bin/refuse", "sbatch: error: invalid partition specified: shart\n");
    EXPECT_EQ(runSlurm("out", {"--partition=shart"}), 2);
    EXPECT_THAT(said_, HasSubstr("Slurm does not take the job: sbatch: error: invalid partition specified: shart"));
    fs::remove(at("bin/refuse"));
    EXPECT_EQ(runSlurm("out"), 0) << said_;
}

TEST_F(CampaignOnAPretendedCluster, EndsWhereNoTaskCanBegin) {
    units(3);
    write("bin/broken", "analogon-cli: not found\n");
    EXPECT_EQ(runSlurm("out"), 2);
    EXPECT_THAT(said_, HasSubstr("the tasks of Slurm job 100 could not begin: analogon-cli: not found"));
    EXPECT_THAT(calls(), SizeIs(1));
    fs::remove(at("bin/broken"));
    EXPECT_EQ(runSlurm("out"), 0) << said_;
    EXPECT_THAT(said_, HasSubstr("3 units: 3 done, 0 failed, 0 waiting"));
}

TEST_F(CampaignOnAPretendedCluster, SubmitsNoFurtherJobWhenThatOneIsCancelled) {
    units(4);
    write("bin/delay", "1");
    Process process(slurmArguments("out"), folder_);
    while (records("out").empty()) pause(5);
    write("bin/cancelled", "");
    EXPECT_EQ(process.wait(), 130);
    EXPECT_THAT(process.err(), HasSubstr("Slurm job 100 was cancelled"));
    EXPECT_THAT(process.out(), Not(HasSubstr(" 0 waiting")));
    fs::remove(at("bin/cancelled"));
    write("bin/delay", "0");
    ASSERT_EQ(runSlurm("out"), 0) << said_;
    EXPECT_THAT(said_, HasSubstr("4 units: 4 done, 0 failed, 0 waiting"));
}

TEST_F(CampaignOnAPretendedCluster, LeavesTheJobAtWorkWhenItIsInterruptedAndFollowsItAgain) {
    units(5);
    ASSERT_EQ(run("local"), 0) << said_;
    write("bin/delay", "0.7");
    for (const bool isKilled : {false, true}) {
        const std::string out = isKilled ? "killed" : "interrupted";
        fs::remove(at("bin/calls"));
        Process process(slurmArguments(out), folder_);
        while (records(out).empty()) pause(5);
        const auto begin = std::chrono::steady_clock::now();
        isKilled ? process.end() : process.interrupt();
        EXPECT_EQ(process.wait(), isKilled ? -1 : 130);
        EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(600));  // the machine may be busy
        if (!isKilled) {
            EXPECT_THAT(process.err(), HasSubstr("Slurm job 100 works on; \"scancel 100\" ends it"));
        }
        EXPECT_EQ(run(out), 2);  // on this machine, meanwhile
        EXPECT_THAT(said_, HasSubstr("works on this campaign"));
        const auto before = records(out);
        ASSERT_EQ(runSlurm(out), 0) << said_;
        EXPECT_THAT(said_, HasSubstr("of an earlier run is followed"));
        EXPECT_THAT(calls(), SizeIs(1));
        for (const auto& [unit, time] : before) EXPECT_EQ(records(out).at(unit), time) << unit;
        EXPECT_EQ(read(out + "/results.csv"), read("local/results.csv"));
    }
}

TEST_F(CampaignOnAPretendedCluster, FindsAJobWhoseNumberItDidNotComeToKeep) {
    units(4);
    write("bin/delay", "0.7");
    Process process(slurmArguments("out"), folder_);
    while (records("out").empty()) pause(5);
    process.end();
    process.wait();
    write("out/slurm/job.json", R"({"format": "analogon-slurm-1", "job": "", "cluster": ""})");
    write("bin/mine", "99 /home/engineer/job.sh\n100 " + at("out/slurm/array.sh").string() + "\n");
    ASSERT_EQ(runSlurm("out"), 0) << said_;
    EXPECT_THAT(said_, HasSubstr("Slurm job 100 of an earlier run is followed"));
    EXPECT_THAT(said_, HasSubstr("4 units: 4 done, 0 failed, 0 waiting"));
    EXPECT_THAT(calls(), SizeIs(1));
}

TEST_F(CampaignOnAPretendedCluster, WaitsForASlurmThatDoesNotAnswer) {
    units(3);
    write("bin/delay", "0.3");
    Process process(slurmArguments("out"), folder_);
    while (records("out").empty()) pause(5);
    write("bin/silent", "");
    pause(1500);
    EXPECT_FALSE(process.poll().has_value());
    EXPECT_EQ(countOf(process.err(), "Slurm does not answer"), 1u) << process.err();
    fs::remove(at("bin/silent"));
    EXPECT_EQ(process.wait(), 0);
    EXPECT_THAT(process.out(), HasSubstr("3 units: 3 done, 0 failed, 0 waiting"));
}

TEST_F(CampaignOnAPretendedCluster, TellsOnceWhyTheJobWaits) {
    units(2);
    write("bin/delay", "1");
    write("bin/held", "PENDING|PartitionDown");
    ASSERT_EQ(runSlurm("out"), 0) << said_;
    EXPECT_EQ(countOf(said_, "Slurm job 100 waits: PartitionDown\n"), 1u) << said_;
    write("bin/held", "PENDING|Resources");
    ASSERT_EQ(runSlurm("other"), 0) << said_;
    EXPECT_THAT(said_, Not(HasSubstr("waits")));
}

TEST_F(CampaignOnAPretendedCluster, LosesNothingTwiceWhereATaskIsStartedAnew) {
    units(4);
    ASSERT_EQ(runSlurm("out"), 0) << said_;
    const auto before = records("out");
    write("out/slurm/job.json", R"({"format": "analogon-slurm-1", "job": "100", "cluster": ""})");
    for (const char* task : {"0", "1", "2", "3"}) {
        Process process({"campaign-task", at("campaign.json").string(), "--out", at("out").string(), "--task", task},
                        folder_);
        EXPECT_EQ(process.wait(), 0) << process.err();
    }
    EXPECT_EQ(records("out"), before);
}

/// A Slurm of one controller and two nodes on this machine.
class CampaignOnSlurm : public SlurmCommandLine {
protected:
    void SetUp() override {
        const char* folder = std::getenv("ANALOGON_SLURM");
        if (!folder) GTEST_SKIP() << "no Slurm here: tests/slurm/start.sh starts one and this test with it";
        slurm_ = folder;
        SlurmCommandLine::SetUp();
    }
    void TearDown() override {
        if (!slurm_.empty()) SlurmCommandLine::TearDown();
    }
    pid_t daemon(const std::string& name) const {
        pid_t process = 0;
        std::ifstream(slurm_ / (name + ".pid")) >> process;
        return process;
    }
    static void begin(const std::string& what) {
        const std::string line = "\"$ANALOGON_SLURM_START\" " + what;
        EXPECT_EQ(std::system(line.c_str()), 0);
    }
    /// The daemon of a node with all that runs there, and the tasks among it.
    std::pair<std::vector<pid_t>, std::vector<std::string>> runningOn(const std::string& node) const {
        std::vector<pid_t> processes{daemon(node)};
        std::vector<std::string> tasks;
        for (const auto& entry : fs::directory_iterator("/proc")) {
            const std::string name = entry.path().filename();
            if (name.find_first_not_of("0123456789") != std::string::npos) continue;
            const std::string environment = contentOf(entry.path() / "environ");
            if (environment.find("SLURMD_NODENAME=" + node + '\0') == std::string::npos ||
                environment.find("SLURM_CONF=" + slurm_.string()) == std::string::npos)
                continue;
            processes.push_back(std::stoi(name));
            const std::string words = contentOf(entry.path() / "cmdline"), mark = std::string("--task") + '\0';
            if (const std::size_t at = words.find(mark); at != std::string::npos)
                tasks.emplace_back(words.substr(at + mark.size()).c_str());
            const std::string status = contentOf(entry.path() / "status");
            if (status.find("\nPPid:") == std::string::npos) continue;
            const pid_t parent = std::stoi(status.substr(status.find("\nPPid:") + 6));
            if (contentOf("/proc/" + std::to_string(parent) + "/comm").starts_with("slurmstepd"))
                processes.push_back(parent);
        }
        return {processes, tasks};
    }
    /// As if the power of the node failed, while it works on a unit that is not done. False: it works on none.
    bool killNode(const std::string& node, const std::string& out) const {
        const auto [processes, tasks] = runningOn(node);
        for (const pid_t process : processes) kill(process, SIGSTOP);
        const bool isAtWork = !tasks.empty() && !records(out).contains("U" + tasks.front());
        for (const pid_t process : processes) kill(process, isAtWork ? SIGKILL : SIGCONT);
        return isAtWork;
    }
    /// Until a process has ended: no record changes once it is there.
    int waitAndWatch(Process& process, const std::string& out) {
        for (;; pause(30)) {
            const std::optional<int> status = process.poll();
            for (const auto& [unit, time] : records(out))
                if (const auto [known, isNew] = known_.emplace(unit, time); !isNew) {
                    EXPECT_EQ(known->second, time) << unit << " was worked on twice";
                }
            if (status) return *status;
        }
    }

    void loseANode(const std::vector<std::string>& options) {
        units(40);
        ASSERT_EQ(run("local"), 0) << said_;
        Process process(slurmArguments("out", options), folder_);
        while (records("out").size() < 6) pause(5);
        while (!killNode("node2", "out")) {
            ASSERT_LT(records("out").size(), 40u);
            pause(5);
        }
        EXPECT_EQ(waitAndWatch(process, "out"), 0) << process.err();
        EXPECT_THAT(process.out(), HasSubstr("40 units: 40 done, 0 failed, 0 waiting"));
        EXPECT_EQ(read("out/results.csv"), read("local/results.csv"));
        begin("node 2");
    }

    fs::path slurm_;
    std::map<std::string, fs::file_time_type> known_;
};

TEST_F(CampaignOnSlurm, GivesTheSameTableAsThisMachine) {
    units(12);
    ASSERT_EQ(run("local"), 0) << said_;
    ASSERT_EQ(runSlurm("out", {"--nice=1 --time=10"}), 0) << said_;
    EXPECT_EQ(read("out/results.csv"), read("local/results.csv"));
    EXPECT_EQ(taskCount("out"), 12u);
}

TEST_F(CampaignOnSlurm, LosesNothingAndDoesNothingTwiceWhenANodeFails) {
    loseANode({"--no-requeue"});
    EXPECT_THAT(linesOf(read("out/slurm/units.txt")), SizeIs(testing::Lt(40u)));  // what was submitted again
}

/// Slurm starts such tasks anew itself, after two minutes.
TEST_F(CampaignOnSlurm, LosesNothingAndDoesNothingTwiceWhenSlurmStartsTheTasksOfANodeAnew) {
    loseANode({});
    EXPECT_THAT(linesOf(read("out/slurm/units.txt")), SizeIs(40));
}

TEST_F(CampaignOnSlurm, LosesNothingAndDoesNothingTwiceWhenProgramAndControllerAreKilled) {
    units(40);
    ASSERT_EQ(run("local"), 0) << said_;
    {
        Process process(slurmArguments("out"), folder_);
        while (records("out").size() < 4) pause(5);
        process.end();
        process.wait();
    }
    Process process(slurmArguments("out"), folder_);
    while (records("out").size() < 10) pause(5);
    kill(daemon("controller"), SIGKILL);
    pause(1500);
    begin("controller");
    // Slurm drains nodes that still have what a controller without its last state starts anew
    std::jthread operatorOfTheCluster([](const std::stop_token& stop) {
        for (; !stop.stop_requested(); pause(2000)) begin("resume");
    });
    EXPECT_EQ(waitAndWatch(process, "out"), 0) << process.err();
    EXPECT_THAT(process.err(), HasSubstr("of an earlier run is followed"));
    EXPECT_EQ(read("out/results.csv"), read("local/results.csv"));
}

}  // namespace
}  // namespace analogon::cli
