#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

#include "core/eval/system.hpp"
#include "core/study/run.hpp"

/// A user's own blocks as text beside the study, or in a library of his own: they take part in everything that built-in
/// ones do.
namespace analogon {
namespace {

namespace fs = std::filesystem;

const char* const workshop = R"mo(package Workshop "Blocks of the user"
  model Rotor "The library's inertia with another value"
    extends Analogon.Mechanics.Inertia(J = 0.02);
  end Rotor;

  model Bearing "The library's viscous load, and what it turns to heat"
    extends Analogon.Mechanics.ViscousLoad(b = 0.01);
    Real P(unit = "W") "Loss";
  equation
    P = flange.tau*der(flange.phi);
  end Bearing;

  model FanDrag "Torque with the fourth power of the speed"
    extends Analogon.Interfaces.PartialOneFlange;
    parameter Real k_f(unit = "N.m.s4/rad4", min = 0) = 0 "Strength, 0 is off";
  equation
    flange.tau = k_f*w*noEvent(abs(w))^3;
    annotation (__Analogon(effect(kind = "drag.fan", way = "attach", ports = {"flange"}, strength = "k_f",
      oneSided = true)));
  end FanDrag;
end Workshop;
)mo";

const char* const rig = R"(model Rig
  Analogon.Interfaces.RealInput tau(unit = "N.m");
  Analogon.Interfaces.RealOutput w(unit = "rad/s");
  Analogon.Sources.PrescribedTorque torque;
  Workshop.Rotor rotor;
  Workshop.Bearing bearing;
  Analogon.Sensors.SpeedSensor sensor;
equation
  connect(tau, torque.tau);
  connect(sensor.w, w);
  connect(torque.flange, rotor.flange_a);
  connect(rotor.flange_b, sensor.flange);
  connect(rotor.flange_b, bearing.flange);
end Rig;
)";

class UserBlock : public ::testing::Test {
protected:
    void SetUp() override {
        const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
        root_ = fs::temp_directory_path() / fmt::format("analogon-user-block-{}", info->name());
        fs::remove_all(root_);
        fs::create_directories(root_ / "study");
        put("study/model.mo", rig);
    }
    void TearDown() override { fs::remove_all(root_); }

    void put(const std::string& name, const std::string& text) const {
        std::ofstream(root_ / name, std::ios::binary) << text;
    }
    void putStudy(const std::string& more) const {
        const auto experiment = [](const char* name, const char* role) {
            return fmt::format(R"({{"name": "{0}", "role": "{1}", "file": "{0}.csv", "time": "t",
     "inputs": {{"tau": "tau"}}, "outputs": {{"w": "w"}}}})",
                               name, role);
        };
        put("study/study.json", fmt::format(R"({{"format": "analogon-study-1", "class": "Rig",{}
  "experiments": [{}, {}],
  "parameters": {{"rotor.J": {{"fit": true, "min": 1e-4, "max": 1}}, "bearing.b": {{"fit": true, "min": 0, "max": 1}}}}}})",
                                            more, experiment("run", "fit"), experiment("check", "validate")));
        record("run", 1);
        record("check", 2);
    }

    /// J*der(w) = tau - b*w - k_f*w^4 by small Runge-Kutta steps, with noise on the speed.
    void record(const std::string& name, unsigned seed) const {
        constexpr double J = 0.01, b = 0.005, k = 4e-10, step = 0.03;
        std::mt19937 random(seed);
        std::normal_distribution<double> noise(0, 0.05);
        std::string text = "t [s],tau [N.m],w [rad/s]\n";
        double w = 0;
        const auto torque = [seed](double t) {
            return 0.9 + 0.6 * std::sin(0.7 * seed * t) + 0.3 * std::sin(2.3 * t + seed);
        };
        const auto slope = [](double tau, double speed) {
            return (tau - b * speed - k * speed * std::pow(std::fabs(speed), 3)) / J;
        };
        for (int i = 0; i <= 500; ++i) {
            const double t = i * step, tau = torque(t), next = torque(t + step), middle = (tau + next) / 2;
            text += fmt::format("{:.6g},{:.9g},{:.9g}\n", t, tau, w + noise(random));
            const double k1 = slope(tau, w), k2 = slope(middle, w + step / 2 * k1),
                         k3 = slope(middle, w + step / 2 * k2), k4 = slope(next, w + step * k3);
            w += step / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
        }
        put("study/" + name + ".csv", text);
    }

    fs::path root_;
};

TEST_F(UserBlock, BesideTheStudyIsCheckedFittedAndDiscovered) {
    put("study/workshop.mo", workshop);
    putStudy("");
    const Outcome<Study> study = readStudy(root_ / "study");
    ASSERT_TRUE(study) << format(study.diagnostics());
    const Outcome<Library> library = studyLibrary(*study);
    ASSERT_TRUE(library) << format(library.diagnostics());
    const Outcome<SystemPtr> system = compile(*library, "Rig", {{"rotor.J", "bearing.b"}});
    ASSERT_TRUE(system) << format(system.diagnostics());
    EXPECT_EQ((*system)->parameters()[0].value, 0.02);  // from the modification in the user's class

    const Outcome<RunResult> fitted = runFit(*study, {});
    ASSERT_TRUE(fitted) << format(fitted.diagnostics());

    const Outcome<RunResult> result = runDiscover(*study, {});
    ASSERT_TRUE(result) << format(result.diagnostics());
    ASSERT_EQ(result->finding.effects.size(), 1u);
    const AddedEffect& effect = result->finding.effects[0];
    EXPECT_EQ(effect.kind, "drag.fan");
    EXPECT_EQ(effect.className, "Workshop.FanDrag");
    EXPECT_NE(result->completed.models.at("model.mo").find("Workshop.FanDrag"), std::string::npos);
    EXPECT_EQ(result->completed.models.at("workshop.mo"), workshop);  // not a byte of it was touched
}

