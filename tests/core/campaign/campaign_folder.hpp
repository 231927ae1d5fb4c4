#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace analogon {

/// A folder with a small study (a first-order lag of gain k) and what a campaign of it needs.
struct CampaignFiles {
    void writeStudy(const std::filesystem::path& folder) {
        folder_ = folder;
        std::filesystem::create_directories(folder_ / "lag");
        write("lag/model.mo",
              "model Lag\n  Analogon.Interfaces.RealInput u(unit=\"V\");\n"
              "  Analogon.Interfaces.RealOutput y(unit=\"V\");\n  parameter Real k(unit=\"1\") = 1;\n"
              "  parameter Real T(unit=\"s\") = 0.5;\n  Real x(unit=\"V\", start=0, fixed=true);\n"
              "equation\n  T*der(x) = k*u - x;\n  y = x;\nend Lag;\n");
        write("lag/study.json",
              R"({"format": "analogon-study-1", "class": "Lag", "experiments": [{"name": "step", "role": "fit",
                  "file": "step.csv", "time": "t", "inputs": {"u": "u"}, "outputs": {"y": "y"}}],
                  "parameters": {"k": {"fit": true, "min": 0.1, "max": 10},
                                 "T": {"fit": true, "min": 0.01, "max": 5}}})");
        record("lag/step.csv", 1, 0.5);
    }

    std::filesystem::path at(const std::string& name) const { return folder_ / name; }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name, std::ios::binary) << text;
    }
    std::string read(const std::string& name) const {
        std::ifstream stream(folder_ / name, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }
    /// The answer to a step of 1 V, by its solution, with a small ripple.
    void record(const std::string& name, double gain, double lag) const {
        std::string text = "t [s],u [V],y [V]\n";
        for (int i = 0; i <= 60; ++i) {
            const double t = 0.05 * i;
            text += std::to_string(t) + ",1," +
                    std::to_string(gain * (1 - std::exp(-t / lag)) + 0.002 * std::sin(37.0 * i * i)) + "\n";
        }
        write(name, text);
    }
    void campaign(const std::string& columns, const std::string& rest = R"("command": "fit")") const {
        write("campaign.json", R"({"format": "analogon-campaign-1", "study": "lag", "units": "units.csv", )" + rest +
                                   R"(, "columns": )" + columns + "}");
    }

    std::filesystem::path folder_;
};

class CampaignFolder : public testing::Test, protected CampaignFiles {
protected:
    void SetUp() override {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        const std::filesystem::path folder =
            std::filesystem::temp_directory_path() /
            ("analogon-campaign-" + std::string(test->name()) + std::to_string(getpid()));
        std::filesystem::remove_all(folder);
        writeStudy(folder);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }
};

}  // namespace analogon
