#include "app/analogon-cli/interrupt.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>
#include <thread>

#include "app/analogon-cli/command_line.hpp"
#include "tests/app/interrupt_studies.hpp"

namespace analogon::cli {
namespace {

namespace fs = std::filesystem;
using std::chrono::milliseconds;
using testing::HasSubstr;

const fs::path root = ANALOGON_ROOT;

std::string contentOf(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

double secondsOf(const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// The program as its own process.
class Process {
public:
    Process(const std::vector<std::string>& arguments, const fs::path& scratch) : err_(scratch / "stderr.txt") {
        fs::create_directories(scratch);
        fs::remove(err_);  // what another process has said there would pass for its own
        std::vector<char*> argv{const_cast<char*>(ANALOGON_CLI)};
        for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
        argv.push_back(nullptr);
        id_ = fork();
        if (id_ != 0) return;
        // a shell that starts the tests in the background has them ignore it, and the program keeps to that
        for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_DFL);
        dup2(open("/dev/null", O_WRONLY), STDOUT_FILENO);
        dup2(open(err_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644), STDERR_FILENO);
        execv(ANALOGON_CLI, argv.data());
        _exit(127);
    }
    ~Process() {
        if (isOver_) return;
        kill(id_, SIGKILL);
        wait();
    }

    void send(int signal) const { kill(id_, signal); }
    /// Processor time so far [s], of all threads.
    double work() const {
        clockid_t clock{};
        timespec time{};
        if (clock_getcpuclockid(id_, &clock) != 0 || clock_gettime(clock, &time) != 0) return 0;
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    }
    bool isOver() {
        if (isOver_) return true;
        rusage used{};
        isOver_ = wait4(id_, &status_, WNOHANG, &used) == id_;
        if (isOver_) allWork_ = secondsOf(used.ru_utime) + secondsOf(used.ru_stime);
        return isOver_;
    }
    /// Until it has worked for so long, or is over: whether it is still at work.
    bool awaitWork(double seconds) {
        while (!isOver() && work() < seconds) std::this_thread::sleep_for(milliseconds(1));
        return !isOver();
    }
    /// The exit status; -1: a signal ended it, as before the program has begun to listen.
    int wait() {
        rusage used{};
        if (!isOver_) wait4(id_, &status_, 0, &used);
        if (!isOver_) allWork_ = secondsOf(used.ru_utime) + secondsOf(used.ru_stime);
        isOver_ = true;
        return WIFEXITED(status_) ? WEXITSTATUS(status_) : -1;
    }
    double allWork() const { return allWork_; }
    std::string err() const { return contentOf(err_); }
    /// Until the program has told that it is there, or is over.
    void awaitStage(const std::string& stage) {
        while (!isOver() && err().find("\"stage\":\"" + stage) == std::string::npos)
            std::this_thread::sleep_for(milliseconds(5));
    }

private:
    fs::path err_;
    pid_t id_{};
    int status_{};
    bool isOver_{};
    double allWork_{};
};

/// What was seen of the interrupts: how long the program was at work after each.
struct Seen {
    std::string what;
    double work{}, waited{};  // [s] of a processor, and by the clock
};

class Interrupts : public testing::Test {
protected:
    void SetUp() override {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        scratch = fs::temp_directory_path() / fmt::format("analogon-interrupt-test-{}", getpid()) / info->name();
        fs::create_directories(scratch);
    }
    void TearDown() override { fs::remove_all(scratch.parent_path()); }

    /// What it reports is what was found until then, and nothing that was not looked at.
    void expectHonest(const fs::path& out, const std::string& command) const {
        const auto report = nlohmann::json::parse(contentOf(out / "report.json"));
        EXPECT_TRUE(report.at("interrupted").get<bool>());
        if (command != "discover") return;
        const std::string finding = report.at("finding");
        EXPECT_TRUE(finding == "interrupted" || finding == "partial" || finding == "effect") << finding;
        EXPECT_EQ(finding == "interrupted", report.at("effects").empty());
        EXPECT_TRUE(fs::exists(out / "study" / "study.json"));
    }

    /// For people: how long the interrupted runs took to end.
    static void tell(std::vector<Seen> seen, int runs, int told) {
        std::sort(seen.begin(), seen.end(), [](const Seen& a, const Seen& b) { return a.work < b.work; });
        const auto at = [&](double part) {
            return seen[static_cast<std::size_t>(part * static_cast<double>(seen.size() - 1))];
        };
        std::printf(
            "%zu of %d runs were interrupted, %d of them told what they had found; processor time until the end: "
            "%.3f s of half, %.3f s of 99 %%, %.3f s at most (%s; %.3f s by the clock)\n",
            seen.size(), runs, told, at(0.5).work, at(0.99).work, seen.back().work, seen.back().what.c_str(),
            seen.back().waited);
    }

    fs::path scratch;
};

/// What a command does on a study, as often as it is asked.
class InterruptedCommand {
public:
    InterruptedCommand(std::string command, fs::path study, fs::path scratch)
        : command_(std::move(command)), study_(std::move(study)), scratch_(std::move(scratch)) {}

    std::string name() const { return command_ + " of " + study_.filename().string(); }
    const std::string& command() const { return command_; }
    const fs::path& study() const { return study_; }
    fs::path out() const { return scratch_ / "out"; }

    Process begin() const {
        fs::remove_all(out());
        std::vector<std::string> arguments{command_, study_.string()};
        if (command_ != "check") arguments.insert(arguments.end(), {"--out", out().string(), "--threads", "1"});
        if (command_ == "fit") arguments.insert(arguments.end(), {"--profile", "all"});
        return Process(arguments, scratch_);
    }
    /// The processor time [s] that it takes where nobody interrupts it, measured once; at most `longest`.
    double duration(double longest) {
        if (!duration_) {
            Process process = begin();
            duration_ = process.awaitWork(longest) ? longest : process.allWork();
        }
        return *duration_;
    }

private:
    std::string command_;
    fs::path study_, scratch_;
    std::optional<double> duration_;
};

constexpr int endedBySignal = -1;

/// The interrupt was taken, or came when the results were being written already.
void expectTaken(int status, const Process& process) {
    EXPECT_TRUE(status == interrupted || status == done) << status << ": " << process.err();
}

/// ANALOGON_INTERRUPTS says how many runs must have ended by an interrupt: each at a moment drawn from the time that
/// the command takes on that study, most of them early, where one stage follows the other.
TEST_F(Interrupts, EndTheProgramSoonWhereverItIs) {
    constexpr double mostWork = 0.4;                   // [s] of a processor: 0.2 for what was under way, and 0.2
    constexpr double start = 0.012, listening = 0.06;  // [s], until the program listens: now and then, and always
    const char* const wanted = std::getenv("ANALOGON_INTERRUPTS");
    const char* const seed = std::getenv("ANALOGON_SEED");
    const int count = wanted ? std::atoi(wanted) : 8;
    const double longest = count < 100 ? 1.5 : 12;
    std::mt19937 random(seed ? static_cast<unsigned>(std::atoi(seed)) : 1);
    std::uniform_real_distribution<double> uniform;
    std::vector<InterruptedCommand> commands;
    for (const fs::path& study : writeInterruptStudies(scratch))
        for (const char* command : {"discover", "fit", "simulate", "check"})
            commands.emplace_back(command, study, scratch);

    std::vector<Seen> seen;
    std::map<std::string, int> ofCommand, ofStudy;
    int runs = 0, told = 0;
    for (; static_cast<int>(seen.size()) < count && runs < 10 * count; ++runs) {
        // 13 and 40 have no divisor in common: all pairs in turn, and few are enough for all commands
        InterruptedCommand& pair = commands[static_cast<std::size_t>(runs) * 13 % commands.size()];
        const double duration = std::max(pair.duration(longest), 2 * start), part = uniform(random);
        const double after =
            runs % 3 == 0 ? start + part * (duration - start) : start * std::pow(duration / start, part);
        SCOPED_TRACE(fmt::format("{} after {:.3f} of {:.3f} s", pair.name(), after, duration));
        Process process = pair.begin();
        if (!process.awaitWork(after)) continue;
        const double before = process.work();
        const auto begin = std::chrono::steady_clock::now();
        process.send(SIGINT);
        const int status = process.wait();
        const std::chrono::duration<double> waited = std::chrono::steady_clock::now() - begin;
        const double work = process.allWork() - before;
        if (status == endedBySignal && before < listening) continue;
        expectTaken(status, process);
        EXPECT_LE(work, mostWork);
        const bool hasReport = fs::exists(pair.out() / "report.json");
        EXPECT_EQ(fs::exists(pair.out()), hasReport) << "all or nothing";
        if (status != interrupted) continue;
        seen.push_back({fmt::format("{} after {:.3f} s", pair.name(), after), work, waited.count()});
        ++ofCommand[pair.command()];
        ++ofStudy[pair.study().filename().string()];
        EXPECT_THAT(process.err(), HasSubstr(hasReport ? "the best result so far was written" : "interrupted before"));
        if (!hasReport) continue;
        ++told;
        expectHonest(pair.out(), pair.command());
    }
    ASSERT_EQ(static_cast<int>(seen.size()), count) << "too few of " << runs << " runs were really interrupted";
    if (count >= 100) {
        EXPECT_EQ(ofCommand.size(), 4u);
        EXPECT_EQ(ofStudy.size(), 10u);
        EXPECT_GT(told, count / 10);
    }
    tell(seen, runs, told);
    for (const auto& [command, number] : ofCommand) std::printf("  %s: %d\n", command.c_str(), number);
}

/// What some shells and `timeout` send twice within a second is one interrupt.
TEST_F(Interrupts, ThatComeTwiceAreOne) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        SCOPED_TRACE(signal);
        const fs::path out = scratch / fmt::format("out-{}", signal);
        Process process({"discover", (root / "examples" / "water-pump").string(), "--out", out.string(), "--progress",
                         "json", "--threads", "2"},
                        scratch);
        process.awaitStage("trial");
        ASSERT_FALSE(process.isOver()) << process.err();
        process.send(signal);
        std::this_thread::sleep_for(milliseconds(20));
        process.send(signal);
        EXPECT_EQ(process.wait(), interrupted) << process.err();
        EXPECT_THAT(process.err(), HasSubstr("the best result so far was written"));
        ASSERT_TRUE(fs::exists(out / "report.json"));
        expectHonest(out, "discover");
    }
}

/// The exit status of a child that does this; 7 where it comes to its end.
template <class Act>
int statusOf(const Act& act) {
    const pid_t child = fork();
    if (child == 0) {
        act();
        _exit(7);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

void work(milliseconds time) {
    const auto begin = std::chrono::steady_clock::now();
    while (std::chrono::steady_clock::now() - begin < time) {
    }
}

TEST(Interrupt, TheThirdEndsTheProgramAtOnce) {
    EXPECT_EQ(statusOf([] {
                  Interrupt interrupt;
                  raise(SIGINT);
                  raise(SIGTERM);
              }),
              7);
    EXPECT_EQ(statusOf([] {
                  Interrupt interrupt;
                  for (int i = 0; i < 3; ++i) raise(SIGINT);
              }),
              interrupted);
}

TEST(Interrupt, EndsNothingThatIsBeingTold) {
    EXPECT_EQ(statusOf([] {
                  Interrupt interrupt;
                  interrupt.tell();
                  for (int i = 0; i < 5; ++i) raise(SIGINT);
              }),
              7);
}

TEST(Interrupt, IsNotWaitedForByWorkThatDoesNotComeBack) {
    EXPECT_EQ(statusOf([] {
                  Interrupt interrupt;
                  raise(SIGINT);
                  work(milliseconds(20000));
              }),
              interrupted);
    const fs::path told = fs::temp_directory_path() / fmt::format("analogon-last-words-{}", getpid());
    EXPECT_EQ(statusOf([&] {
                  Interrupt interrupt;
                  const Interrupt::LastWords words(interrupt, [&] { std::ofstream(told) << "found"; });
                  raise(SIGINT);
                  work(milliseconds(20000));
              }),
              interrupted);
    EXPECT_EQ(contentOf(told), "found");
    fs::remove(told);
}

TEST(Interrupt, WhatIsToldOnceIsNotToldByAnother) {
    EXPECT_EQ(statusOf([] {
                  Interrupt interrupt;
                  const Interrupt::LastWords words(interrupt, [] { _exit(9); });
                  raise(SIGINT);
                  interrupt.tell();
                  work(milliseconds(800));  // longer than work that has not come back is waited for
              }),
              7);
}

}  // namespace
}  // namespace analogon::cli
