#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <optional>
#include <thread>

#include "tests/app/command_process.hpp"

/// The programs with OpenBLAS for the BLAS, under a limit of memory in which its threads find no room.
namespace analogon::cli {
namespace {

using testing::HasSubstr;

/// Where OpenBLAS is installed, also beside another BLAS; empty: nowhere. ANALOGON_OPENBLAS names a folder of its own.
fs::path folderOfOpenBlas() {
    if (const char* told = std::getenv("ANALOGON_OPENBLAS")) return told;
    std::error_code none;
    for (const fs::directory_entry& machine : fs::directory_iterator("/usr/lib", none)) {
        const fs::path folder = machine.path() / "openblas-pthread";
        if (fs::exists(folder / "libblas.so.3", none)) return folder;
    }
    return {};
}

class SmallMemory : public CommandLine {
protected:
    void SetUp() override {
        CommandLine::SetUp();
        const fs::path folder = folderOfOpenBlas();
        if (folder.empty()) GTEST_SKIP() << "OpenBLAS is not installed";
        setenv("LD_LIBRARY_PATH", folder.c_str(), 1);
        setenv("ANALOGON_MEMORY", "100", 1);
        unsetenv("OPENBLAS_NUM_THREADS");
    }
    void TearDown() override {
        unsetenv("LD_LIBRARY_PATH");
        unsetenv("ANALOGON_MEMORY");
    }

    /// The exit status; -1 where the program had to be killed.
    static int statusOf(Process& process) {
        constexpr auto patience = std::chrono::seconds(60);
        const auto begin = std::chrono::steady_clock::now();
        while (std::chrono::steady_clock::now() - begin < patience) {
            if (const std::optional<int> status = process.poll()) return *status;
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        process.end();
        process.wait();
        return -1;
    }
};

TEST_F(SmallMemory, EndsEveryCommandWithOpenBlas) {
    const std::string directory = study(lag).string(), out = (scratch / "out").string();
    const std::vector<std::vector<std::string>> commands{{"check", directory},
                                                         {"simulate", directory, "--out", out},
                                                         {"fit", directory, "--out", out},
                                                         {"discover", directory, "--out", out}};
    for (const std::vector<std::string>& command : commands) {
        Process process(command, scratch);
        EXPECT_EQ(statusOf(process), 0) << command.front() << ": " << process.err();
    }
}

TEST_F(SmallMemory, EndsTheWindowWithOpenBlas) {
    const fs::path window = fs::path(ANALOGON_CLI).parent_path() / "analogon";
    if (!fs::exists(window)) GTEST_SKIP() << "the window is not built";
    setenv("QT_QPA_PLATFORM", "offscreen", 1);
    Process process({"--version"}, scratch, window.c_str());
    EXPECT_EQ(statusOf(process), 0) << process.err();
    EXPECT_THAT(process.out(), HasSubstr("Analogon "));
    unsetenv("QT_QPA_PLATFORM");
}

}  // namespace
}  // namespace analogon::cli