TEST_F(UserBlock, OfALibraryIsNamedByTheStudy) {
    fs::create_directories(root_ / "blocks");
    put("blocks/Workshop.mo", workshop);
    putStudy(R"( "library": ["../blocks/Workshop.mo"],)");
    const Outcome<Study> study = readStudy(root_ / "study");
    ASSERT_TRUE(study) << format(study.diagnostics());
    const Outcome<EstimationTask> task = estimationTask(*study);
    ASSERT_TRUE(task) << format(task.diagnostics());
    EXPECT_EQ(task->parameters.size(), 2u);
}

TEST_F(UserBlock, OfALibraryIsGivenWithTheCommand) {
    fs::create_directories(root_ / "Workshop");
    // The same package as a directory, in an order of its own.
    put("Workshop/package.mo", "package Workshop\nend Workshop;\n");
    put("Workshop/package.order", "Rotor\nBearing\nFanDrag\n");
    const std::string text = workshop;
    const auto cut = [&](const std::string& name) {
        const std::size_t from = text.find("  model " + name), to = text.find("  end " + name + ";");
        return "within Workshop;\n" + text.substr(from, to - from) + "  end " + name + ";\n";
    };
    put("Workshop/Rotor.mo", cut("Rotor"));
    put("Workshop/Bearing.mo", cut("Bearing"));
    put("Workshop/FanDrag.mo", cut("FanDrag"));
    putStudy("");
    Outcome<Study> study = readStudy(root_ / "study");
    ASSERT_TRUE(study) << format(study.diagnostics());
    RunOptions options;
    options.libraryPaths = {root_ / "Workshop"};
    const Outcome<RunResult> result = runFit(*study, options);
    ASSERT_TRUE(result) << format(result.diagnostics());
    EXPECT_FALSE(estimationTask(*study));  // without it the class is not known
}

/// The study's class inherits the whole composition, with its parameters, from the user's library.
TEST_F(UserBlock, WhichTheStudyInheritsIsFittedAndGetsEffects) {
    std::string base = rig;
    base.replace(base.find("Rig"), 3, "Base");
    base.replace(base.rfind("Rig"), 3, "Base");
    base.replace(base.find("equation"), 0, "  parameter Real offset(unit = \"N.m\") = 0;\n");
    put("study/base.mo", base);
    put("study/model.mo", "model Rig \"inherits all\"\n  extends Base(rotor(J = 0.02));  // from beside\nend Rig;\n");
    put("study/workshop.mo", workshop);
    putStudy("");
    const Outcome<Study> study = readStudy(root_ / "study");
    ASSERT_TRUE(study) << format(study.diagnostics());
    const Outcome<RunResult> fitted = runFit(*study, {});
    ASSERT_TRUE(fitted) << format(fitted.diagnostics());
    const std::string text = fitted->completed.models.at("model.mo");
    EXPECT_EQ(text.find("model Rig \"inherits all\"\n  extends Base(rotor(J = 0.0"), 0u) << text;
    EXPECT_NE(text.find("bearing.b=0.0"), std::string::npos) << text;
    EXPECT_NE(text.find(";  // from beside\nend Rig;\n"), std::string::npos) << text;
    EXPECT_EQ(fitted->completed.models.at("base.mo"), base);

    const Outcome<RunResult> result = runDiscover(*study, {});
    ASSERT_TRUE(result) << format(result.diagnostics());
    ASSERT_EQ(result->finding.effects.size(), 1u);
    EXPECT_EQ(result->finding.effects[0].kind, "drag.fan");
    const std::string completed = result->completed.models.at("model.mo");
    EXPECT_NE(completed.find("Workshop.FanDrag fanDrag("), std::string::npos) << completed;
    const Outcome<RunResult> again = runFit(result->completed, {});
    EXPECT_TRUE(again) << format(again.diagnostics());
}

TEST_F(UserBlock, InAnArrayIsFittedElementByElement) {
    put("study/workshop.mo", workshop);
    putStudy("");
    std::string text = rig;
    const auto exchange = [&text](const std::string& from, const std::string& to) {
        for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
            text.replace(at, from.size(), to);
    };
    exchange("Workshop.Rotor rotor;", "Workshop.Rotor rotor[2](each J = 0.004);");
    exchange("rotor.flange_b", "rotor[2].flange_b");
    exchange("connect(torque.flange, rotor.flange_a)",
             "connect(rotor[1].flange_b, rotor[2].flange_a);\n  connect(torque.flange, rotor[1].flange_a)");
    put("study/model.mo", text);
    Outcome<Study> study = readStudy(root_ / "study");
    ASSERT_TRUE(study) << format(study.diagnostics());
    const StudyParameter inertia = study->parameters.at("rotor.J");
    study->parameters.erase("rotor.J");
    study->parameters["rotor[2].J"] = inertia;
    const Outcome<RunResult> fitted = runFit(*study, {});
    ASSERT_TRUE(fitted) << format(fitted.diagnostics());
    const std::string completed = fitted->completed.models.at("model.mo");
    EXPECT_NE(completed.find("rotor[2](J = {0.004, 0.00"), std::string::npos) << completed;
    EXPECT_TRUE(runFit(fitted->completed, {}));
}

}  // namespace
}  // namespace analogon
