#include "app/analogon-cli/interrupt.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>

#include "app/analogon-cli/command_line.hpp"

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
        std::string stat = contentOf(fmt::format("/proc/{}/stat", id_));
        std::istringstream fields(stat.substr(std::min(stat.size(), stat.rfind(')') + 2)));
        std::string skipped;
        for (int i = 3; i < 14; ++i) fields >> skipped;
        double user = 0, system = 0;
        fields >> user >> system;
        return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
    }
    bool isOver() {
        if (isOver_) return true;
        rusage used{};
        isOver_ = wait4(id_, &status_, WNOHANG, &used) == id_;
        if (isOver_) allWork_ = secondsOf(used.ru_utime) + secondsOf(used.ru_stime);
        return isOver_;
    }
    /// The exit status; -1: a signal ended it.
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

/// Thermal masses in a row, every other one a thousand times lighter: stiff, and the more of them the slower.
void writeChain(const fs::path& directory, int masses, int samples) {
    fs::create_directories(directory);
    std::ofstream model(directory / "model.mo");
    model << "model Chain\n  Analogon.Interfaces.RealInput P(unit=\"W\");\n"
             "  Analogon.Interfaces.RealOutput T(unit=\"K\");\n"
             "  Analogon.Sources.PrescribedHeatFlow heat;\n  Analogon.Sources.FixedTemperature around(T=293.15);\n"
             "  Analogon.Thermal.ThermalConductor out(G=0.5);\n  Analogon.Sensors.TemperatureSensor sensor;\n";
    for (int i = 0; i < masses; ++i) {
        model << fmt::format("  Analogon.Thermal.HeatCapacitor c{}(C={}, T_start=293.15);\n", i, i % 2 ? 0.005 : 5.0);
        if (i > 0) model << fmt::format("  Analogon.Thermal.ThermalConductor g{}(G=2);\n", i);
    }
    model << "equation\n  connect(P, heat.Q_flow);\n  connect(heat.port, c0.port);\n  connect(c0.port, sensor.port);\n"
             "  connect(sensor.T, T);\n  connect(out.port_b, around.port);\n";
    for (int i = 1; i < masses; ++i)
        model << fmt::format("  connect(c{}.port, g{}.port_a);\n  connect(g{}.port_b, c{}.port);\n", i - 1, i, i, i);
    model << fmt::format("  connect(c{}.port, out.port_a);\nend Chain;\n", masses - 1);
    std::ofstream(directory / "study.json") << R"({"format": "analogon-study-1", "class": "Chain",
  "experiments": [{"name": "steps", "role": "fit", "file": "steps.csv", "time": "t",
                   "inputs": {"P": "P"}, "outputs": {"T": "T"}}],
  "parameters": {"c0.C": {"fit": true, "min": 0.1, "max": 100}, "c2.C": {"fit": true, "min": 0.1, "max": 100},
                 "g1.G": {"fit": true, "min": 0.05, "max": 50}, "out.G": {"fit": true, "min": 0.05, "max": 50}}})";
    std::ofstream csv(directory / "steps.csv");
    csv << "t [s],P [W],T [K]\n";
    double T = 293.15;
    for (int k = 0; k < samples; ++k) {
        const double P = 20 + 10 * (k / 100 % 2) + 5 * std::sin(0.01 * k);
        T += 0.5 / 60 * (1.5 * P + 293.15 - T);
        csv << fmt::format("{},{:.4f},{:.4f}\n", 0.5 * k, P, T + 0.005 * ((k * 7919) % 13 - 6));
    }
}

class Interrupts : public testing::Test {
protected:
    void SetUp() override {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        scratch = fs::temp_directory_path() / fmt::format("analogon-interrupt-test-{}", getpid()) / info->name();
        fs::create_directories(scratch);
    }
    void TearDown() override { fs::remove_all(scratch.parent_path()); }

    std::vector<fs::path> studies() const {
        std::vector<fs::path> all{root / "examples" / "lambda-sensor-heating", root / "examples" / "water-pump"};
        for (const int masses : {4, 20, 60}) {
            all.push_back(scratch / fmt::format("chain-{}", masses));
            writeChain(all.back(), masses, 40000 / masses);
        }
        const char* const more = std::getenv("ANALOGON_INTERRUPT_STUDIES");  // directories, separated by colons
        std::istringstream list(more ? more : "");
        for (std::string each; std::getline(list, each, ':');) all.emplace_back(each);
        return all;
    }

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

    fs::path scratch;
};

/// ANALOGON_INTERRUPTS says how many; each is at a random moment of a run on one of the studies.
TEST_F(Interrupts, EndTheProgramSoonWhereverItIs) {
    constexpr double mostWork = 0.4;  // [s] of a processor: 0.2 for what was under way, and 0.2
    const char* const wanted = std::getenv("ANALOGON_INTERRUPTS");
    const char* const seed = std::getenv("ANALOGON_SEED");
    const int count = wanted ? std::atoi(wanted) : 8;
    const std::vector<std::string> commands{"discover", "fit", "simulate", "check"};
    std::mt19937 random(seed ? static_cast<unsigned>(std::atoi(seed)) : 1);
    const std::vector<fs::path> all = studies();
    int interruptedRuns = 0, told = 0;
    double worst = 0;
    for (int i = 0; i < count; ++i) {
        const fs::path& study = all[static_cast<std::size_t>(i) % all.size()];
        const std::string& command = commands[static_cast<std::size_t>(i) / all.size() % commands.size()];
        const fs::path out = scratch / fmt::format("out-{}", i);
        // most runs are short, and most of what a long one does comes again and again
        const auto after =
            milliseconds(static_cast<int>(20 * std::pow(200.0, static_cast<double>(random() % 1000) / 1000)));
        SCOPED_TRACE(fmt::format("{} of {} after {} ms", command, study.string(), after.count()));
        std::vector<std::string> arguments{command, study.string()};
        if (command != "check") arguments.insert(arguments.end(), {"--out", out.string(), "--threads", "1"});
        if (command == "fit") arguments.insert(arguments.end(), {"--profile", "all"});
        Process process(arguments, scratch);
        for (double work = 0; !process.isOver() && work < 1e-3 * static_cast<double>(after.count());
             work = process.work())
            std::this_thread::sleep_for(milliseconds(2));
        if (process.isOver()) continue;
        const double before = process.work();
        process.send(SIGINT);
        const int status = process.wait();
        EXPECT_TRUE(status == interrupted || status == done) << status << ": " << process.err();
        const double work = process.allWork() - before;
        EXPECT_LE(work, mostWork);
        worst = std::max(worst, work);
        interruptedRuns += status == interrupted;
        if (command == "check") continue;
        EXPECT_EQ(fs::exists(out), fs::exists(out / "report.json")) << "all or nothing";
        if (status != interrupted || !fs::exists(out / "report.json")) continue;
        ++told;
        expectHonest(out, command);
        fs::remove_all(out);
    }
    RecordProperty("worst_ms", static_cast<int>(1000 * worst));
    std::printf("%d of %d runs were interrupted, %d of them told what they had found; the longest took %.3f s\n",
                interruptedRuns, count, told, worst);
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
