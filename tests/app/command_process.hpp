#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

namespace analogon::cli {

namespace fs = std::filesystem;

inline const fs::path root = ANALOGON_ROOT;

inline std::string contentOf(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// The program as its own process, with both streams in files.
class Process {
public:
    Process(const std::vector<std::string>& arguments, const fs::path& scratch, const char* program = ANALOGON_CLI)
        : out_(scratch / "stdout.txt"), err_(scratch / "stderr.txt") {
        std::vector<char*> argv{const_cast<char*>(program)};
        for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
        argv.push_back(nullptr);
        id_ = fork();
        if (id_ != 0) return;
        // a shell that starts the tests in the background has them ignore it, and the program keeps to that
        for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_DFL);
        dup2(open(out_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644), STDOUT_FILENO);
        dup2(open(err_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644), STDERR_FILENO);
        execv(program, argv.data());
        _exit(127);
    }
    void interrupt() const { kill(id_, SIGINT); }
    void end() const { kill(id_, SIGKILL); }
    pid_t id() const { return id_; }
    int wait() {
        int status = 0;
        waitpid(id_, &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    /// The exit status of one that has ended.
    std::optional<int> poll() {
        int status = 0;
        if (waitpid(id_, &status, WNOHANG) != id_) return std::nullopt;
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    std::string out() const { return contentOf(out_); }
    std::string err() const { return contentOf(err_); }

private:
    fs::path out_, err_;
    pid_t id_{};
};

struct Result {
    int status{};
    std::string out, err;
};

class CommandLine : public testing::Test {
protected:
    void SetUp() override {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        scratch = fs::temp_directory_path() / "analogon-cli-test" / info->name();
        fs::remove_all(scratch);
        fs::create_directories(scratch);
    }
    Result run(const std::vector<std::string>& arguments) const {
        Process process(arguments, scratch);
        const int status = process.wait();
        return {status, process.out(), process.err()};
    }
    /// A study of a first-order lag y' = (k u - y)/T, 200 samples.
    fs::path study(const std::string& model, const std::string& data = {}) const {
        const fs::path directory = scratch / "study";
        fs::create_directories(directory);
        std::ofstream(directory / "model.mo") << model;
        std::ofstream(directory / "study.json") << R"({"format": "analogon-study-1", "class": "Lag",
  "experiments": [{"name": "step", "role": "fit", "file": "step.csv", "time": "t",
                   "inputs": {"u": "u"}, "outputs": {"y": "y"}}],
  "parameters": {"T": {"fit": true, "min": 0.1, "max": 10}, "k": {"fit": true, "min": 0.1, "max": 10}}})";
        std::ofstream csv(directory / "step.csv");
        if (!data.empty()) {
            csv << data;
            return directory;
        }
        csv << "t [s],u,y\n";
        for (int i = 0; i < 200; ++i) {
            const double t = 0.05 * i;
            const double wiggle = 0.001 * ((i * 7919) % 13 - 6);  // stands for noise
            csv << t << ",1," << 2 * (1 - std::exp(-t / 1.5)) + wiggle << '\n';
        }
        return directory;
    }

    const std::string lag = R"(model Lag
  parameter Real T(unit="s") = 1;
  parameter Real k = 1;
  Analogon.Interfaces.RealInput u;
  Analogon.Interfaces.RealOutput y(unit="K", start=0, fixed=true);
equation
  T*der(y) = k*u - y;
end Lag;
)";
    fs::path scratch;
};

}  // namespace analogon::cli
