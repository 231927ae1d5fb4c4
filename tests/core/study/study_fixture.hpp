#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/study/study.hpp"

namespace analogon::test {

/// A fresh directory for each test, taken away behind it.
class StudyTest : public ::testing::Test {
protected:
    void SetUp() override {
        const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
        directory_ = std::filesystem::temp_directory_path() /
                     ("analogon-" + std::string(info->test_suite_name()) + "-" + info->name());
        std::filesystem::remove_all(directory_);
        std::filesystem::create_directories(directory_);
    }
    void TearDown() override { std::filesystem::remove_all(directory_); }

    void put(const std::string& name, const std::string& text) const {
        std::filesystem::create_directories((directory_ / name).parent_path());
        std::ofstream(directory_ / name, std::ios::binary) << text;
    }
    static std::string get(const std::filesystem::path& file) {
        std::ifstream stream(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(stream), {}};
    }

    /// A heated body: input voltage and ambient temperature, output current.
    void putHeater() const {
        put("model.mo", R"(model Heater "A heated body"
  input Real u(unit="V") "voltage";
  input Real T_amb(unit="K");
  output Real i(unit="A");
  output Real T_out(unit="K");
  parameter Real R(unit="Ohm", min=0) = 3;
  parameter Real C(unit="J/K") = 10;
  parameter Real G(unit="W/K") = 0.1;
  parameter Real T_start(unit="K") = 293.15;
  final parameter Real k = 2;
  parameter Integer n = 1;
  Real T(unit="K", start=T_start, fixed=true);
equation
  i = u/R;
  C*der(T) = u*i - G*(T - T_amb);
  T_out = T;
end Heater;
)");
        put("train.csv",
            "t [ms],u_heater [mV],T_air [degC],current [mA],flow [l/min],broken\n"
            "0,0,20,0,1,1\n500,1000,20,333,2,\n1000,1000,21,333,3,2\n1500,2000,21,667,4,3\n");
        put("study.json", heaterJson);
    }

    Study read() const {
        Outcome<Study> study = readStudy(directory_);
        EXPECT_TRUE(study.hasValue()) << format(study.diagnostics());
        return study ? *study : Study{};
    }
    Diagnostic readFault() const {
        const Outcome<Study> study = readStudy(directory_);
        EXPECT_FALSE(study.hasValue());
        return study ? Diagnostic{} : study.diagnostics().front();
    }
    Diagnostic taskFault() const {
        const Outcome<EstimationTask> task = estimationTask(read());
        EXPECT_FALSE(task.hasValue());
        return task ? Diagnostic{} : task.diagnostics().front();
    }
    /// study.json with one piece of text replaced.
    void change(const std::string& from, const std::string& to) const {
        std::string json = get(directory_ / "study.json");
        const std::size_t at = json.find(from);
        ASSERT_NE(at, std::string::npos) << from;
        put("study.json", json.replace(at, from.size(), to));
    }

    static constexpr const char* heaterJson = R"({
  "format": "analogon-study-1",
  "class": "Heater",
  "experiments": [
    {"name": "warm-up", "role": "fit", "file": "train.csv", "time": "t",
     "inputs": {"u": "u_heater", "T_amb": "T_air"},
     "outputs": {"i": "current"}}
  ],
  "parameters": {
    "R": {"fit": true, "min": 0.1, "max": 20.0},
    "C": {"fit": true, "min": 1, "max": 100, "scale": "log"}
  }
}
)";

    std::filesystem::path directory_;
};

}  // namespace analogon::test
