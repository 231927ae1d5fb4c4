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
    /// Until it counts interrupts; before that it is not the program yet, but what prepares it.
    void awaitHandler() {
        while (!isOver()) {
            const std::string status = contentOf(fmt::format("/proc/{}/status", id_));
            const std::size_t caught = status.find("SigCgt:");
            if (caught != std::string::npos && std::stoull(status.substr(caught + 7), nullptr, 16) >> (SIGINT - 1) & 1)
                return;
        }
    }
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

/// A lag on many samples, which take their time to be read, simulated and written.
void writeLag(const fs::path& directory, int samples) {
    fs::create_directories(directory);
    std::ofstream(directory / "model.mo") << "model Lag\n  parameter Real T(unit=\"s\") = 1;\n  parameter Real k = 1;\n"
                                             "  Analogon.Interfaces.RealInput u(unit=\"V\");\n"
                                             "  Analogon.Interfaces.RealOutput y(unit=\"A\", start=0, "
                                             "fixed=true);\nequation\n  T*der(y) = k*u - y;\nend Lag;\n";
    std::ofstream(directory / "study.json") << R"({"format": "analogon-study-1", "class": "Lag",
  "experiments": [{"name": "step", "role": "fit", "file": "step.csv", "time": "t",
                   "inputs": {"u": "u"}, "outputs": {"y": "y"}}],
  "parameters": {"T": {"fit": true, "min": 0.1, "max": 10}, "k": {"fit": true, "min": 0.1, "max": 10}}})";
    std::string text = "t [s],u [V],y [A],T [degC]\n";
    double y = 0;
    for (int i = 0; i < samples; ++i) {
        const double u = i / 500 % 2;
        y += 0.01 / 1.5 * (2 * u - y);
        text += fmt::format("{:.2f},{},{:.4f},{:.2f}\n", 0.01 * i, u, y + 0.001 * ((i * 7919) % 13 - 6), 20 + y);
    }
    std::ofstream(directory / "step.csv") << text;
}

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
        const bool isWhole = process.err().find("when the work was done") != std::string::npos;
        const char* const sentence = hasReport ? "the best result so far was written" : "interrupted before";
        EXPECT_TRUE(isWhole || process.err().find(sentence) != std::string::npos) << process.err();
        if (!hasReport || isWhole) continue;
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

/// What is at its place then is whole, and what is nowhere else is nothing.
TEST_F(Interrupts, EndEveryCommandSoonWithASentence) {
    constexpr double mostWork = 0.4, longest = 4;  // [s] of a processor: as above; of a command that is not awaited
    const char* const wanted = std::getenv("ANALOGON_INTERRUPTS");
    const int count = wanted ? std::atoi(wanted) : 2;
    const std::string lag = (scratch / "lag").string(), data = lag + "/step.csv", packed = (scratch / "lag.analogon");
    const fs::path tmp = scratch / "tmp", place = scratch / "place", log = scratch / "log";
    const std::string out = place / "out";
    writeLag(lag, 60000);
    ASSERT_EQ(Process({"pack", lag, packed}, log).wait(), done);
    fs::create_directories(tmp);
    setenv("TMPDIR", tmp.c_str(), 1);
    const std::vector<std::vector<std::string>> commands{
        {"check", lag},
        {"check", packed},
        {"channels", data, "--values"},
        {"simulate", lag, "--out", out},
        {"fit", packed, "--out", out},
        {"discover", lag, "--out", out},
        {"export", lag, "--fmu", out},
        {"export", packed, "--csv", out},
        {"export", lag, "--modelica", out},
        {"generate", "--domains", "electric-thermal", "--data", data, "--out", out},
        {"pack", lag, out + ".analogon"},
        {"unpack", packed, out}};
    std::mt19937 random(11);
    int interruptedRuns = 0;
    double worst = 0;
    for (const std::vector<std::string>& command : commands) {
        SCOPED_TRACE(command[0] + " " + command[command.size() - 2]);
        const std::string written = command[0] == "pack" ? command.back() : out;
        fs::remove_all(place);
        fs::create_directories(place);
        Process whole(command, log);
        whole.awaitWork(longest);
        const double reach = whole.work();
        whole.send(SIGKILL);
        whole.wait();
        for (int i = 0; i < count; ++i) {
            fs::remove_all(place);
            fs::create_directories(place);
            const double moment = 1e-4 * static_cast<double>(random() % 10000) * (i % 3 == 0 ? 0.02 : 1) * reach;
            Process process(command, log);
            process.awaitHandler();
            process.awaitWork(moment);
            if (process.isOver()) continue;
            const double before = process.work();
            process.send(SIGINT);
            const int status = process.wait();
            EXPECT_TRUE(status == interrupted || status == done) << status << " after " << moment << process.err();
            EXPECT_LE(process.allWork() - before, mostWork) << "after " << moment;
            worst = std::max(worst, process.allWork() - before);
            if (status != interrupted) continue;
            ++interruptedRuns;
            EXPECT_THAT(process.err(), HasSubstr("interrupted"));
            if (!fs::exists(written)) continue;
            if (command[0] == "simulate" || command[0] == "fit" || command[0] == "discover") {
                EXPECT_TRUE(nlohmann::json::accept(contentOf(out + "/report.json")));
            } else {
                EXPECT_FALSE(fs::exists(written)) << "it was not written, as was said: " << process.err();
            }
        }
    }
    for (const auto& entry : fs::recursive_directory_iterator(tmp))
        EXPECT_TRUE(entry.path().string().starts_with((tmp / "analogon-study-").string())) << entry.path();
    fs::remove_all(place);
    fs::create_directories(place);
    EXPECT_EQ(Process({"check", packed}, log).wait(), done);
    EXPECT_TRUE(fs::is_empty(tmp)) << "the next run leaves nothing behind";
    unsetenv("TMPDIR");
    EXPECT_GT(interruptedRuns, 0);
    std::printf("%d runs were interrupted; the longest took %.3f s\n", interruptedRuns, worst);
}

