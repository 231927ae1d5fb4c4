// The net itself, on a few studies that cost little: recorded twice, compared, and what is broken is seen.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "tests/search/summary.hpp"

namespace analogon::net {
namespace {

namespace fs = std::filesystem;

const fs::path root = ANALOGON_ROOT;

class SearchNet : public testing::Test {
protected:
    void SetUp() override {
        directory = fs::temp_directory_path() / ("analogon-net-" + std::to_string(::getpid()));
        fs::remove_all(directory);
        fs::create_directories(directory / "studies");
    }
    void TearDown() override { fs::remove_all(directory); }

    static std::string get(const fs::path& file) {
        std::ifstream stream(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    /// Exit status of the net's command; what it says is in said.txt.
    int net(const std::string& arguments) const {
        const std::string command = "BUILD=" ANALOGON_BUILD " " + (root / "tests/search/net.sh").string() + " " +
                                    arguments + " > " + (directory / "said.txt").string() + " 2>&1";
        return WEXITSTATUS(std::system(command.c_str()));
    }
    std::string said() const { return get(directory / "said.txt"); }
    std::string in(const std::string& name) const { return (directory / name).string(); }

    /// A lag y' = (k u - y)/T, 300 samples; `more`: by which the reading drifts, which the model has not.
    void putLag(const std::string& name, double more) const {
        const fs::path study = directory / "studies" / name;
        fs::create_directories(study);
        std::ofstream(study / "model.mo") << R"(model Lag
  parameter Real T(unit="s") = 1;
  parameter Real k = 1;
  Analogon.Interfaces.RealInput u(unit="V");
  Analogon.Interfaces.RealOutput y(unit="V", start=0, fixed=true);
equation
  T*der(y) = k*u - y;
end Lag;
)";
        std::ofstream(study / "study.json") << R"({"format": "analogon-study-1", "class": "Lag",
  "experiments": [{"name": "step", "role": "fit", "file": "step.csv", "time": "t",
                   "inputs": {"u": "u"}, "outputs": {"y": "y"}}],
  "parameters": {"T": {"fit": true, "min": 0.1, "max": 10}, "k": {"fit": true, "min": 0.1, "max": 10}}})";
        std::ofstream csv(study / "step.csv");
        csv << "t [s],u [V],y [V]\n";
        std::mt19937 random(3);
        std::normal_distribution<double> noise(0, 0.002);
        for (int i = 0; i < 300; ++i) {
            const double t = 0.05 * i, y = 2 * (1 - std::exp(-t / 1.5)) + more * t;
            csv << t << ",1," << y + noise(random) << '\n';
        }
    }

    fs::path directory;
};

TEST_F(SearchNet, RecordsComparesAndSeesWhatIsBroken) {
    putLag("noise", 0);
    putLag("drift", 0.01);
    fs::copy(root / "examples" / "lambda-sensor-heating", directory / "studies" / "lambda");
    ASSERT_EQ(net("record " + in("studies") + " " + in("one")), 0) << said();
    for (const char* study : {"noise", "drift", "lambda"})
        for (const char* threads : {"-1.txt", "-4.txt"}) EXPECT_TRUE(fs::exists(in("one/") + study + threads)) << study;
    const Summary lambda = summaryFrom(get(in("one/lambda-1.txt")));
    EXPECT_EQ(lambda.at("finding"), "effect");
    EXPECT_TRUE(
        lambda.contains("effects/thermal.radiation at heater.heatPort (Analogon.Effects.Thermal.Radiation)/way"));
    EXPECT_EQ(summaryFrom(get(in("one/noise-1.txt"))).at("finding"), "adequate");

    EXPECT_EQ(net("condense " + in("one") + " " + in("small")), 0) << said();
    EXPECT_FALSE(fs::exists(in("small/lambda-4.txt"))) << "the same on any number of threads";
    EXPECT_LT(fs::file_size(in("small/lambda-1.txt")), fs::file_size(in("one/lambda-1.txt")) / 2);
    EXPECT_EQ(net("compare " + in("small") + " " + in("one")), 0) << said();

    Summary broken = lambda;
    broken["finding"] = "partial";
    std::ofstream(in("one/lambda-1.txt")) << textOf(broken);
    EXPECT_EQ(net("compare " + in("small") + " " + in("one")), 1);
    EXPECT_THAT(said(), testing::HasSubstr("lambda on 1 thread\n  finding\n    - effect\n    + partial\n"));
    EXPECT_THAT(said(), testing::HasSubstr("3 studies compared: 1 differ; 1 depend on the number of threads"));
}

TEST_F(SearchNet, SaysWhatCannotBeSearched) {
    putLag("noise", 0);
    std::ofstream(directory / "studies" / "noise" / "study.json") << "{";
    EXPECT_EQ(net("record " + in("studies") + " " + in("one")), 0);
    EXPECT_THAT(said(), testing::HasSubstr("noise on 1 threads: exit status 2"));
    EXPECT_EQ(net("compare " + in("one") + " " + in("one")), 1) << "nothing was compared";
    EXPECT_EQ(net("dance"), 2);
}

}  // namespace
}  // namespace analogon::net