/// Long traces are not waited for: all else is there, and it is said.
TEST_F(Interrupts, OfTheWritingOfResultsLeaveTheTracesOut) {
    writeLag(scratch / "lag", 300000);
    const fs::path place = scratch / "place", out = place / "out";
    fs::create_directories(place);
    Process process({"simulate", (scratch / "lag").string(), "--out", out.string()}, scratch / "log");
    const auto isBegun = [&] {
        for (const fs::path& around : {place, out})
            for (std::error_code code; const auto& entry : fs::directory_iterator(around, code))
                if (fs::exists(entry.path() / "new", code)) return true;
        return false;
    };
    while (!process.isOver() && !isBegun()) std::this_thread::sleep_for(milliseconds(1));
    ASSERT_FALSE(process.isOver()) << process.err();
    const double before = process.work();
    process.send(SIGINT);
    EXPECT_EQ(process.wait(), interrupted) << process.err();
    EXPECT_LE(process.allWork() - before, 0.4);
    EXPECT_THAT(process.err(), HasSubstr("the results were written but for the traces"));
    EXPECT_TRUE(nlohmann::json::accept(contentOf(out / "report.json")));
    EXPECT_FALSE(nlohmann::json::parse(contentOf(out / "report.json")).at("interrupted").get<bool>()) << "it is whole";
    EXPECT_TRUE(fs::exists(out / "study" / "step.csv"));
    EXPECT_FALSE(fs::exists(out / "traces.csv"));
    EXPECT_EQ(std::distance(fs::directory_iterator(place), fs::directory_iterator{}), 1);
}

/// An export that is stopped leaves the earlier one, and a compiler leaves no files of its own.
TEST_F(Interrupts, OfAnExportLeaveTheEarlierOne) {
    writeLag(scratch / "lag", 100);
    const fs::path tmp = scratch / "tmp", bin = scratch / "bin", file = scratch / "lag.fmu", log = scratch / "log";
    const std::vector<std::string> command{"export", (scratch / "lag").string(), "--fmu", file.string()};
    ASSERT_EQ(Process(command, log).wait(), done);
    const std::string before = contentOf(file);
    for (const fs::path& each : {tmp, bin}) fs::create_directories(each);
    std::ofstream(bin / "cc") << "#!/bin/sh\necho busy > \"${TMPDIR:-/tmp}/ccBUSY.s\"\ntouch '"
                              << (scratch / "begun").string() << "'\nexec sleep 60\n";
    fs::permissions(bin / "cc", fs::perms::owner_all);
    const std::string path = std::getenv("PATH");
    setenv("PATH", (bin.string() + ":" + path).c_str(), 1);
    setenv("TMPDIR", tmp.c_str(), 1);
    Process process(command, log);
    while (!process.isOver() && !fs::exists(scratch / "begun")) std::this_thread::sleep_for(milliseconds(2));
    process.send(SIGINT);
    EXPECT_EQ(process.wait(), interrupted);
    setenv("PATH", path.c_str(), 1);
    unsetenv("TMPDIR");
    EXPECT_EQ(process.err(), "interrupted: " + file.string() + " was not written\n");
    EXPECT_EQ(contentOf(file), before);
    EXPECT_TRUE(fs::is_empty(tmp));
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
        for (const int each : {SIGINT, SIGTERM, SIGHUP}) signal(each, SIG_DFL);
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

TEST(Interrupt, CountsFromTheBeginningOfTheProgram) {
    EXPECT_EQ(statusOf([] {
                  Interrupt::listen();
                  raise(SIGINT);
                  Interrupt interrupt;
                  std::this_thread::sleep_for(milliseconds(60));
                  _exit(interrupt.wasRaised() ? 5 : 6);
              }),
              5);
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
