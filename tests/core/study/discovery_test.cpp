// The closed loop on recordings made here, by equations of their own.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <numbers>
#include <numeric>
#include <random>
#include <set>
#include <stdexcept>

#include "core/effect/model/model_state.hpp"
#include "core/report/decision_lines.hpp"
#include "core/study/run.hpp"
#include "study_fixture.hpp"

namespace analogon {
namespace {

constexpr int samples = 1501;
constexpr double step = 0.02;  // [s]

/// A shaft: J*der(w) = u - torque(t, w, phi).
struct Shaft {
    double inertia{0.02};  // [kg.m2]
    std::function<double(double t, double w, double phi)> torque;
    double limit{1e9};               // [N.m] of the drive
    double lag{};                    // [s] of the tachometer
    double pickUp{};                 // [rad/(s.N.m)] of the tachometer, from the drive
    bool isHeld{};                   // the command, between its samples
    double spark{};                  // [rad/s] by which every 150th sample of the tachometer is wrong
    double late{};                   // [s] that the column of the command is stamped
    bool isTurned{};                 // the sign of the tachometer
    int first{}, recorded{samples};  // samples of the recording
    std::string more{};              // of the experiment
};

double signOf(double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

double levelAt(double t) {
    const double levels[] = {0.4, -0.3, 0.8, 0.1, -0.7, 0.5, -0.1, 0.9, -0.5, 0.2};
    return levels[static_cast<int>(t / 3.0) % 10];
}

double excitation(double t) { return levelAt(t) + 0.15 * std::sin(1.7 * t); }

double commandOf(const Shaft& shaft, double t) { return shaft.isHeld ? levelAt(t + 1e-9) : excitation(t); }

std::vector<double> speedOf(const Shaft& shaft) {
    constexpr int inner = 40;
    double w = 0, phi = 0, shown = 0;
    std::vector<double> speed;
    for (int k = 0; k < samples; ++k) {
        speed.push_back((shaft.lag > 0 ? shown : w) + shaft.pickUp * commandOf(shaft, k * step));
        for (int i = 0; i < inner; ++i) {
            const double h = step / inner, t = k * step + i * h;
            // the program joins samples by straight lines
            const double a = shaft.isHeld ? 0 : (t - k * step) / step;
            const double command = (1 - a) * commandOf(shaft, k * step) + a * commandOf(shaft, (k + 1) * step);
            const double u = std::clamp(command, -shaft.limit, shaft.limit);
            const double half = w + 0.5 * h * (u - shaft.torque(t, w, phi)) / shaft.inertia;
            phi += h * half;
            w += h * (u - shaft.torque(t + 0.5 * h, half, phi)) / shaft.inertia;
            if (shaft.lag > 0) shown += h * (half - shown) / shaft.lag;
        }
    }
    return speed;
}

/// A machine on a rotor with a load, declared as given; its current and its speed are measured.
std::string machineModel(const std::string& input, const std::string& motor, const std::string& rotor,
                         const std::string& load, const std::string& more = "") {
    return "model Drive\n  Analogon.Interfaces.RealInput " + input + R"((unit="V");
  Analogon.Interfaces.RealOutput i(unit="A");
  Analogon.Interfaces.RealOutput w(unit="rad/s");
)" + more + "  Analogon.ElectricMechanical.BasicElectricMechanical motor(" +
           motor + ");\n  Analogon.Mechanics.Inertia rotor(" + rotor + ");\n  Analogon.Mechanics." + load + R"(;
  Analogon.Sensors.SpeedSensor tacho;
equation
  connect()" +
           input + R"(, motor.v);
  connect(motor.i, i);
  connect(motor.flange, rotor.flange_a);
  connect(rotor.flange_b, load.flange);
  connect(rotor.flange_b, tacho.flange);
  connect(tacho.w, w);
end Drive;
)";
}

class Discovery : public test::StudyTest {
protected:
    /// The recording of the study, to be filled.
    std::ofstream recording(const std::string& header, const std::string& file = "run.csv") const {
        std::ofstream csv(directory_ / file);
        csv.precision(10);
        csv << header << '\n';
        return csv;
    }

    /// The recording of what a torque drives that runs straight from sample to sample. `shown`: what is measured, with
    /// so much noise; `move(tau, h)` takes it further.
    template <class Drive, class Move>
    void recordDriven(const std::string& column, double noise, const Drive& drive, const double& shown,
                      const Move& move) const {
        std::mt19937 random(4);
        std::normal_distribution<double> scatter(0, noise);
        std::ofstream csv = recording("t [s],tau [N.m]," + column);
        for (int k = 0; k < samples; ++k) {
            csv << k * step << ',' << drive(k * step) << ',' << shown + scatter(random) << '\n';
            constexpr int inner = 100;
            for (int m = 0; m < inner; ++m) {
                const double a = (m + 0.5) / inner;
                move((1 - a) * drive(k * step) + a * drive((k + 1) * step), step / inner);
            }
        }
    }

    /// Discovers what a model of inertia and viscous friction lacks.
    /// `memory`: correlation of neighbouring samples of the noise.
    Finding search(const Shaft& shaft, double noise = 0.05, const std::function<double(double t)>& oil = {},
                   double memory = 0) {
        put("model.mo", R"(model Rotor
  Analogon.Interfaces.RealInput tau(unit="N.m");
  Analogon.Interfaces.RealOutput w(unit="rad/s");
  Analogon.Sources.PrescribedTorque drive;
  Analogon.Mechanics.Inertia rotor(J=0.03);
  Analogon.Mechanics.ViscousLoad load(b=0.02);
  Analogon.Sensors.SpeedSensor tacho;
equation
  connect(tau, drive.tau);
  connect(drive.flange, rotor.flange_a);
  connect(rotor.flange_b, load.flange);
  connect(rotor.flange_b, tacho.flange);
  connect(tacho.w, w);
end Rotor;
)");
        put("study.json", R"({"format": "analogon-study-1", "class": "Rotor",
  "experiments": [{"name": "run", "role": "fit", "file": "run.csv", "time": "t",
                   "inputs": {"tau": "tau"}, "outputs": {"w": "w"})" +
                              shaft.more + R"(}],
  "parameters": {"rotor.J": {"fit": true, "min": 0.001, "max": 1}, "load.b": {"fit": true, "min": 0.0001, "max": 1}}})");
        std::mt19937 random(7);
        std::normal_distribution<double> scatter(0, noise);
        std::ofstream csv = recording(std::string("t [s],tau [N.m],w [rad/s]") + (oil ? ",oil [degC]" : ""));
        const std::vector<double> speed = speedOf(shaft);
        double error = scatter(random);
        for (int k = shaft.first; k < shaft.recorded; ++k) {
            csv << k * step << ',' << commandOf(shaft, std::max(0.0, k * step - shaft.late)) << ','
                << (shaft.isTurned ? -1 : 1) * speed[static_cast<std::size_t>(k)] + error +
                       (k % 150 == 40 ? shaft.spark : 0);
            error = memory * error + std::sqrt(1 - memory * memory) * scatter(random);
            if (oil) csv << ',' << oil(k * step);
            csv << '\n';
        }
        csv.close();
        return discovered();
    }

    /// Where the studies of these tests are asked for (tests/search/net.sh), a test leaves its first one there, by the
    /// name of the test, and ends.
    void leaveStudy() const {
        const char* kept = std::getenv("ANALOGON_KEEP_STUDIES");
        if (kept == nullptr) return;
        const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
        const std::filesystem::path into =
            std::filesystem::path(kept) / (std::string(test->test_suite_name()) + "." + test->name());
        std::filesystem::create_directories(into);
        std::filesystem::copy(
            directory_, into,
            std::filesystem::copy_options::overwrite_existing | std::filesystem::copy_options::recursive);
        throw std::runtime_error("the study was left in " + into.string());
    }

    Finding discovered(const std::vector<std::string>& kinds = {}, const Progress& progress = {}) const {
        leaveStudy();
        RunOptions options;
        options.discover.kinds = kinds;
        Outcome<RunResult> result = runDiscover(read(), options, progress);
        EXPECT_TRUE(result) << format(result.diagnostics());
        if (!result) return {};
        const std::vector<FitEstimate>& fitted = result->finding.final.parameters;
        const bool isBound =
            std::any_of(fitted.begin(), fitted.end(), [](const FitEstimate& estimate) { return estimate.atBound; });
        for (const AddedEffect& e : result->finding.effects) {
            // whatever is found, its strength is told from 0 (or from what rests at a bound) and its chance belongs to
            // its score
            const EffectValue& strength = e.parameters.at(0);
            EXPECT_TRUE(strength.standardError < std::abs(strength.value) ||
                        (isBound && std::isnan(strength.standardError)))
                << e.kind;
            EXPECT_TRUE(e.evidence.score < 200 || e.evidence.pValue < 1e-20) << e.kind;
        }
        for (const Remainder& r : result->finding.unexplained.remainders)  // what is left shows on a channel
            EXPECT_TRUE(!r.output.empty() && !r.experiment.empty() && r.from < r.to) << r.proposal.equation;
        for (const CandidateResult& c : result->finding.candidates)  // and what is not, is not for a reason
            EXPECT_EQ(c.reason.empty(), c.verdict == Verdict::Chosen) << c.kind << " at " << c.at << ": " << c.reason;
        return std::move(result->finding);
    }

    /// Expects one effect at the input and one elsewhere, each of that kind and strength, and that noise is left.
    static void expectBoth(const Finding& finding, const std::string& input,
                           const std::pair<std::string, double>& atInput,
                           const std::pair<std::string, double>& elsewhere, double tolerance) {
        EXPECT_EQ(finding.kind, FindingKind::Effect);
        ASSERT_EQ(finding.effects.size(), 2u);
        for (const AddedEffect& e : finding.effects) {
            const auto& [kind, strength] = e.at == input ? atInput : elsewhere;
            EXPECT_EQ(e.kind, kind) << e.at;
            EXPECT_NEAR(e.parameters.front().value, strength, tolerance);
        }
    }

    /// Of a parameter of an effect; NaN: it has none of that name.
    static double valueOf(const AddedEffect& effect, const std::string& name) {
        for (const EffectValue& p : effect.parameters)
            if (p.name == name) return p.value;
        return std::nan("");
    }
};

TEST_F(Discovery, AddsNothingToNoise) {
    const Finding finding = search({0.02, [](double, double w, double) { return 0.03 * w; }});
    EXPECT_EQ(finding.kind, FindingKind::Adequate);
    EXPECT_TRUE(finding.effects.empty());
    EXPECT_TRUE(finding.unexplained.remainders.empty());
}

// The record was cut out of a longer one: the shaft turns where it begins.
TEST_F(Discovery, FitsTheSpeedAtWhichARecordBegins) {
    Shaft shaft{0.02, [](double, double w, double) { return 0.03 * w + 0.1 * signOf(w); }};
    shaft.first = 450;
    const double speed = speedOf(shaft)[450];
    ASSERT_GT(std::abs(speed), 5);
    const Finding finding = search(shaft);
    EXPECT_EQ(finding.kind, FindingKind::Effect);
    ASSERT_EQ(finding.effects.size(), 1u);
    EXPECT_EQ(finding.effects[0].kind, "friction.coulomb");
    EXPECT_NEAR(finding.effects[0].parameters.at(0).value, 0.1, 0.003);
    const auto start = std::find_if(finding.final.parameters.begin(), finding.final.parameters.end(),
                                    [](const FitEstimate& e) { return e.name == "rotor.w.start"; });
    ASSERT_NE(start, finding.final.parameters.end());
    EXPECT_NEAR(start->value, speed, 0.1);
    EXPECT_TRUE(std::any_of(finding.warnings.begin(), finding.warnings.end(), [](const Text& w) {
        return w.english().find("does not begin where the model was told: rotor.w.start is") != std::string::npos;
    }));
}

TEST_F(Discovery, EstimatesWhereACheckBeginsInMidRun) {
    Shaft shaft{0.02, [](double, double w, double) { return 0.03 * w + 0.1 * signOf(w); }};
    shaft.more = R"(, "range": [9, 19]},
                  {"name": "check", "role": "validate", "file": "run.csv", "time": "t", "range": [21.2, 29],
                   "inputs": {"tau": "tau"}, "outputs": {"w": "w"})";
    ASSERT_GT(std::abs(speedOf(shaft)[1060]), 4);
    const Finding finding = search(shaft);
    EXPECT_EQ(finding.kind, FindingKind::Effect);
    ASSERT_EQ(finding.effects.size(), 1u);
    EXPECT_EQ(finding.effects[0].kind, "friction.coulomb");
    const auto& check = finding.final.experiments.back();
    ASSERT_EQ(check.role, Role::Validate);
    ASSERT_EQ(check.outputs.size(), 1u);
    EXPECT_LT((check.outputs[0].simulated - check.outputs[0].measured).cwiseAbs().maxCoeff(), 0.3);
}

// The first part of a record is fitted, the rest of it is the check: it begins where the first part ends.
TEST_F(Discovery, EstimatesWhereTheRestOfARecordBegins) {
    Shaft shaft{0.02, [](double, double w, double) { return 0.03 * w + 0.1 * signOf(w); }};
    shaft.more = R"(, "range": [0, 19]},
                  {"name": "rest", "role": "validate", "file": "run.csv", "time": "t", "range": [21.2, 29],
                   "inputs": {"tau": "tau"}, "outputs": {"w": "w"})";
    const double speed = speedOf(shaft)[1060];
    ASSERT_GT(std::abs(speed), 4);
    const Finding finding = search(shaft);
    ASSERT_EQ(finding.effects.size(), 1u);
    EXPECT_EQ(finding.effects[0].kind, "friction.coulomb");
    const ExperimentState &before = finding.baseline.experiments.back(), &after = finding.final.experiments.back();
    ASSERT_EQ(after.starts.size(), 1u) << "of the angle the check says nothing";
    EXPECT_EQ(after.starts[0].name, "rotor.w.start");
    EXPECT_NEAR(after.starts[0].value, speed, 5 * after.starts[0].standardError);
    EXPECT_LT((after.outputs[0].simulated - after.outputs[0].measured).cwiseAbs().maxCoeff(), 0.3);
    EXPECT_EQ(before.starts.size(), 1u) << "before and after are told alike";
    EXPECT_LT(after.errorPercent, before.errorPercent);
    EXPECT_TRUE(std::any_of(finding.warnings.begin(), finding.warnings.end(),
                            [](const Text& w) { return w.english().starts_with("'rest' does not begin where"); }));
}

TEST_F(Discovery, WritesAStudyThatEstimatesWhereTheRestOfARecordBegins) {
    Shaft shaft{0.02, [](double, double w, double) { return 0.03 * w + 0.1 * signOf(w); }};
    shaft.more = R"(, "range": [0, 19]},
                  {"name": "rest", "role": "validate", "file": "run.csv", "time": "t", "range": [21.2, 29],
                   "inputs": {"tau": "tau"}, "outputs": {"w": "w"}, "initial": {"rotor.w": -10})";
    const Finding finding = search(shaft);
    const Outcome<RunResult> found = runDiscover(read(), {});
    ASSERT_TRUE(found) << format(found.diagnostics());
    const Study& completed = found->completed;
    ASSERT_EQ(completed.experiments.at(1).initial.size(), 1u);
    EXPECT_TRUE(std::holds_alternative<FittedStart>(completed.experiments[1].initial.at("rotor.w")));
    const Outcome<RunResult> again = runSimulate(completed, {});
    ASSERT_TRUE(again) << format(again.diagnostics());
    EXPECT_NEAR(again->finding.final.experiments.at(1).errorPercent, finding.final.experiments.at(1).errorPercent,
                1e-3);
}

TEST_F(Discovery, EstimatesNoStartOfACheckThatBeginsWhereTheModelDoes) {
    Shaft shaft{0.02, [](double, double w, double) { return 0.03 * w + 0.1 * signOf(w); }};
    shaft.more = R"(, "range": [0, 19]},
                  {"name": "check", "role": "validate", "file": "run.csv", "time": "t",
                   "inputs": {"tau": "tau"}, "outputs": {"w": "w"})";
    const Finding finding = search(shaft);
    EXPECT_EQ(finding.effects.size(), 1u);
    EXPECT_TRUE(finding.final.experiments.back().starts.empty());
}

// What a limit rounds off begins before it: a limit that hardly any command reaches seems to lie beyond all of them.
TEST_F(Discovery, FindsALimitThatHardlyAnyCommandReaches) {
    Shaft shaft{0.02, [](double, double w, double) { return 0.03 * w; }};
    shaft.limit = 1.034;
    const Finding finding = search(shaft);
    EXPECT_EQ(finding.kind, FindingKind::Effect);
    ASSERT_EQ(finding.effects.size(), 1u);
    EXPECT_EQ(finding.effects[0].kind, "actuator.saturation");
}

TEST_F(Discovery, FitsASpeedThatWasToldWrongly) {
    Shaft shaft{0.02, [](double, double w, double) { return 0.03 * w + 0.1 * signOf(w); }};
    shaft.more = R"(, "initial": {"rotor.w": 6})";
    const Finding finding = search(shaft);
    ASSERT_EQ(finding.effects.size(), 1u);
    EXPECT_EQ(finding.effects[0].kind, "friction.coulomb");
    EXPECT_TRUE(std::any_of(finding.warnings.begin(), finding.warnings.end(), [](const Text& w) {
        return w.english().find("rotor.w.start is") != std::string::npos &&
               w.english().find("not 6") != std::string::npos;
    }));
}

// Of a shaft that slows down from where the record begins, an offset of its tachometer and a constant torque would tell
// the same story.
TEST_F(Discovery, TakesARecordThatBeginsInMidRunForNoOffset) {
    Shaft shaft{0.4, [](double, double w, double) { return 0.08 * w; }};
    shaft.first = 450;
    shaft.recorded = 510;
    const double speed = speedOf(shaft)[450];
    ASSERT_GT(std::abs(speed), 2);
    const Finding finding = search(shaft, 0.0005);
    EXPECT_EQ(finding.kind, FindingKind::Adequate);
    EXPECT_TRUE(finding.effects.empty()) << finding.effects.front().kind;
    const auto start = std::find_if(finding.final.parameters.begin(), finding.final.parameters.end(),
                                    [](const FitEstimate& e) { return e.name == "rotor.w.start"; });
    ASSERT_NE(start, finding.final.parameters.end());
    EXPECT_NEAR(start->value, speed, 0.01);
}

// The drag differs a little from one direction to the other: a torque for a part of the record mends that, too, but it
// is no account of the friction and the constant torque.
TEST_F(Discovery, KeepsNamesWhoseFormsLeaveALittle) {
    Shaft shaft{0.4, [](double, double w, double) { return 0.08 * w + 0.15 * signOf(w) - 0.05 - 0.04 * std::abs(w); }};
    shaft.recorded = 500;
    const Finding finding = search(shaft, 0.001);
    ASSERT_EQ(finding.effects.size(), 2u);
    const bool isFrictionFirst = finding.effects[0].kind == "friction.coulomb";
    const AddedEffect &friction = finding.effects[isFrictionFirst ? 0 : 1],
                      &constant = finding.effects[isFrictionFirst ? 1 : 0];
    EXPECT_EQ(friction.kind, "friction.coulomb");
    EXPECT_NEAR(friction.parameters.at(0).value, 0.15, 0.01);
    EXPECT_EQ(constant.kind, "torque.constant");
    EXPECT_NEAR(constant.parameters.at(0).value, -0.05, 0.01);
}

TEST_F(Discovery, TakesNoiseWithAMemoryForNoise) {
    const auto viscous = [](double, double w, double) { return 0.03 * w; };
    const Finding noise = search({0.02, viscous}, 0.05, {}, 0.9);
    EXPECT_EQ(noise.kind, FindingKind::Adequate);
    EXPECT_TRUE(noise.effects.empty());
    EXPECT_TRUE(std::any_of(noise.warnings.begin(), noise.warnings.end(), [](const Text& t) {
        return t.english().find("noise with a memory") != std::string::npos;
    }));
    // a torque that nobody recorded comes and goes
    const auto rubbing = [](double t, double w, double) { return 0.03 * w + (std::sin(t * t / 12) > 0.6 ? 0.15 : 0); };
    const Finding left = search({0.02, rubbing}, 0.05, {}, 0.5);
    EXPECT_NE(left.kind, FindingKind::Adequate);
}

TEST_F(Discovery, LooksForALawOnceBesideTheSameModel) {
    // beside a torque that nobody recorded an effect is tried, and taken out again
    const auto unknown = [](double t) { return std::sin(t * t / 12) + std::sin(0.7 * t + 3 * std::cos(0.31 * t)); };
    search({0.02, [&](double t, double w, double) { return 0.03 * w + 0.003 * unknown(t); }}, 0.05);
    std::atomic<int> laws{};
    const Finding finding =
        discovered({}, Progress({}, [&](const Progress::Report& r) { laws += r.stage == "propose"; }));
    EXPECT_TRUE(finding.effects.empty());
    EXPECT_LE(laws, 2);
}

// Neither is clear beside what the other and an unequal drag leave, and all three are far above the noise.
TEST_F(Discovery, FindsTwoThatHideEachOtherBesideWhatHasNoName) {
    Shaft shaft{0.2, [](double, double w, double) { return 0.25 * w + 0.15 * signOf(w) + 0.1 + 0.05 * std::abs(w); }};
    shaft.recorded = 500;
    const Finding finding = search(shaft, 0.0005);
    EXPECT_EQ(finding.kind, FindingKind::Partial);
    std::set<std::string> kinds;
    for (const AddedEffect& e : finding.effects) kinds.insert(e.kind);
    EXPECT_TRUE(kinds.contains("friction.coulomb"));
    EXPECT_TRUE(kinds.contains("torque.constant") || kinds.contains("actuator.offset"));
    ASSERT_FALSE(finding.unexplained.remainders.empty());
    EXPECT_EQ(finding.unexplained.remainders.front().proposal.className, "Analogon.Effects.Proposals.UnequalDrag");
    EXPECT_LT(finding.unexplained.remainders.front().proposal.errors.fit, 0.05);
}

TEST_F(Discovery, FindsAConstantTorqueInNoiseWithAMemory) {
    const Finding finding = search({0.02, [](double, double w, double) { return 0.03 * w + 0.03; }}, 0.3, {}, 0.97);
    EXPECT_EQ(finding.kind, FindingKind::Effect);
    ASSERT_EQ(finding.effects.size(), 1u);
    EXPECT_EQ(finding.effects[0].kind, "torque.constant");
    EXPECT_NEAR(std::abs(finding.effects[0].parameters.at(0).value), 0.03, 0.01);
}

TEST_F(Discovery, TakesACommandThatIsHeldForNoDeadTime) {
    Shaft shaft;
    shaft.torque = [](double, double w, double) { return 0.03 * w; };
    shaft.isHeld = true;
    const Finding finding = search(shaft);
    EXPECT_TRUE(finding.effects.empty()) << finding.effects.front().kind;
    EXPECT_EQ(finding.kind, FindingKind::Adequate);
    const auto held = std::find_if(finding.warnings.begin(), finding.warnings.end(), [](const Text& w) {
        return w.english().find("held between its samples") != std::string::npos;
    });
    ASSERT_NE(held, finding.warnings.end());
    EXPECT_NE(held->find("\"interpolation\": \"hold\""), std::string::npos) << "the remedy is told";
}

TEST_F(Discovery, TakesAnInputThatIsStampedLateForNoEffect) {
    Shaft shaft{0.02, [](double, double w, double) { return 0.03 * w; }};
    shaft.late = step;
    const Finding finding = search(shaft);
    EXPECT_EQ(finding.kind, FindingKind::Adequate);
    EXPECT_TRUE(finding.effects.empty());
    const auto said = std::find_if(finding.warnings.begin(), finding.warnings.end(), [](const Text& w) {
        return w.english().find("the input 'tau' is stamped 0.0") != std::string::npos;
    });
    ASSERT_NE(said, finding.warnings.end());
    EXPECT_NEAR(std::stod(said->english().substr(said->english().find("0.0"))), shaft.late, 0.1 * step);
    const auto inertia = std::find_if(finding.final.parameters.begin(), finding.final.parameters.end(),
                                      [](const FitEstimate& e) { return e.name == "rotor.J"; });
    ASSERT_NE(inertia, finding.final.parameters.end());
    EXPECT_NEAR(inertia->value, 0.02, 0.0003);
}

TEST_F(Discovery, SaysWhyWhatWasTriedIsNotInTheModel) {
    const Finding finding = search({0.02, [](double, double w, double) { return 0.03 * w + 0.05 * signOf(w); }});
    ASSERT_EQ(finding.effects.size(), 1u);
    ASSERT_EQ(finding.effects[0].kind, "friction.coulomb");
    const auto reasonOf = [&](const std::string& kind, const std::string& at) {
        for (const CandidateResult& c : finding.candidates)
            if (c.kind == kind && c.at == at && c.round == 1) return c.reason.english();
        return std::string("not tried");
    };
    const std::string chosen = "friction.coulomb at " + finding.effects[0].at;
    EXPECT_EQ(reasonOf("friction.coulomb", finding.effects[0].at), "");
    EXPECT_EQ(reasonOf("drag.quadratic", finding.effects[0].at), "would need a strength of the wrong physical sign");
    EXPECT_TRUE(std::any_of(finding.candidates.begin(), finding.candidates.end(), [&](const CandidateResult& c) {
        return c.reason.english() == "explains less than " + chosen;
    }));
    EXPECT_EQ(reasonOf("inertia.added", finding.effects[0].at), "the data cannot show it: it only shifts rotor.J");
}

TEST_F(Discovery, FindsAnEffectBesideAnInputThatIsStampedLate) {
    Shaft shaft{0.02, [](double, double w, double) { return 0.03 * w + 0.12 * signOf(w); }};
    shaft.late = 2 * step;
    const Finding finding = search(shaft);
    ASSERT_EQ(finding.effects.size(), 1u);
    EXPECT_EQ(finding.effects[0].kind, "friction.coulomb");
    EXPECT_NEAR(finding.effects[0].parameters.at(0).value, 0.12, 0.006);
}

TEST_F(Discovery, LeavesSamplesOutThatAreFaultsOfTheMeasurement) {
    Shaft shaft;
    shaft.torque = [](double, double w, double) { return 0.03 * w; };
    shaft.spark = 6;
    const Finding right = search(shaft);
    EXPECT_TRUE(right.effects.empty()) << right.effects.front().kind;
    EXPECT_EQ(right.kind, FindingKind::Adequate);
    EXPECT_TRUE(std::any_of(right.warnings.begin(), right.warnings.end(), [](const Text& w) {
        return w.english().find("are taken for faults of the measurement") != std::string::npos;
    }));
    shaft.torque = [](double, double w, double) { return 0.03 * w + 0.05 * signOf(w); };
    const Finding lacking = search(shaft);
    EXPECT_EQ(lacking.kind, FindingKind::Effect) << "beside them a sure effect is none in part";
    ASSERT_EQ(lacking.effects.size(), 1u);
    EXPECT_EQ(lacking.effects.front().kind, "friction.coulomb");
}

TEST_F(Discovery, WritesALawForWhatASensorPicksUp) {
    Shaft shaft;
    shaft.torque = [](double, double w, double) { return 0.03 * w; };
    shaft.pickUp = 2;
    const Finding finding = search(shaft);
    EXPECT_TRUE(finding.effects.empty()) << finding.effects.front().kind;
    ASSERT_FALSE(finding.unexplained.remainders.empty());
    const Remainder& law = finding.unexplained.remainders.front();
    EXPECT_EQ(law.node, "output w");
    EXPECT_NE(law.proposal.equation.find("w = w_true + a1*tau"), std::string::npos) << law.proposal.equation;
    EXPECT_NE(law.proposal.equation.find("rad/(s.N.m)"), std::string::npos) << law.proposal.equation;
}

/// Whoever accepts the equation opens a study that runs as was told, and runs on.
TEST_F(Discovery, WritesAStudyWithTheEquationThatIsProposed) {
    Shaft shaft;
    shaft.torque = [](double, double w, double) { return 0.03 * w; };
    shaft.pickUp = 2;
    search(shaft);
    const Outcome<RunResult> result = runDiscover(read(), {});
    ASSERT_TRUE(result && result->finding.unexplained.proposed && !result->finding.unexplained.remainders.empty());
    EXPECT_TRUE(result->finding.effects.empty()) << "what is proposed is no effect that was added";
    EXPECT_EQ(result->finding.unexplained.remainders.size(), 1u) << "what it accounts for is not told again as left";
    EXPECT_NE(result->finding.unexplained.remainders.front().proposal.block.find("Icon("), std::string::npos)
        << "without one it would not be seen in the diagram";
    const double told = result->finding.unexplained.remainders.front().proposal.errors.fit;
    ASSERT_TRUE(writeResults(*result, "discover", directory_ / "out"));

    const Outcome<Study> proposed = readStudy(directory_ / "out" / "study-proposed");
    ASSERT_TRUE(proposed) << format(proposed.diagnostics());
    const Outcome<RunResult> simulated = runSimulate(*proposed, {});
    ASSERT_TRUE(simulated) << format(simulated.diagnostics());
    EXPECT_NEAR(errorPercentOf(simulated->finding.final, Role::Fit), told, 1e-3 * told);
    const Outcome<RunResult> again = runDiscover(*proposed, {});
    ASSERT_TRUE(again) << format(again.diagnostics());
    EXPECT_EQ(again->finding.kind, FindingKind::Adequate);
    EXPECT_EQ(std::count_if(again->finding.final.parameters.begin(), again->finding.final.parameters.end(),
                            [](const FitEstimate& e) { return e.name.ends_with(".a1"); }),
              1)
        << "its coefficient is fitted with the others";

    const Outcome<Study> completed = readStudy(directory_ / "out" / "study");
    ASSERT_TRUE(completed) << format(completed.diagnostics());
    EXPECT_EQ(completed->models.size(), 1u) << "the completed study does without";
}

TEST_F(Discovery, ChoosesNothingByValidation) {
    // a bench that pulled on one day and pushed on the next
    const auto pulled = [](double by) { return Shaft{0.02, [by](double, double w, double) { return 0.03 * w + by; }}; };
    const Finding alone = search(pulled(0.1));
    ASSERT_EQ(alone.effects.size(), 1u);
    EXPECT_EQ(alone.effects.front().kind, "torque.constant");

    std::ifstream file(directory_ / "study.json");
    std::string study{std::istreambuf_iterator<char>(file), {}};
    const std::string end = "\"outputs\": {\"w\": \"w\"}}";
    study.replace(study.find(end), end.size(),
                  end + R"(, {"name": "next day", "role": "validate", "file": "next.csv", "time": "t",
                   "inputs": {"tau": "tau"}, "outputs": {"w": "w"}})");
    put("study.json", study);
    std::ofstream csv = recording("t [s],tau [N.m],w [rad/s]", "next.csv");
    const std::vector<double> speed = speedOf(pulled(-0.1));
    for (int k = 0; k < samples; ++k)
        csv << k * step << ',' << excitation(k * step) << ',' << speed[static_cast<std::size_t>(k)] << '\n';
    csv.close();
    const Finding beside = discovered();
    ASSERT_EQ(beside.effects.size(), 1u);
    EXPECT_EQ(beside.effects.front().kind, "torque.constant");
    EXPECT_EQ(beside.effects.front().parameters.front().value, alone.effects.front().parameters.front().value);
    // but people are told
    EXPECT_GT(errorPercentOf(beside.final, Role::Validate), errorPercentOf(beside.baseline, Role::Validate));
    EXPECT_TRUE(std::any_of(beside.warnings.begin(), beside.warnings.end(), [](const Text& warning) {
        return warning.english().find("next day") != std::string::npos;
    }));
}

/// A heated plate whose model cools to a room alone.
class DiscoveryOnAPlate : public Discovery {
protected:
    /// `fitted`: the study's "parameters".
    void writeStudy(double room, const std::string& fitted) {
        put("model.mo", fmt::format(R"(model Plate
  Analogon.Interfaces.RealInput P(unit="W");
  Analogon.Interfaces.RealOutput T(unit="K");
  Analogon.Sources.PrescribedHeatFlow heater;
  Analogon.Thermal.HeatCapacitor plate(C=20, T_start={0});
  Analogon.Thermal.ThermalConductor toRoom(G=0.3);
  Analogon.Sources.FixedTemperature room(T={0});
  Analogon.Sensors.TemperatureSensor thermometer;
equation
  connect(P, heater.Q_flow);
  connect(heater.port, plate.port);
  connect(plate.port, toRoom.port_a);
  connect(toRoom.port_b, room.port);
  connect(plate.port, thermometer.port);
  connect(thermometer.T, T);
end Plate;
)",
                                    room));
        put("study.json", R"({"format": "analogon-study-1", "class": "Plate",
  "experiments": [{"name": "run", "role": "fit", "file": "run.csv", "time": "t",
                   "inputs": {"P": "P"}, "outputs": {"T": "T"}}],
  "parameters": )" + fitted + '}');
    }

    /// The plate's temperature [K] after a sample; the power goes from one value to the next, `taken` [W] is lost.
    template <class Flow>
    static double after(double temperature, double power, double next, const Flow& taken) {
        constexpr int inner = 10;
        for (int i = 0; i < inner; ++i)
            temperature += interval / inner * (power + (next - power) * (i + 0.5) / inner - taken(temperature)) / 15;
        return temperature;
    }

    static constexpr double interval = 0.5;  // [s]
};

// Adjusted in ice water, it amplifies what it reads in degrees Celsius.
TEST_F(DiscoveryOnAPlate, FindsTheGainOfAThermometerThatIsRightAtFreezing) {
    writeStudy(300, R"({"plate.C": {"fit": true, "min": 1, "max": 200}})");
    std::mt19937 random(9);
    std::normal_distribution<double> normal;
    std::ofstream csv = recording("t [s],P [W],T [degC]");
    double temperature = 300;  // [K]
    for (int k = 0; k < samples; ++k) {
        const double here = 20 + 20 * excitation(0.02 * k), next = 20 + 20 * excitation(0.02 * (k + 1));
        csv << interval * k << ',' << here << ',' << 1.05 * (temperature - 273.15) + 0.2 * normal(random) << '\n';
        temperature = after(temperature, here, next, [&](double T) { return 0.3 * (T - 300); });
    }
    csv.close();
    const Finding finding = discovered();
    EXPECT_EQ(finding.kind, FindingKind::Effect);
    ASSERT_EQ(finding.effects.size(), 1u);
    EXPECT_EQ(finding.effects[0].kind, "sensor.gain");
    EXPECT_EQ(finding.effects[0].className, "Analogon.Effects.Sensor.CelsiusGain");
    EXPECT_NEAR(valueOf(finding.effects[0], "g"), 0.05, 0.002);
}

// A thermostat opens; radiation and a heat of evaporation would imitate it together.
TEST_F(DiscoveryOnAPlate, ProposesALossThatSetsInAboveATemperature) {
    writeStudy(300,
               R"({"plate.C": {"fit": true, "min": 1, "max": 200}, "toRoom.G": {"fit": true, "min": 0.01, "max": 5}})");
    std::mt19937 random(9);
    std::normal_distribution<double> normal;
    std::ofstream csv = recording("t [s],P [W],T [K]");
    double temperature = 300;
    for (int k = 0; k < samples; ++k) {
        const double here = 20 + 20 * excitation(0.02 * k), next = 20 + 20 * excitation(0.02 * (k + 1));
        csv << interval * k << ',' << here << ',' << temperature + 0.3 * normal(random) << '\n';
        temperature =
            after(temperature, here, next, [](double T) { return 0.3 * (T - 300) + 0.15 * std::max(0.0, T - 360); });
    }
    csv.close();
    const Finding finding = discovered();
    EXPECT_TRUE(finding.effects.empty()) << finding.effects.front().kind;
    ASSERT_FALSE(finding.unexplained.remainders.empty());
    const std::string& equation = finding.unexplained.remainders.front().proposal.equation;
    EXPECT_EQ(finding.unexplained.remainders.front().proposal.className, "Analogon.Effects.Proposals.HeatValve")
        << equation;
    const auto at = equation.find("T_o = ");
    ASSERT_NE(at, std::string::npos) << equation;
    EXPECT_NEAR(std::stod(equation.substr(at + 6)), 360, 2);
}

/// In a draught that nobody measures. The model begins at 300 K.
class DiscoveryInADraught : public DiscoveryOnAPlate {
protected:
    Finding search(unsigned seed, double strength = 0.7, double begin = 300, double inputNoise = 0,
                   const std::string& fitted = R"({"plate.C": {"fit": true, "min": 1, "max": 200},
                       "toRoom.G": {"fit": true, "value": 0.2, "min": 0.01, "max": 5}})") {
        writeStudy(300, fitted);
        std::mt19937 random(seed);
        std::normal_distribution<double> normal;
        std::ofstream csv = recording("t [s],P [W],T [K]");
        double temperature = begin, draught = 0;  // [K], [W]
        for (int k = 0; k < samples; ++k) {
            const double here = 20 + 20 * excitation(0.02 * k), next = 20 + 20 * excitation(0.02 * (k + 1));
            csv << interval * k << ',' << here + inputNoise * normal(random) << ','
                << temperature + 0.1 * normal(random) << '\n';
            draught = 0.96 * draught + strength * normal(random);
            temperature = after(temperature, here, next, [&](double T) { return 0.3 * (T - 300) - draught; });
        }
        csv.close();
        return discovered();
    }
};

TEST_F(DiscoveryInADraught, GivesItNoName) {
    // a drift of the sensor and a limit of the heater imitate the last two well
    for (const unsigned seed : {1u, 20u, 54u}) {
        const Finding finding = search(seed);
        EXPECT_TRUE(finding.effects.empty()) << finding.effects.front().kind << " for seed " << seed;
        EXPECT_EQ(finding.kind, FindingKind::Unexplained);
        ASSERT_FALSE(finding.unexplained.remainders.empty());
        EXPECT_EQ(finding.unexplained.remainders.front().node, "heater.port") << "one node with the plate's";
    }
}

TEST_F(DiscoveryInADraught, TakesAWrongStartForNoEffect) {
    for (const double begin : {300.5, 312.0}) {
        const Finding finding = search(3, 0, begin);
        EXPECT_TRUE(finding.effects.empty()) << finding.effects.front().kind << " for " << begin;
        EXPECT_EQ(finding.kind, FindingKind::Adequate);
        const auto start = std::find_if(finding.final.parameters.begin(), finding.final.parameters.end(),
                                        [](const FitEstimate& e) { return e.name == "plate.T_start"; });
        ASSERT_NE(start, finding.final.parameters.end());
        EXPECT_EQ(start->experiment, 0);
        EXPECT_NEAR(start->value, begin, 5 * start->standardError);
        EXPECT_LT(start->standardError, 0.1);
        const bool isTold = std::any_of(finding.warnings.begin(), finding.warnings.end(), [](const std::string& w) {
            return w.find("'run' does not begin where the model was told: plate.T_start") != std::string::npos;
        });
        EXPECT_TRUE(isTold);
    }
}

TEST_F(DiscoveryInADraught, TakesTheNoiseOfAnInputForNoEffect) {
    int told = 0;
    for (const unsigned seed : {1u, 2u, 3u}) {
        const Finding finding = search(seed, 0, 300, 15);
        EXPECT_TRUE(finding.effects.empty()) << finding.effects.front().kind << " for seed " << seed;
        told += std::any_of(finding.warnings.begin(), finding.warnings.end(), [](const std::string& w) {
            return w.find("the input 'P' of 'run' is recorded with noise") != std::string::npos;
        });
    }
    EXPECT_GE(told, 2) << "where it shows at all";
}

TEST_F(DiscoveryInADraught, LeavesARightStartAsItIsTold) {
    const Finding finding = search(4, 0);
    EXPECT_EQ(finding.kind, FindingKind::Adequate);
    for (const FitEstimate& e : finding.final.parameters) EXPECT_LT(e.experiment, 0) << e.name;
}

/// On a mount that takes heat away.
class DiscoveryOnAMount : public DiscoveryOnAPlate {
protected:
    /// `column`: of the mount's temperature; empty: it is not recorded.
    Finding search(const std::function<double(double t)>& mount, const std::string& column) {
        writeStudy(290, R"({"plate.C": {"fit": true, "min": 1, "max": 200}})");
        std::mt19937 random(5);
        std::normal_distribution<double> normal;
        std::ofstream csv = recording("t [s],P [W],T [K]" + (column.empty() ? "" : ',' + column + " [degC]"));
        double temperature = 290;  // [K]
        for (int k = 0; k < samples; ++k) {
            const double here = 10 + 10 * excitation(0.02 * k), next = 10 + 10 * excitation(0.02 * (k + 1));
            const double t = interval * k;
            csv << t << ',' << here << ',' << temperature + 0.1 * normal(random);
            if (!column.empty()) csv << ',' << mount(t) - 273.15;
            csv << '\n';
            temperature =
                after(temperature, here, next, [&](double T) { return 0.3 * (T - 290) + 0.1 * (T - mount(t)); });
        }
        csv.close();
        return discovered();
    }

    static double valueOf(const AddedEffect& effect, const std::string& name) {
        for (const auto& p : effect.parameters)
            if (p.name == name) return p.value;
        return std::nan("");
    }
};

TEST_F(DiscoveryOnAMount, FindsALossToSurroundingsOfAnyTemperature) {
    const Finding finding = search([](double) { return 258.0; }, "");
    ASSERT_EQ(finding.effects.size(), 1u);
    const AddedEffect& loss = finding.effects.front();
    EXPECT_EQ(loss.kind, "thermal.loss");
    EXPECT_EQ(finding.kind, FindingKind::Effect);
    EXPECT_NEAR(valueOf(loss, "G"), 0.1, 0.005);
    EXPECT_NEAR(valueOf(loss, "T_amb"), 258, 1);
    for (const Alternative& a : loss.instead.effects) EXPECT_NE(a.kind, loss.kind);
}

TEST_F(DiscoveryOnAMount, FindsALossToARecordedTemperature) {
    // a column may be called by a word of the language
    for (const std::string column : {"mount", "flow"}) {
        const Finding finding = search([](double t) { return 270 + 15 * std::sin(0.02 * t); }, column);
        ASSERT_EQ(finding.effects.size(), 1u) << column;
        const AddedEffect& loss = finding.effects.front();
        EXPECT_EQ(loss.kind, "thermal.loss");
        EXPECT_EQ(loss.wired.channel, column);
        EXPECT_EQ(finding.kind, FindingKind::Effect);
        EXPECT_NEAR(valueOf(loss, "G"), 0.1, 0.005);
    }
}

// A conductance that is known 5 % wrongly looks like a gain of the heater.
TEST_F(DiscoveryInADraught, SaysThatAHeldParameterWouldExplainAsMuch) {
    const std::string held =
        R"({"plate.C": {"fit": true, "min": 1, "max": 200}, "toRoom.G": {"fit": false, "value": 0.315}})";
    const Finding finding = search(6, 0, 300, 0, held);
    const std::string said = std::accumulate(finding.warnings.begin(), finding.warnings.end(), std::string(),
                                             [](const std::string& all, const std::string& w) { return all + w; });
    EXPECT_FALSE(finding.effects.empty());
    const std::string before = "another value of toRoom.G, which is held at 0.315: ";
    const std::size_t at = said.find(before);
    ASSERT_NE(at, std::string::npos) << said;
    EXPECT_NEAR(std::stod(said.substr(at + before.size())), 0.3, 0.001);
}

TEST_F(DiscoveryInADraught, SaysThatAnotherValueOfAHeldParameterExplainsMoreThanAnyEffect) {
    // no effect takes heat capacity away
    const std::string held =
        R"({"plate.C": {"fit": false, "value": 60}, "toRoom.G": {"fit": true, "value": 0.2, "min": 0.01, "max": 5}})";
    const Finding finding = search(6, 0, 300, 0, held);
    EXPECT_TRUE(finding.effects.empty()) << finding.effects.front().kind;
    EXPECT_EQ(finding.kind, FindingKind::Unexplained);
    ASSERT_FALSE(finding.unexplained.remainders.empty());
    const std::string& equation = finding.unexplained.remainders.front().proposal.equation;
    ASSERT_EQ(equation.find("plate.C = "), 0u) << equation;
    EXPECT_NEAR(std::stod(equation.substr(10)), 15, 0.1);
}

// A bound below the true conductance: another way for the heat looks like what lies beyond it.
TEST_F(DiscoveryInADraught, SaysThatABoundIsTooNarrowWhereAnEffectImitatesWhatLiesBeyond) {
    const std::string bound =
        R"({"plate.C": {"fit": true, "min": 1, "max": 200}, "toRoom.G": {"fit": true, "value": 0.1, "min": 0.01, "max": 0.2}})";
    const Finding finding = search(6, 0, 300, 0, bound);
    std::string said;
    for (const Text& warning : finding.warnings) said += warning;
    for (const Remainder& r : finding.unexplained.remainders) said += r.proposal.equation;
    const std::string before = finding.effects.empty() ? "toRoom.G = " : "toRoom.G beyond its bound of 0.2: ";
    const std::size_t at = said.find(before);
    ASSERT_NE(at, std::string::npos) << said;
    EXPECT_NEAR(std::stod(said.substr(at + before.size())), 0.3, 0.001) << said;
    for (const AddedEffect& e : finding.effects)
        for (const std::string& value : e.instead.values)
            EXPECT_NEAR(std::stod(value.substr(value.find(" = ") + 3)), 0.3, 0.001) << value;
}

/// A motor whose current settles within two samples, under a voltage that is drawn anew every 50 samples.
class DiscoveryInADrive : public Discovery {
protected:
    /// `friction`: of the bearing [N.m.s/rad]; `fitted`: parameters besides resistance and torque constant.
    void record(int count, double friction, const std::string& motor, const std::string& rotor, const std::string& load,
                const std::string& fitted) {
        put("model.mo", machineModel("u", motor, rotor, load));
        put("study.json", R"({"format": "analogon-study-1", "class": "Drive",
  "experiments": [{"name": "run", "role": "fit", "file": "run.csv", "time": "t",
                   "inputs": {"u": "u"}, "outputs": {"i": "i", "w": "w"}}],
  "parameters": {"motor.R": {"fit": true, "min": 0.1, "max": 5}, "motor.k": {"fit": true, "min": 0.001, "max": 0.5})" +
                              fitted + "}}");
        constexpr int inner = 20, steady = 50;
        constexpr double interval = 1e-3, h = interval / inner;
        constexpr double R = 0.8, L = 1.6e-3, k = 0.03, J = 5e-5;
        const double b = friction;
        std::mt19937 random(3);
        std::uniform_real_distribution<double> level(-6, 12);
        std::normal_distribution<double> normal;
        std::vector<double> voltage;
        for (double u = 0; static_cast<int>(voltage.size()) <= count; voltage.push_back(u))
            if (voltage.size() % steady == 0) u = level(random);
        std::ofstream csv(directory_ / "run.csv");
        csv.precision(8);
        csv << "t [s],u [V],i [A],w [rad/s]\n";
        double i = 0, w = 0;
        for (std::size_t n = 0; static_cast<int>(n) < count; ++n) {
            csv << interval * static_cast<double>(n) << ',' << voltage[n] << ',' << i + 0.05 * normal(random) << ','
                << w + 0.5 * normal(random) << '\n';
            for (int s = 0; s < inner; ++s) {
                const double u = voltage[n] + (voltage[n + 1] - voltage[n]) * (s + 0.5) / inner;
                const double iHalf = i + 0.5 * h * (u - R * i - k * w) / L, wHalf = w + 0.5 * h * (k * i - b * w) / J;
                i += h * (u - R * iHalf - k * wHalf) / L;
                w += h * (k * iHalf - b * wHalf) / J;
            }
        }
    }
};

// Its long record is searched on means of five. Nothing is missing, but on means a delay of the speed would mend what
// they blur.
TEST_F(DiscoveryInADrive, TakesForNoEffectWhatOnlyMeansOfSamplesShow) {
    record(26001, 1e-4, "R=0.6, L=1e-3, k=0.025", "J=4e-5", "ViscousLoad load(b=2e-4)",
           R"(, "motor.L": {"fit": true, "min": 1e-4, "max": 1e-2}, "rotor.J": {"fit": true, "min": 1e-6, "max": 1e-3},
                 "load.b": {"fit": true, "min": 1e-6, "max": 1e-2})");
    const Finding finding = discovered({"sensor.delay"});
    EXPECT_TRUE(finding.effects.empty()) << finding.effects.front().kind;
    EXPECT_EQ(finding.kind, FindingKind::Adequate);
    // on the means it was more than chance: the search works on the first part of the record instead
    const bool wasChosen = std::any_of(finding.candidates.begin(), finding.candidates.end(),
                                       [](const CandidateResult& c) { return c.deltaBic.value_or(0) < -100; });
    EXPECT_FALSE(wasChosen);
    const bool isInPart = std::any_of(finding.warnings.begin(), finding.warnings.end(),
                                      [](const Text& w) { return w.find("first part") != std::string::npos; });
    EXPECT_TRUE(isInPart);
}

TEST_F(DiscoveryInADrive, TakesOneWrongValueForNoTwoEffects) {
    // a wrong scale of the speed and more friction make up for too large an inertia together
    record(2001, 4e-4, "R=0.6, L=1.6e-3, k=0.025", "J=7e-5", "ViscousLoad load(b=4e-4)", "");
    const Finding finding = discovered();
    EXPECT_TRUE(finding.effects.empty()) << finding.effects.front().kind;
    ASSERT_FALSE(finding.unexplained.remainders.empty());
    const Remainder& told = finding.unexplained.remainders.front();
    ASSERT_EQ(told.proposal.equation.english().find("rotor.J = "), 0u) << told.proposal.equation;
    EXPECT_NEAR(std::stod(told.proposal.equation.english().substr(10)), 5e-5, 5e-7);
    EXPECT_GT(told.proposal.errors.fit, 0);
    EXPECT_GT(told.evidence, 1000);
    EXPECT_LT(told.proposal.errors.fit, 0.1 * finding.final.experiments.front().errorPercent);
}

/// A dry friction that a constant torque hides.
const Shaft dryShaft{0.02, [](double, double w, double) { return 0.03 * w + 0.04 * signOf(w) - 0.05; }};

TEST_F(Discovery, FindsTwoEffectsThatHideEachOther) {
    const Finding finding = search(dryShaft);
    ASSERT_EQ(finding.effects.size(), 2u);
    for (const AddedEffect& e : finding.effects) {
        if (e.kind == "friction.coulomb") {
            EXPECT_NEAR(e.parameters.front().value, 0.04, 0.004);
        } else {
            // a load torque and an offset of the commanded torque are the same thing here
            EXPECT_TRUE(e.kind == "torque.constant" || e.kind == "actuator.offset") << e.kind;
            EXPECT_NEAR(std::abs(e.parameters.front().value), 0.05, 0.005);
        }
        // each is judged by what the model is without it
        EXPECT_GT(e.evidence.errorPercentBefore, 1.2 * e.evidence.errorPercentAfter) << e.kind;
        EXPECT_GT(e.evidence.heldOut, 0.5);
    }
    EXPECT_EQ(finding.kind, FindingKind::Effect);
    EXPECT_NE(finding.nextExperiment.find("no programme"), std::string::npos)
        << "an offset of the command and a load torque are one to every experiment: " << finding.nextExperiment;
}

TEST_F(Discovery, EndsTheSameOnAnyNumberOfThreads) {
    const Finding first = search(dryShaft);
    ASSERT_EQ(first.effects.size(), 2u) << "to be judged side by side";
    std::vector<std::string> decided;  // by the first
    for (const int threads : {1, 3}) {
        RunOptions options;
        options.discover.threads = threads;
        options.discover.trace = std::make_shared<DecisionTrace>();
        const Outcome<RunResult> result = runDiscover(read(), options);
        ASSERT_TRUE(result) << format(result.diagnostics());
        const Finding& finding = result->finding;
        EXPECT_EQ(finding.final.modelText, first.final.modelText) << "to the last digit";
        ASSERT_EQ(finding.effects.size(), first.effects.size());
        for (std::size_t i = 0; i < first.effects.size(); ++i) {
            const Evidence &a = finding.effects[i].evidence, &b = first.effects[i].evidence;
            EXPECT_EQ(finding.effects[i].kind, first.effects[i].kind);
            EXPECT_EQ(a.score, b.score);
            EXPECT_EQ(a.deltaBic, b.deltaBic);
            EXPECT_EQ(a.heldOut, b.heldOut);
            EXPECT_EQ(a.errorPercentBefore, b.errorPercentBefore);
        }
        ASSERT_EQ(finding.candidates.size(), first.candidates.size());
        for (std::size_t i = 0; i < first.candidates.size(); ++i) {
            const CandidateResult &a = finding.candidates[i], &b = first.candidates[i];
            EXPECT_EQ(a.kind + " at " + a.at, b.kind + " at " + b.at);
            EXPECT_EQ(a.round, b.round) << a.kind << " at " << a.at;
            EXPECT_EQ(a.screening.score, b.screening.score) << a.kind << " at " << a.at;
            EXPECT_EQ(a.deltaBic, b.deltaBic) << a.kind << " at " << a.at;
            EXPECT_EQ(a.reason.english(), b.reason.english()) << a.kind << " at " << a.at;
        }
        std::vector<std::string> lines;
        for (const Decision& d : options.discover.trace->decisions()) lines.push_back(decisionLine(d, lines.size()));
        if (decided.empty()) decided = lines;
        EXPECT_EQ(lines, decided);
    }
}

TEST_F(Discovery, TellsWhatItDecided) {
    const Finding untraced = search({0.02, [](double, double w, double) { return 0.03 * w + 0.1 * signOf(w); }});
    RunOptions options;
    options.discover.trace = std::make_shared<DecisionTrace>();
    const Outcome<RunResult> result = runDiscover(read(), options);
    ASSERT_TRUE(result) << format(result.diagnostics());
    const Finding& finding = result->finding;
    EXPECT_EQ(finding.final.modelText, untraced.final.modelText) << "whoever asks changes nothing";
    const std::vector<Decision> decisions = options.discover.trace->decisions();
    const auto countOf = [&](const std::string& what, const std::string& verdict = "", const std::string& key = "") {
        return std::count_if(decisions.begin(), decisions.end(), [&](const Decision& d) {
            return d.step == what && (verdict.empty() || d.verdict == verdict) && d.key.starts_with(key);
        });
    };
    ASSERT_EQ(finding.effects.size(), 1u);
    const std::string found = finding.effects[0].className + "@" + finding.effects[0].at;
    EXPECT_EQ(decisions.front().step, "null fit");
    EXPECT_EQ(countOf("choose", "chosen", found), 1);
    EXPECT_EQ(countOf("found", "reported", found), 1);
    EXPECT_EQ(decisions.back().step, "finding");
    EXPECT_EQ(decisions.back().verdict, "effect");
    for (const CandidateResult& c : finding.candidates) {  // every line of the table was screened, and judged
        EXPECT_GE(countOf("screen", "", c.className + "@" + c.at), 1) << c.kind << " at " << c.at;
        EXPECT_GE(countOf("judge", "", c.className + "@" + c.at), 1) << c.kind << " at " << c.at;
    }
    EXPECT_GT(countOf("trial", "refitted"), 0);
    EXPECT_EQ(countOf("path", "begun"), countOf("path") - countOf("path", "begun")) << "each path that begins ends";
}

TEST_F(Discovery, EndsAtItsLimitOfWorkAsIfStopped) {
    const Finding whole = search(dryShaft);
    ASSERT_EQ(whole.effects.size(), 2u);
    std::string text;
    for (const int threads : {1, 3}) {
        RunOptions options;
        options.discover.threads = threads;
        options.discover.mostWork = 1;
        const Outcome<RunResult> result = runDiscover(read(), options);
        ASSERT_TRUE(result) << format(result.diagnostics());
        EXPECT_TRUE(result->finding.end.interrupted);
        EXPECT_LT(result->finding.effects.size(), 2u);
        EXPECT_FALSE(result->finding.final.experiments.empty());
        if (text.empty()) text = result->finding.final.modelText;
        EXPECT_EQ(result->finding.final.modelText, text);
    }
}

/// A housing in coolant, heated through a wall; the model knows no loss to the room and believes the thermometer.
class DiscoveryInCoolant : public Discovery {
protected:
    /// `steep`: power of the pressure in the room by which the contact with the coolant moves.
    Finding searchHousing(double loss, double offset, double steep = 0) {
        put("model.mo", R"(model Heater
  Analogon.Interfaces.RealInput P(unit="W");
  Analogon.Interfaces.RealInput T_cool(unit="K");
  Analogon.Interfaces.RealOutput T(unit="K");
  Analogon.Sources.PrescribedHeatFlow heater;
  Analogon.Thermal.HeatCapacitor core(C=250);
  Analogon.Thermal.ThermalConductor wall(G=30);
  Analogon.ThermalFluid.BasicThermalFluid jacket(C=350, c_o=40, A=0.06);
  Analogon.Sources.PrescribedTemperature coolant;
  Analogon.Sensors.TemperatureSensor thermometer;
equation
  connect(P, heater.Q_flow);
  connect(heater.port, core.port);
  connect(core.port, wall.port_a);
  connect(wall.port_b, jacket.solid);
  connect(jacket.fluid, coolant.port);
  connect(T_cool, coolant.T);
  connect(jacket.solid, thermometer.port);
  connect(thermometer.T, T);
end Heater;
)");
        put("study.json", R"({"format": "analogon-study-1", "class": "Heater",
  "experiments": [{"name": "run", "role": "fit", "file": "run.csv", "time": "t",
                   "inputs": {"P": "P", "T_cool": "T_cool"}, "outputs": {"T": "T"},
                   "initial": {"core.T_start": "T_cool", "jacket.T_start": "T_cool"}}],
  "parameters": {"core.C": {"fit": true, "min": 2, "max": 5000}, "wall.G": {"fit": true, "min": 0.5, "max": 2000},
                 "jacket.C": {"fit": true, "min": 4, "max": 10000},
                 "jacket.c_o": {"fit": true, "min": 0.3, "max": 2000}}})");
        constexpr double interval = 0.2, room = 293.15;  // [s], [K]
        constexpr double core = 270, wall = 36, jacket = 350, contact = 44 * 0.06;
        const auto power = [](int k) {
            const double levels[] = {0, 1800, 600, 2400, 300, 1500, 2700, 900};
            return levels[k / 200 % 8] + 100 * std::sin(0.31 * interval * k);
        };
        const auto coolant = [](int k) {
            const double t = interval * k;
            return room + 12 * (1 - std::exp(-t / 90)) + (t > 20 ? 25 * std::sin(0.037 * t) : 0);
        };
        std::mt19937 random(2);
        std::normal_distribution<double> scatter(0, 0.1);
        const auto pressure = [](int k) { return 1004 + std::sin(0.021 * k) + 0.5 * std::sin(0.0073 * k); };  // [hPa]
        std::ofstream csv = recording("t [s],P [W],T_cool [K],T [K],p_room [hPa]");
        double inside = room, shell = room;
        for (int k = 0; k <= 2000; ++k) {
            csv << interval * k << ',' << power(k) << ',' << coolant(k) << ',' << shell + offset + scatter(random)
                << ',' << pressure(k) << '\n';
            const double held = contact * std::pow(pressure(k) / 1004, steep);
            constexpr int inner = 20;
            for (int m = 0; m < inner; ++m) {
                const double a = (m + 0.5) / inner, h = interval / inner;
                const double fluid = (1 - a) * coolant(k) + a * coolant(k + 1);
                const double through = wall * (inside - shell);
                const double away = held * std::pow(fluid / 3.6, 0.78) * (shell - fluid) + loss * (shell - room);
                inside += h * ((1 - a) * power(k) + a * power(k + 1) - through) / core;
                shell += h * (through - away) / jacket;
            }
        }
        csv.close();
        return discovered();
    }
};

TEST_F(DiscoveryInCoolant, TakesAnOffsetForNoGainBesideALoss) {
    const Finding finding = searchHousing(5, -3);
    EXPECT_EQ(finding.kind, FindingKind::Effect);
    ASSERT_EQ(finding.effects.size(), 2u);
    for (const AddedEffect& e : finding.effects) {
        EXPECT_TRUE(e.kind == "sensor.offset" || e.kind == "thermal.loss") << e.kind;
        EXPECT_NEAR(e.parameters.front().value, e.kind == "sensor.offset" ? -3 : 5, 0.1);
        EXPECT_EQ(e.parameters.front().unit, e.kind == "sensor.offset" ? "K" : "W/K");
    }
}

// A thousandth of the pressure moves the heat transfer by a third: nothing that flows does so.
TEST_F(DiscoveryInCoolant, TakesNothingForAFlowThatWouldActWithAnAbsurdPower) {
    const Finding finding = searchHousing(0, 0, 300);
    EXPECT_EQ(finding.kind, FindingKind::Unexplained);
    for (const AddedEffect& e : finding.effects) ADD_FAILURE() << e.kind << " at " << e.at;
    EXPECT_FALSE(finding.unexplained.remainders.empty());
}

/// A heater in still air at a driver.
class DiscoveryInAHeater : public Discovery {
protected:
    struct Heater {
        double power{1e9};  // [W] that the driver gives at most
        double bend{};      // [1/K2] of the resistance
        double film{};      // [Ohm] in its plug, half of it left at 1 A
        double event{};     // [W] that it takes up for a while
    };

    Finding searchHeater(const Heater& heater, bool isTemperatureMeasured = true) {
        put("model.mo", R"(model Heater
  Analogon.Interfaces.RealInput v(unit="V");
  Analogon.Interfaces.RealOutput i(unit="A");
  Analogon.Interfaces.RealOutput T(unit="K");
  Analogon.ElectricThermal.BasicElectricThermal coil(R=2, alpha=2e-3, T_ref=293.15);
  Analogon.Thermal.HeatCapacitor body(C=8);
  Analogon.Thermal.ThermalConductor loss(G=0.2);
  Analogon.Sources.FixedTemperature room(T=293.15);
  Analogon.Sensors.TemperatureSensor thermometer;
equation
  connect(v, coil.v);
  connect(coil.i, i);
  connect(coil.heatPort, body.port);
  connect(body.port, loss.port_a);
  connect(loss.port_b, room.port);
  connect(body.port, thermometer.port);
  connect(thermometer.T, T);
end Heater;
)");
        put("study.json", R"({"format": "analogon-study-1", "class": "Heater",
  "experiments": [{"name": "run", "role": "fit", "file": "run.csv", "time": "t",
                   "inputs": {"v": "v"}, "outputs": {"i": "i")" +
                              std::string(isTemperatureMeasured ? R"(, "T": "T")" : "") +
                              R"(}, "initial": {"body.T_start": 293.15}}],
  "parameters": {"coil.R": {"fit": true, "min": 0.2, "max": 20}, "coil.alpha": {"fit": true, "min": 1e-4, "max": 0.02},
                 "body.C": {"fit": true, "min": 0.5, "max": 100}, "loss.G": {"fit": true, "min": 0.01, "max": 5}}})");
        constexpr double R = 2.3, alpha = 3e-3, C = 9, G = 0.15, room = 293.15, interval = 0.05;
        const auto supply = [&](int k) {
            const double levels[] = {6, 12, 3, 9, 14, 5, 11, 2};
            const double level = heater.event == 0 ? levels[k / 150 % 8] : k < 900 ? 5 + k / 450 : 13;
            return level + 0.5 * std::sin(0.9 * interval * k);
        };
        std::mt19937 random(3);
        std::normal_distribution<double> scatter;
        std::ofstream csv = recording(isTemperatureMeasured ? "t [s],v [V],i [A],T [K]" : "t [s],v [V],i [A]");
        double T = room;
        const auto resistance = [&] { return R * (1 + alpha * (T - room) + heater.bend * (T - room) * (T - room)); };
        const auto current = [&](double v) {
            double i = 0;
            // the film conducts as the current it takes has made it
            for (int pass = 0; pass < 40; ++pass) {
                const double next = v / (resistance() + heater.film / (1 + i));
                if (heater.film == 0) return std::min(next, std::sqrt(heater.power / resistance()));
                i = next;
            }
            return i;
        };
        for (int k = 0; k <= 1800; ++k) {
            csv << interval * k << ',' << supply(k) << ',' << current(supply(k)) + 0.02 * scatter(random);
            if (isTemperatureMeasured) csv << ',' << T + 0.5 * scatter(random);
            csv << '\n';
            constexpr int inner = 20;
            for (int m = 0; m < inner; ++m) {
                const double a = (m + 0.5) / inner, h = interval / inner;
                const double i = current((1 - a) * supply(k) + a * supply(k + 1));
                const double more = std::abs(interval * (k + a) - 58) < 8 ? heater.event : 0;
                T += h * (resistance() * i * i - G * (T - room) + more) / C;
            }
        }
        csv.close();
        return discovered();
    }
};

TEST_F(DiscoveryInAHeater, TakesWhatHappensOnceForNoMelting) {
    const Finding finding = searchHeater({.event = -10}, false);
    EXPECT_TRUE(finding.effects.empty()) << finding.effects.front().kind;
    ASSERT_FALSE(finding.unexplained.remainders.empty());
    EXPECT_EQ(finding.unexplained.remainders.front().proposal.className, "Analogon.Effects.Proposals.HeatPulse")
        << finding.unexplained.remainders.front().proposal.equation;
}

TEST_F(DiscoveryInAHeater, ProposesALimitOfThePower) {
    const Finding finding = searchHeater({.power = 30});
    EXPECT_TRUE(finding.effects.empty()) << finding.effects.front().kind;
    ASSERT_FALSE(finding.unexplained.remainders.empty());
    EXPECT_NE(finding.unexplained.remainders.front().proposal.equation.find("R_T*i^2 <= limit with limit = 30"),
              std::string::npos)
        << finding.unexplained.remainders.front().proposal.equation;
}

TEST_F(DiscoveryInAHeater, ProposesAResistanceThatBends) {
    const Finding finding = searchHeater({.bend = 8e-6});
    EXPECT_TRUE(finding.effects.empty()) << finding.effects.front().kind;
    ASSERT_FALSE(finding.unexplained.remainders.empty());
    EXPECT_NE(finding.unexplained.remainders.front().proposal.equation.find("beta*(T - T_ref)^2) with beta ="),
              std::string::npos)
        << finding.unexplained.remainders.front().proposal.equation;
}

TEST_F(DiscoveryInAHeater, ProposesAFilmInThePlug) {
    const Finding finding = searchHeater({.film = 2});
    EXPECT_TRUE(finding.effects.empty()) << finding.effects.front().kind;
    ASSERT_FALSE(finding.unexplained.remainders.empty());
    EXPECT_NE(
        finding.unexplained.remainders.front().proposal.equation.find("v_c = R_c*i/(1 + (abs(i)/i_c)^m) with R_c ="),
        std::string::npos)
        << finding.unexplained.remainders.front().proposal.equation;
}

// A pump that runs already when the logger starts: its speed has a start value, its current has none.
TEST_F(Discovery, TakesTheFirstSamplesOfARecordingInMotionForNoStructure) {
    put("model.mo", machineModel("u", "R=0.18, L=4e-4, k=0.016", "J=3e-4, w(start=w0, fixed=true)",
                                 "ViscousLoad load(b=1e-4)", "  parameter Real w0(unit=\"rad/s\") = 0;\n"));
    put("study.json", R"({"format": "analogon-study-1", "class": "Drive",
  "experiments": [{"name": "run", "role": "fit", "file": "run.csv", "time": "t", "inputs": {"u": "u"},
                   "outputs": {"i": "i", "w": "w"}, "initial": {"w0": "fit"}}],
  "parameters": {"motor.R": {"fit": true, "min": 0.02, "max": 2}, "motor.k": {"fit": true, "min": 0.001, "max": 0.1},
                 "rotor.J": {"fit": true, "min": 1e-5, "max": 1e-2}, "load.b": {"fit": true, "min": 1e-6, "max": 0.01}}})");
    std::mt19937 random(4);
    std::normal_distribution<double> scatter;
    std::ofstream csv = recording("t [s],u [V],i [A],w [rad/s]");
    constexpr double R = 0.15, L = 4e-4, k = 0.015, J = 2.5e-4, b = 2e-4, interval = 0.005;
    const auto voltage = [](double t) { return 8 + 3 * std::sin(2.1 * t) + 2 * std::sin(0.7 * t + 1); };
    double w = 400, i = (voltage(0) - k * w) / R;
    for (int n = 0; n < 2000; ++n) {
        const double t = n * interval, from = voltage(t), to = voltage(t + interval);
        csv << t << ',' << from << ',' << i + 0.15 * scatter(random) << ',' << w + 0.3 * scatter(random) << '\n';
        constexpr int steps = 200;
        for (int s = 0; s < steps; ++s) {
            const double u = from + (to - from) * (s + 0.5) / steps, di = (u - R * i - k * w) / L;
            w += interval / steps * (k * i - b * w) / J;
            i += interval / steps * di;
        }
    }
    csv.close();
    const Finding finding = discovered();
    EXPECT_EQ(finding.kind, FindingKind::Adequate);
    EXPECT_TRUE(std::any_of(finding.warnings.begin(), finding.warnings.end(), [](const std::string& warning) {
        return warning.find("'run' begins in motion: the model of output 'i' begins at rest") != std::string::npos;
    }));
}

/// A pump whose voltage or whose tacho ends, or whose bearings rub.
class DiscoveryInAPump : public Discovery {
protected:
    struct Pump {
        double voltage{1e9}, shown{1e9};                                       // [V], [rad/s] at most
        std::function<double(double w)> friction{[](double) { return 0.0; }};  // [N.m]
    };

    Finding searchPump(const Pump& pump, const std::vector<std::string>& kinds = {}) {
        put("model.mo", machineModel("u", "R=0.34, L=0, k=0.035", "J=4e-5", "QuadraticLoad load(k_q=7e-7)"));
        put("study.json", R"({"format": "analogon-study-1", "class": "Drive",
  "experiments": [{"name": "run", "role": "fit", "file": "run.csv", "time": "t", "inputs": {"u": "u"},
                   "outputs": {"i": "i", "w": "w"}}],
  "parameters": {"motor.R": {"fit": true, "min": 0.01, "max": 10}, "motor.k": {"fit": true, "min": 0.001, "max": 0.5},
                 "rotor.J": {"fit": true, "min": 1e-6, "max": 1e-3},
                 "load.k_q": {"fit": true, "min": 1e-8, "max": 1e-4}}})");
        std::mt19937 random(4);
        std::normal_distribution<double> scatter;
        std::ofstream csv = recording("t [s],u [V],i [A],w [rad/s]");
        constexpr double R = 0.26, k = 0.0274, J = 4.5e-5, drag = 7.85e-7, interval = 0.005;
        const auto voltage = [&](int n) {
            const double t = interval * n;
            return 6.5 + 3 * std::sin(1.3 * t) + 1.5 * std::sin(3.7 * t + 1);
        };
        double w = 0;
        for (int n = 0; n < 3000; ++n) {
            const auto given = [&](double part) {
                return std::min(pump.voltage, (1 - part) * voltage(n) + part * voltage(n + 1));
            };
            csv << interval * n << ',' << voltage(n) << ',' << (given(0) - k * w) / R + 0.24 * scatter(random) << ','
                << std::min(w, pump.shown) + 2 * scatter(random) << '\n';
            constexpr int steps = 50;
            for (int s = 0; s < steps; ++s) {
                const double h = interval / steps;
                w += h * (k * (given((s + 0.5) / steps) - k * w) / R - drag * w * w - pump.friction(w)) / J;
            }
        }
        csv.close();
        return discovered(kinds);
    }
};

// A name rounds its limit off, the equation for a tacho that ends there does not: that is all by which it explains
// more.
TEST_F(DiscoveryInAPump, TakesALimitOfTheVoltageForNoLimitOfTheTacho) {
    const Finding finding = searchPump({.voltage = 9.9});
    EXPECT_EQ(finding.kind, FindingKind::Effect);
    ASSERT_EQ(finding.effects.size(), 1u);
    EXPECT_EQ(finding.effects.front().kind, "actuator.saturation");
}

// Without it hardly more is left than noise.
TEST_F(DiscoveryInAPump, SaysAtWhichTachoALimitOfItShows) {
    const Finding finding = searchPump({.shown = 341.5});
    EXPECT_TRUE(finding.effects.empty()) << finding.effects.front().kind;
    ASSERT_FALSE(finding.unexplained.remainders.empty());
    EXPECT_EQ(finding.unexplained.remainders.front().proposal.className, "Analogon.Effects.Proposals.SensorLimit");
    EXPECT_EQ(finding.unexplained.remainders.front().output, "w");
}

// Of a shaft that turns one way, a drag that differs with the direction is a viscous friction, as far as the data tell:
// one that drives, where a friction falls off with speed.
TEST_F(DiscoveryInAPump, TakesNoFrictionThatDrivesForADragThatDiffersWithTheDirection) {
    const auto friction = [](double w) { return w > 0 ? 0.019 + 0.0136 * std::exp(-w * w / (140 * 140)) : 0; };
    const Finding finding =
        searchPump({.friction = friction}, {"friction.coulomb", "friction.viscous", "proposal.drag.direction"});
    ASSERT_EQ(finding.effects.size(), 1u);
    EXPECT_EQ(finding.effects.front().kind, "friction.coulomb");
    for (const Remainder& r : finding.unexplained.remainders)
        EXPECT_NE(r.proposal.className, "Analogon.Effects.Proposals.UnequalDrag") << r.proposal.equation;
}

/// A motor at a supply: a winding that warms and brushes.
class DiscoveryInAMotor : public Discovery {
protected:
    struct Motor {
        double brushes{};     // [V]
        double warming{};     // [K/J]
        double saturation{};  // [1/A2]
        double friction{};    // [N.m]
        double limit{1e9};    // [A] of its driver
        double cogging{};     // [N.m], eight times a turn
        double supply{14};    // [V], largest
        double late{};        // [s] by which the driver follows its command
        double film{};        // [Ohm] under its brushes, half of it left at 1 A
        double lag{};         // [s] of its driver
        int shown{};          // samples after which its current is shown
        double loose{1};      // times its resistance, in the second half
        double slow{};        // [s], lag of what shows its current
    };

    /// What is measured besides the current.
    enum class Beside { Nothing, Speed, Angle };

    Finding searchMotor(const Motor& motor, Beside beside = Beside::Speed, const Progress& progress = {}) {
        std::string model = machineModel("v", "R=0.5, L=0, k=0.04", "J=2e-4", "ViscousLoad load(b=1e-4)");
        if (beside == Beside::Angle)
            for (const auto& [from, to] : {std::pair{"w(unit=\"rad/s\")", "w(unit=\"rad\")"},
                                           std::pair{"SpeedSensor tacho", "AngleSensor tacho"},
                                           std::pair{"connect(tacho.w, w)", "connect(tacho.phi, w)"}})
                model.replace(model.find(from), std::string(from).size(), to);
        put("model.mo", model);
        const std::string second = beside == Beside::Nothing ? "" : R"(, "w": "w")";
        put("study.json", R"({"format": "analogon-study-1", "class": "Drive",
  "experiments": [{"name": "run", "role": "fit", "file": "run.csv", "time": "t",
                   "inputs": {"v": "v"}, "outputs": {"i": "i")" +
                              second + R"(}}],
  "parameters": {"motor.R": {"fit": true, "min": 0.05, "max": 5}, "motor.k": {"fit": true, "min": 0.001, "max": 1},
                 "rotor.J": {"fit": true, "min": 1e-5, "max": 1e-2}, "load.b": {"fit": true, "min": 1e-6, "max": 0.1}}})");
        std::mt19937 random(11);
        std::normal_distribution<double> scatter;
        std::ofstream csv =
            recording(beside == Beside::Angle ? "t [s],v [V],i [A],w [rad]" : "t [s],v [V],i [A],w [rad/s]");
        double w = 0, phi = 0, warm = 0, R = 0.45;
        constexpr double k = 0.045, J = 2.5e-4, b = 2e-4;
        // a slow one is sampled more often than it passes a notch
        const double interval = motor.supply < 5 ? 0.005 : 0.02;
        const auto constant = [&](double i) { return k / std::sqrt(1 + motor.saturation * i * i); };
        const auto current = [&](double v) {
            double i = 0;
            // the torque constant and the film are those of the current it takes
            for (int pass = 0; pass < 30; ++pass) {
                const double pull = v - constant(i) * w;
                const double next =
                    std::abs(pull) < motor.brushes
                        ? 0
                        : (pull - motor.brushes * signOf(pull)) / (R * (1 + 0.00393 * warm) + motor.film / (1 + i * i));
                if (motor.saturation == 0 && motor.film == 0) return std::clamp(next, -motor.limit, motor.limit);
                i += 0.7 * (next - i);
            }
            return i;
        };
        // a late one has a command that bends between its samples, but does not jump there
        const auto command = [&](double t) {
            return motor.late > 0 ? 0.6 * std::sin(2.3 * t) + 0.3 * std::sin(11 * t + 1) : excitation(t);
        };
        const auto supply = [&](int sample) { return motor.supply * command(sample * interval); };
        // the driver knows its command between the samples, too
        const auto driven = [&](double time) {
            return motor.supply * command(std::max(0.0, time * interval - motor.late));
        };
        double lagged = supply(0), seen = current(driven(0));
        std::vector<double> currents;
        for (int n = 0; n < samples; ++n) {
            if (n == samples / 2) R *= motor.loose;
            const double v = motor.late > 0 ? driven(n) : motor.lag > 0 ? lagged : supply(n);
            currents.push_back(motor.slow > 0 ? seen : current(v));
            csv << n * interval << ',' << supply(n) << ','
                << currents[static_cast<std::size_t>(std::max(0, n - motor.shown))] + 0.05 * scatter(random) << ','
                << (beside == Beside::Angle ? phi + 0.02 * scatter(random) : w + 0.3 * scatter(random)) << '\n';
            constexpr int inner = 100;
            for (int m = 0; m < inner; ++m) {
                const double a = (m + 0.5) / inner, h = interval / inner;
                const double given = (1 - a) * supply(n) + a * supply(n + 1);
                if (motor.lag > 0) lagged += h * (given - lagged) / motor.lag;
                const double i = current(motor.late > 0 ? driven(n + a) : motor.lag > 0 ? lagged : given);
                if (motor.slow > 0) seen += h * (i - seen) / motor.slow;
                const double pull = motor.friction * signOf(w) + motor.cogging * std::sin(8 * phi - 0.4);
                w += h * (constant(i) * i - b * w - pull) / J;
                phi += h * w;
                warm += h * (motor.warming * R * (1 + 0.00393 * warm) * i * i - warm / 25);
            }
        }
        csv.close();
        return discovered({}, progress);
    }
};

TEST_F(DiscoveryInAMotor, FindsTwoEffectsInOneComponent) {
    const Finding finding = searchMotor({.brushes = 0.8, .warming = 1.5});
    EXPECT_EQ(finding.kind, FindingKind::Effect);
    ASSERT_EQ(finding.effects.size(), 2u);
    std::map<std::string, double> found;
    for (const AddedEffect& e : finding.effects) {
        EXPECT_EQ(e.at, "motor");
        found[e.kind] = e.parameters.front().value;
        for (const EffectValue& p : e.parameters) {
            EXPECT_NE(p.name, "R") << "is the component's own";
            EXPECT_NE(p.name, e.kind == "voltage.drop" ? "e_w" : "V_b") << "is the other effect's";
        }
    }
    EXPECT_NEAR(found["voltage.drop"], 0.8, 0.05);
    EXPECT_NEAR(found["resistance.temperature"], 1.5, 0.15);
    EXPECT_NE(finding.final.modelText.find("CombinedWithWinding motor("), std::string::npos);
}

TEST_F(DiscoveryInAMotor, LooksForNothingBesideAChangeThatIsAll) {
    const Finding finding = searchMotor({.loose = 1.08});
    EXPECT_TRUE(finding.effects.empty());
    EXPECT_EQ(finding.kind, FindingKind::Unexplained);
    ASSERT_FALSE(finding.unexplained.remainders.empty());
    EXPECT_NE(finding.unexplained.remainders.front().proposal.equation.find("motor.R = if time < 1"), std::string::npos)
        << finding.unexplained.remainders.front().proposal.equation;
    for (const CandidateResult& c : finding.candidates) EXPECT_EQ(c.round, 1) << c.kind;
    EXPECT_TRUE(std::any_of(finding.candidates.begin(), finding.candidates.end(), [](const CandidateResult& c) {
        return c.reason == "a parameter that changes is the better account";
    }));
}

TEST_F(DiscoveryInAMotor, TellsALagBeforeAMotorFromADeadTimeBehindIt) {
    // the other way round, a dead time before it and a lag behind it, explains nearly as much
    const Finding finding = searchMotor({.supply = 2, .lag = 0.05, .shown = 2});
    expectBoth(finding, "input v", {"actuator.lag", 0.05}, {"sensor.delay", 0.01}, 0.002);
}

// Its lag begins where its current does, and the shaft at rest.
TEST_F(DiscoveryInAMotor, TellsADeadTimeBeforeAMotorFromALagBehindIt) {
    const Finding finding = searchMotor({.supply = 4.9, .late = 0.03, .slow = 0.06});
    expectBoth(finding, "input v", {"actuator.delay", 0.03}, {"sensor.lag", 0.06}, 0.001);
}

TEST_F(DiscoveryInAMotor, ReportsAWholeModelWhereverItIsInterrupted) {
    std::atomic<int> reports{};
    searchMotor({.brushes = 0.8, .warming = 1.5}, Beside::Speed,
                Progress({}, [&](const Progress::Report&) { ++reports; }));
    const int all = reports;
    bool hasFoundSome = false;
    for (const double share : {0.1, 0.5, 0.9}) {
        std::stop_source source;
        std::atomic<int> seen{};
        const Finding finding = discovered({}, Progress(source.get_token(), [&](const Progress::Report&) {
                                               if (++seen > share * all) source.request_stop();
                                           }));
        EXPECT_TRUE(finding.end.interrupted);
        hasFoundSome = hasFoundSome || !finding.effects.empty();
        std::size_t ofEffects = 0;
        for (const AddedEffect& e : finding.effects) {
            EXPECT_EQ(e.kind.find("proposal"), std::string::npos) << e.kind;
            EXPECT_NE(finding.final.modelText.find(e.wired.instance), std::string::npos) << "stands in the model";
            for (const FitEstimate& p : finding.final.parameters)
                ofEffects += p.name == e.wired.instance + "." + e.parameters.front().name;
        }
        EXPECT_EQ(ofEffects, finding.effects.size()) << share;
        // R, k, J, b and what the effects brought: nothing of a trial that was not over
        std::size_t freed = 4;
        for (const AddedEffect& e : finding.effects)
            freed += static_cast<std::size_t>(std::count_if(e.parameters.begin(), e.parameters.end(),
                                                            [](const EffectValue& p) { return p.standardError > 0; }));
        EXPECT_LE(finding.final.parameters.size(), freed) << share;
    }
    EXPECT_TRUE(hasFoundSome);
}

TEST_F(DiscoveryInAMotor, CountsTheWavesOfACoggingOverManyTurns) {
    const Finding finding = searchMotor({.cogging = 0.005}, Beside::Angle);
    ASSERT_EQ(finding.effects.size(), 1u);
    const AddedEffect& cogging = finding.effects.front();
    EXPECT_EQ(cogging.kind, "torque.cogging");
    EXPECT_NEAR(valueOf(cogging, "n"), 8, 1e-3);
    EXPECT_NEAR(std::abs(cogging.parameters.front().value), 0.005, 0.0005);
}

TEST_F(DiscoveryInAMotor, FollowsTheRecordedAngleWhereTheNotchesBrakeTheShaft) {
    // the model without notches misses the angle by turns, and with it where the notches are
    for (const Beside beside : {Beside::Angle, Beside::Speed}) {
        const Finding finding = searchMotor({.cogging = 0.03, .supply = 3}, beside);
        EXPECT_EQ(finding.kind, FindingKind::Effect);
        ASSERT_EQ(finding.effects.size(), 1u);
        const AddedEffect& cogging = finding.effects.front();
        EXPECT_EQ(cogging.kind, "torque.cogging");
        EXPECT_NEAR(std::abs(cogging.parameters.front().value), 0.03, 0.001);
        EXPECT_NEAR(valueOf(cogging, "n"), 8, 1e-2);
    }
}

TEST_F(DiscoveryInAMotor, TellsNoDeadTimeFromALagBetweenTwoSamples) {
    const Finding finding = searchMotor({.late = 0.007});
    EXPECT_EQ(finding.effects.size(), 1u);
    ASSERT_FALSE(finding.effects.empty());
    const AddedEffect& shift = finding.effects.front();
    EXPECT_EQ(shift.at, "input v");
    EXPECT_TRUE(shift.kind == "actuator.delay" || shift.kind == "actuator.lag") << shift.kind;
    const std::string other = shift.kind == "actuator.lag" ? "actuator.delay" : "actuator.lag";
    const auto twin = std::find_if(shift.instead.effects.begin(), shift.instead.effects.end(),
                                   [&](const Alternative& a) { return a.kind == other && a.at == shift.at; });
    ASSERT_NE(twin, shift.instead.effects.end());
    EXPECT_TRUE(twin->equivalent);
}

TEST_F(DiscoveryInAMotor, TakesASaturatingFieldForNoWarming) {
    const Finding finding = searchMotor({.saturation = 4e-3});
    // magnets that warm within a sample would explain most of it
    EXPECT_TRUE(finding.effects.empty()) << finding.effects.front().kind;
    EXPECT_EQ(finding.kind, FindingKind::Unexplained);
    ASSERT_FALSE(finding.unexplained.remainders.empty());
    const Remainder& law = finding.unexplained.remainders.front();
    EXPECT_NE(law.proposal.equation.find("k_i = k/sqrt(1 + q*i^2) with q = 0.004"), std::string::npos)
        << law.proposal.equation;
}

TEST_F(DiscoveryInAMotor, ProposesAFilmUnderTheBrushes) {
    const Finding finding = searchMotor({.film = 1});
    EXPECT_TRUE(finding.effects.empty()) << finding.effects.front().kind;
    ASSERT_FALSE(finding.unexplained.remainders.empty());
    EXPECT_NE(
        finding.unexplained.remainders.front().proposal.equation.find("v_c = R_c*i/(1 + (abs(i)/i_c)^m) with R_c ="),
        std::string::npos)
        << finding.unexplained.remainders.front().proposal.equation;
}

TEST_F(DiscoveryInAMotor, TakesALimitOfTheCurrentForNoLimitOfTheVoltage) {
    const Finding finding = searchMotor({.limit = 8});
    EXPECT_TRUE(finding.effects.empty()) << finding.effects.front().kind;
    EXPECT_EQ(finding.kind, FindingKind::Unexplained);
    ASSERT_FALSE(finding.unexplained.remainders.empty());
    EXPECT_NE(finding.unexplained.remainders.front().proposal.equation.find("abs(i) <= limit with limit = 7.99"),
              std::string::npos)
        << finding.unexplained.remainders.front().proposal.equation;
}

TEST_F(DiscoveryInAMotor, FindsFrictionThoughTheScaleOfAllTorquesIsFree) {
    // of the current alone nobody can tell k, J, b and the friction but for a common factor
    const Finding finding = searchMotor({.friction = 0.02}, Beside::Nothing);
    EXPECT_EQ(finding.kind, FindingKind::Effect);
    ASSERT_EQ(finding.effects.size(), 1u);
    EXPECT_EQ(finding.effects.front().kind, "friction.coulomb");
}

TEST_F(Discovery, BeginsAtABetterOptimumThanTheStudysOwn) {
    // from a pitch that is told wrongly the fit takes one wave for the next
    put("model.mo", R"(model Resolver
  Analogon.Interfaces.RealInput phi(unit="rad");
  Analogon.Interfaces.RealOutput y(unit="V");
  parameter Real n = 3.1;
  parameter Real A(unit="V") = 1;
equation
  y = A*sin(n*phi);
end Resolver;
)");
    put("study.json", R"({"format": "analogon-study-1", "class": "Resolver",
  "experiments": [{"name": "turn", "role": "fit", "file": "turn.csv", "time": "t",
                   "inputs": {"phi": "phi"}, "outputs": {"y": "y"}}],
  "parameters": {"n": {"fit": true, "min": 0.01, "max": 100}, "A": {"fit": true, "min": 0.1, "max": 10}}})");
    std::mt19937 random(5);
    std::normal_distribution<double> scatter(0, 0.01);
    std::ofstream csv = recording("t [s],phi [rad],y [V]", "turn.csv");
    for (int k = 0; k < 600; ++k)
        csv << 0.01 * k << ',' << 0.01 * k << ',' << 1.5 * std::sin(2 * 0.01 * k) + scatter(random) << '\n';
    csv.close();
    const Finding finding = discovered();
    EXPECT_EQ(finding.kind, FindingKind::Adequate);
    EXPECT_TRUE(finding.effects.empty());
    const bool isSaid = std::any_of(finding.warnings.begin(), finding.warnings.end(),
                                    [](const std::string& w) { return w.find("poorer optimum") != std::string::npos; });
    EXPECT_TRUE(isSaid);
}

TEST_F(Discovery, SaysWhatToRunWhereTheDataLeaveAChoice) {
    const Finding finding = search({0.02, [](double, double w, double) { return 0.03 * w; }, 1e9, 0.006});
    ASSERT_EQ(finding.effects.size(), 1u);
    EXPECT_TRUE(finding.effects.front().kind == "sensor.lag" || finding.effects.front().kind == "sensor.delay");
    for (const std::string& part :
         {finding.effects.front().kind + " at output w from ", std::string("standard deviations")})
        EXPECT_NE(finding.nextExperiment.find(part), std::string::npos) << finding.nextExperiment;
}

TEST_F(Discovery, ProposesAnEquationWhereNoNameFits) {
    const Finding finding = search({0.02, [](double, double w, double) { return 0.02 * w + 4e-5 * w * w * w; }});
    EXPECT_TRUE(finding.effects.empty());
    EXPECT_EQ(finding.kind, FindingKind::Unexplained);
    ASSERT_FALSE(finding.unexplained.remainders.empty());
    EXPECT_NE(finding.unexplained.remainders.front().proposal.equation.find("a*w^3"), std::string::npos)
        << finding.unexplained.remainders.front().proposal.equation;
    EXPECT_EQ(finding.unexplained.remainders.front().output, "w");
    EXPECT_FALSE(finding.unexplained.remainders.front().node.empty());
    ASSERT_TRUE(finding.unexplained.proposed);
    EXPECT_NEAR(errorPercentOf(finding.unexplained.proposed->state, Role::Fit),
                finding.unexplained.remainders.front().proposal.errors.fit, 1e-9);
    EXPECT_NE(finding.unexplained.proposed->state.modelText, finding.final.modelText);
}

TEST_F(Discovery, WritesALawThatNoBlockHas) {
    const Finding stiffening =
        search({0.02, [](double, double w, double phi) { return 0.03 * w + 0.004 * phi * phi * phi; }});
    EXPECT_TRUE(stiffening.effects.empty()) << stiffening.effects.front().kind;
    EXPECT_EQ(stiffening.kind, FindingKind::Unexplained);
    ASSERT_FALSE(stiffening.unexplained.remainders.empty());
    EXPECT_NE(stiffening.unexplained.remainders.front().proposal.equation.find("tau = a1*phi^3 with a1 = 0.004"),
              std::string::npos)
        << stiffening.unexplained.remainders.front().proposal.equation;
    EXPECT_LT(stiffening.unexplained.remainders.front().proposal.errors.fit,
              0.3 * stiffening.baseline.experiments.front().errorPercent);
}

/// A flap in a spring that grows stiffer with its travel.
class DiscoveryInAThrottle : public Discovery {
protected:
    /// `hidden`: torque at an angle.
    Finding searchThrottle(double noise, const std::function<double(double)>& hidden, double least = 0.4,
                           double most = 2.8) {
        put("model.mo", R"(model Throttle
  Analogon.Interfaces.RealInput tau(unit="N.m");
  Analogon.Interfaces.RealOutput phi(unit="rad");
  Analogon.Sources.PrescribedTorque drive;
  Analogon.Mechanics.Inertia flap(J=3e-3);
  Analogon.Mechanics.ReturnSpring spring(c_r=1, phi_r=-0.6);
  Analogon.Mechanics.ViscousLoad seal(b=0.05);
  Analogon.Sensors.AngleSensor pot;
equation
  connect(tau, drive.tau);
  connect(drive.flange, flap.flange_a);
  connect(flap.flange_b, spring.flange);
  connect(flap.flange_b, seal.flange);
  connect(flap.flange_b, pot.flange);
  connect(pot.phi, phi);
end Throttle;
)");
        put("study.json", R"({"format": "analogon-study-1", "class": "Throttle",
  "experiments": [{"name": "run", "role": "fit", "file": "run.csv", "time": "t",
                   "inputs": {"tau": "tau"}, "outputs": {"phi": "phi"}}],
  "parameters": {"flap.J": {"fit": true, "min": 1e-4, "max": 0.1}, "spring.c_r": {"fit": true, "min": 0.05, "max": 20},
                 "seal.b": {"fit": true, "min": 0.001, "max": 1}}})");
        double phi = 0, w = 0;
        constexpr double J = 3.5e-3, c = 1.2, b = 0.04, rest = -0.6;
        recordDriven(
            "phi [rad]", noise, [&](double t) { return (most + least) / 2 + (most - least) / 2 * excitation(t); }, phi,
            [&](double tau, double h) {
                w += h * (tau - c * (phi - rest) - hidden(phi) - b * w) / J;
                phi += h * w;
            });
        return discovered();
    }

    static double hardening(double phi) { return 0.15 * phi * phi * phi; }

    /// Expects the spring, told from where the recording begins, and no name.
    static void expectSpring(const Finding& finding) {
        EXPECT_TRUE(finding.effects.empty()) << finding.effects.front().kind;
        ASSERT_FALSE(finding.unexplained.remainders.empty());
        const std::string equation = finding.unexplained.remainders.front().proposal.equation;
        EXPECT_EQ(finding.unexplained.remainders.front().proposal.className,
                  "Analogon.Effects.Proposals.HardeningSpring")
            << equation;
        EXPECT_NE(equation.find("a*(phi - phi_0)^3 with a = 0.1"), std::string::npos) << equation;
    }
};

TEST_F(DiscoveryInAThrottle, TakesASpringThatHardensForNoPairOfNames) {
    expectSpring(searchThrottle(0.004, hardening));
}

// In more noise a pendulum that is upright where the spring is at rest explains as much, with one parameter more.
TEST_F(DiscoveryInAThrottle, TakesASpringThatHardensForNoPendulum) {
    const Finding finding = searchThrottle(0.15, hardening);
    expectSpring(finding);
    EXPECT_TRUE(std::any_of(finding.warnings.begin(), finding.warnings.end(), [](const Text& w) {
        return std::string(w).find("torque.gravity at ") == 0 &&
               std::string(w).find("explains as much with more parameters") != std::string::npos;
    }));
}

// A lag of one signal and a dead time of another look much like the dead time of the one and the lag of the other.
TEST_F(Discovery, TellsALagOfTheCurrentAndADeadTimeOfTheBridgeFromTheOtherWayRound) {
    put("model.mo", R"(model Valve
  Analogon.Interfaces.RealInput u(unit="V");
  Analogon.Interfaces.RealOutput i(unit="A");
  Analogon.Interfaces.RealOutput phi(unit="rad");
  Analogon.ElectricMechanical.BasicElectricMechanical motor(R=3, L=0.0018, k=0.03);
  Analogon.Mechanics.BasicMechanics gear(r=18, J1=4e-6, J2=2e-4, c=44, d=0.13);
  Analogon.Mechanics.ReturnSpring spring(c_r=0.5, phi_r=0);
  Analogon.Sensors.AngleSensor pot;
equation
  connect(u, motor.v);
  connect(motor.flange, gear.flange_a);
  connect(gear.flange_b, spring.flange);
  connect(gear.flange_b, pot.flange);
  connect(pot.phi, phi);
  connect(motor.i, i);
end Valve;
)");
    put("study.json", R"({"format": "analogon-study-1", "class": "Valve",
  "experiments": [{"name": "run", "role": "fit", "file": "run.csv", "time": "t",
                   "inputs": {"u": "u"}, "outputs": {"i": "i", "phi": "phi"}}],
  "parameters": {"motor.R": {"fit": true, "min": 0.05, "max": 50}, "motor.k": {"fit": true, "min": 0.002, "max": 0.5},
                 "gear.J1": {"fit": true, "min": 1e-7, "max": 0.001}, "spring.c_r": {"fit": true, "min": 0.01, "max": 20}}})");
    constexpr double R = 2.7, L = 0.0018, k = 0.024, J1 = 3.6e-6, J2 = 2e-4, r = 18, c = 44, d = 0.13, pull = 0.47;
    constexpr double interval = 0.002, lag = 0.003, late = 0.002;
    const auto command = [](double t) {
        const double levels[] = {0, 3, 1, 5, 2, 6, 4, 1};
        const double part = std::max(0.0, t) / 0.5;
        const int n = static_cast<int>(part);
        const double ramp = std::min(1.0, (part - n) / 0.03);
        const double from = n == 0 ? 0 : levels[(n - 1) % 8], to = levels[n % 8];
        return from + (to - from) * ramp + 0.3 * std::sin(60 * std::max(0.0, t));
    };
    std::mt19937 random(6);
    std::normal_distribution<double> scatter;
    std::ofstream csv = recording("t [s],u [V],i [A],phi [rad]");
    double i = 0, seen = 0, w1 = 0, phi1 = 0, w2 = 0, phi2 = 0;
    for (int n = 0; n < 2000; ++n) {
        csv << interval * n << ',' << command(interval * n) << ',' << seen + 0.005 * scatter(random) << ','
            << phi2 + 0.004 * scatter(random) << '\n';
        constexpr int inner = 200;
        for (int m = 0; m < inner; ++m) {
            const double h = interval / inner, t = interval * n + (m + 0.5) * h;
            const double torque = c * (phi1 / r - phi2) + d * (w1 / r - w2);
            i += h * (command(t - late) - R * i - k * w1) / L;
            seen += h * (i - seen) / lag;
            w1 += h * (k * i - torque / r) / J1;
            w2 += h * (torque - pull * phi2) / J2;
            phi1 += h * w1;
            phi2 += h * w2;
        }
    }
    csv.close();
    const Finding finding = discovered();
    expectBoth(finding, "input u", {"actuator.delay", late}, {"sensor.lag", lag}, 2e-4);
}

// A number of periods that is no whole one, and a gain of the sensor, would explain as much.
TEST_F(DiscoveryInAThrottle, TellsATorqueByItsWholeNumberOfPeriods) {
    const auto notches = [](double phi) { return 0.1 * std::sin(3 * phi - 0.57) + 0.2; };
    const Finding finding = searchThrottle(0.004, notches, 0.7, 2.4);
    EXPECT_EQ(finding.kind, FindingKind::Effect);
    std::set<std::string> kinds;
    for (const AddedEffect& e : finding.effects) {
        kinds.insert(e.kind);
        for (const EffectValue& v : e.parameters) EXPECT_TRUE(v.name != "n" || v.value == 3) << v.value;
    }
    // a constant torque, or what its source adds
    EXPECT_THAT(kinds, ::testing::UnorderedElementsAre("torque.cogging",
                                                       ::testing::AnyOf("torque.constant", "actuator.offset")));
}

// The gear of the model is as good as rigid and has no inertia behind its spring; the shaft twists.
TEST_F(Discovery, FindsAShaftThatTwistsBehindASpringWithoutInertia) {
    put("model.mo", R"(model Train
  Analogon.Interfaces.RealInput tau(unit="N.m");
  Analogon.Interfaces.RealOutput w(unit="rad/s");
  Analogon.Sources.PrescribedTorque drive;
  Analogon.Mechanics.BasicMechanics gear(r=1, J1=0.01, J2=0, c=20000, d=5);
  Analogon.Mechanics.Inertia disk(J=0.02);
  Analogon.Mechanics.ViscousLoad load(b=0.05);
  Analogon.Sensors.SpeedSensor tacho;
equation
  connect(tau, drive.tau);
  connect(drive.flange, gear.flange_a);
  connect(gear.flange_b, disk.flange_a);
  connect(disk.flange_b, load.flange);
  connect(disk.flange_b, tacho.flange);
  connect(tacho.w, w);
end Train;
)");
    put("study.json", R"({"format": "analogon-study-1", "class": "Train",
  "experiments": [{"name": "run", "role": "fit", "file": "run.csv", "time": "t",
                   "inputs": {"tau": "tau"}, "outputs": {"w": "w"}}],
  "parameters": {"disk.J": {"fit": true, "min": 0.001, "max": 1}, "load.b": {"fit": true, "min": 0.001, "max": 1}}})");
    constexpr double J1 = 0.01, J2 = 0.02, c = 6, d = 0.02, b = 0.05;
    double twist = 0, w1 = 0, w2 = 0;
    recordDriven("w [rad/s]", 0.1, excitation, w2, [&](double tau, double h) {
        const double shaft = c * twist + d * (w1 - w2);
        w1 += h * (tau - shaft) / J1;
        w2 += h * (shaft - b * w2) / J2;
        twist += h * (w1 - w2);
    });
    const Finding finding = discovered({"compliance.shaft"});
    ASSERT_EQ(finding.effects.size(), 1u);
    EXPECT_EQ(finding.effects[0].at, "gear.flange_b");
    EXPECT_NEAR(valueOf(finding.effects[0], "c"), c, 0.3);
    for (const CandidateResult& other : finding.candidates)
        if (other.at == "disk.flange_b") {
            EXPECT_FALSE(other.failure.empty()) << "a load without inertia has no motion of its own";
        }
}

/// A drive with a gear that has a spring in it, at a supply.
class DiscoveryInAWindowDrive : public Discovery {
protected:
    struct Hidden {
        double lag{};     // [s] of its driver
        double offset{};  // [V] that it adds
        double spring{};  // [N.m/rad] that turns the window back
        double cube{};    // [N.m.s3/rad3] of a drag at the window
        double rub{};     // [N.m.s/rad2] of a drag there that grows with the travel
        double c{170};    // [N.m/rad] of the gear
        double noise{1};  // of the sensors
    };

    Finding searchDrive(const Hidden& hidden) {
        std::string model = R"(model WindowDrive
  Analogon.Interfaces.RealInput v(unit="V");
  Analogon.Interfaces.RealOutput i(unit="A");
  Analogon.Interfaces.RealOutput w(unit="rad/s");
  Analogon.ElectricMechanical.BasicElectricMechanical motor(R=0.4, L=0.0008, k=0.022);
  Analogon.Mechanics.BasicMechanics gear(r=46, J1=1.6e-5, J2=0.0035, STIFFNESS);
  Analogon.Mechanics.Inertia drum(J=0.028);
  Analogon.Mechanics.ViscousLoad window(b=0.6);
  Analogon.Sensors.SpeedSensor tacho;
equation
  connect(v, motor.v);
  connect(motor.i, i);
  connect(motor.flange, gear.flange_a);
  connect(gear.flange_b, drum.flange_a);
  connect(drum.flange_b, window.flange);
  connect(drum.flange_b, tacho.flange);
  connect(tacho.w, w);
end WindowDrive;
)";
        const std::string stiffness = "STIFFNESS";
        const double c = hidden.c, d = c / 100;
        put("model.mo", model.replace(model.find(stiffness), stiffness.size(), fmt::format("c={}, d={}", c, d)));
        put("study.json", R"({"format": "analogon-study-1", "class": "WindowDrive",
  "experiments": [{"name": "run", "role": "fit", "file": "run.csv", "time": "t",
                   "inputs": {"v": "v"}, "outputs": {"i": "i", "w": "w"}}],
  "parameters": {"motor.R": {"fit": true, "min": 0.05, "max": 50, "scale": "log"},
                 "motor.k": {"fit": true, "min": 0.002, "max": 0.5, "scale": "log"},
                 "gear.J1": {"fit": true, "min": 1e-7, "max": 1e-3, "scale": "log"},
                 "window.b": {"fit": true, "min": 0.001, "max": 50, "scale": "log"}}})");
        std::mt19937 random(21);
        std::normal_distribution<double> scatter;
        std::ofstream csv = recording("t [s],v [V],i [A],w [rad/s]");
        constexpr double interval = 0.02, R = 0.5, L = 0.0008, k = 0.027, r = 46, J1 = 2.1e-5, J2 = 0.0315, b = 0.49;
        const auto supply = [](int sample) { return 13 * levelAt(3.3 * interval * sample); };
        double driven = 0, i = 0, w1 = 0, w2 = 0, twist = 0, phi = 0;
        for (int n = 0; n < samples; ++n) {
            csv << n * interval << ',' << supply(n) << ',' << i + 0.054 * hidden.noise * scatter(random) << ','
                << w2 + 0.064 * hidden.noise * scatter(random) << '\n';
            constexpr int inner = 400;
            for (int m = 0; m < inner; ++m) {
                const double a = (m + 0.5) / inner, h = interval / inner;
                const double given = (1 - a) * supply(n) + a * supply(n + 1);
                driven = hidden.lag > 0 ? driven + h * (given - driven) / hidden.lag : given;
                i += h * (driven + hidden.offset - R * i - k * w1) / L;
                const double shaft = c * twist + d * (w1 / r - w2);
                w1 += h * (k * i - shaft / r) / J1;
                w2 += h * (shaft - b * w2 - hidden.cube * w2 * w2 * w2 - hidden.rub * w2 * phi - hidden.spring * phi) /
                      J2;
                twist += h * (w1 / r - w2);
                phi += h * w2;
            }
        }
        csv.close();
        return discovered();
    }
};

TEST_F(DiscoveryInAWindowDrive, FindsALagFarBelowTheSampleIntervalThatParametersHide) {
    const Finding finding = searchDrive({.lag = 0.003});
    ASSERT_EQ(finding.effects.size(), 1u);
    EXPECT_EQ(finding.effects.front().at, "input v") << finding.effects.front().kind;
    EXPECT_NEAR(finding.effects.front().parameters.front().value, 0.003, 0.0003);
    EXPECT_EQ(finding.kind, FindingKind::Effect);
}

TEST_F(DiscoveryInAWindowDrive, TellsBothSidesOfAGearWhereAnEquationMayStand) {
    const Finding finding = searchDrive({.cube = 1e-3, .c = 3'000});
    EXPECT_EQ(finding.kind, FindingKind::Unexplained);
    ASSERT_FALSE(finding.unexplained.remainders.empty());
    const Remainder& first = finding.unexplained.remainders.front();
    EXPECT_NE(first.proposal.equation.find("a*w^3"), std::string::npos) << first.proposal.equation;
    // more parts may be the cause on that side
    EXPECT_EQ(first.node, "gear.flange_b");
    EXPECT_EQ(first.proposal.equalNodes, std::vector<std::string>{"motor.flange"});
}

TEST_F(DiscoveryInAWindowDrive, TellsBothSidesOfAGearWhereALawMayStand) {
    const Finding finding = searchDrive({.rub = 0.02, .c = 1000});
    EXPECT_TRUE(finding.effects.empty());
    ASSERT_FALSE(finding.unexplained.remainders.empty());
    const Remainder& first = finding.unexplained.remainders.front();
    EXPECT_NE(first.proposal.equation.find("gear.flange_b.tau = a1*w*phi with a1 = 0.020"), std::string::npos)
        << first.proposal.equation;
    EXPECT_EQ(first.node, "gear.flange_b");
    EXPECT_EQ(first.proposal.equalNodes, std::vector<std::string>{"motor.flange"});
}

TEST_F(DiscoveryInAWindowDrive, TellsBothSidesOfAGearThatGivesALittle) {
    // by less than the form of an equation without a name is known
    const Finding finding = searchDrive({.cube = 1e-3, .c = 300});
    ASSERT_FALSE(finding.unexplained.remainders.empty());
    EXPECT_EQ(finding.unexplained.remainders.front().node, "gear.flange_b");
    EXPECT_EQ(finding.unexplained.remainders.front().proposal.equalNodes, std::vector<std::string>{"motor.flange"});
}

TEST_F(DiscoveryInAWindowDrive, TellsAnOffsetOfTheCommandFromThatOfASensorOnceASpringIsThere) {
    // as long as the spring is missing, the offset of the sensor explains far more
    const Finding finding = searchDrive({.offset = -0.37, .spring = 0.03, .noise = 3});
    EXPECT_EQ(finding.kind, FindingKind::Effect);
    ASSERT_EQ(finding.effects.size(), 2u);
    for (const AddedEffect& e : finding.effects) {
        const bool isAtInput = e.at == "input v";
        EXPECT_EQ(e.kind, isAtInput ? "actuator.offset" : "spring.return") << e.at;
        if (!isAtInput) continue;
        EXPECT_NEAR(e.parameters.front().value, -0.37, 0.02);
    }
}

TEST_F(Discovery, GivesNoNameToAPartOfWhatHasNone) {
    put("model.mo", R"(model Pump
  Analogon.Interfaces.RealInput v(unit="V");
  Analogon.Interfaces.RealOutput i(unit="A");
  Analogon.Interfaces.RealOutput w(unit="rad/s");
  Analogon.ElectricMechanical.BasicElectricMechanical motor(R=0.6, L=0, k=0.03);
  Analogon.Mechanics.Inertia rotor(J=3e-5);
  Analogon.Mechanics.QuadraticLoad wheel(k_q=5e-7);
  Analogon.Sensors.SpeedSensor tacho;
equation
  connect(v, motor.v);
  connect(motor.i, i);
  connect(motor.flange, rotor.flange_a);
  connect(rotor.flange_b, wheel.flange);
  connect(rotor.flange_b, tacho.flange);
  connect(tacho.w, w);
end Pump;
)");
    put("study.json", R"({"format": "analogon-study-1", "class": "Pump",
  "experiments": [{"name": "run", "role": "fit", "file": "run.csv", "time": "t",
                   "inputs": {"v": "v"}, "outputs": {"i": "i", "w": "w"}}],
  "parameters": {"motor.R": {"fit": true, "min": 0.02, "max": 8}, "motor.k": {"fit": true, "min": 0.001, "max": 0.5},
                 "rotor.J": {"fit": true, "min": 1e-6, "max": 1e-3},
                 "wheel.k_q": {"fit": true, "min": 1e-8, "max": 1e-4}}})");
    std::mt19937 random(6);
    std::normal_distribution<double> scatter;
    std::ofstream csv = recording("t [s],v [V],i [A],w [rad/s]");
    constexpr double interval = 0.004, R = 0.42, k = 0.0185, J = 2.6e-5, wheel = 6.1e-7, relief = 380;
    const auto supply = [](int sample) { return std::max(0.0, 6.5 + 7 * excitation(5 * interval * sample)); };
    double w = 0;
    for (int n = 0; n < samples; ++n) {
        csv << n * interval << ',' << supply(n) << ',' << (supply(n) - k * w) / R + 0.12 * scatter(random) << ','
            << w + 1.5 * scatter(random) << '\n';
        constexpr int inner = 50;
        for (int m = 0; m < inner; ++m) {
            const double a = (m + 0.5) / inner, h = interval / inner;
            const double i = ((1 - a) * supply(n) + a * supply(n + 1) - k * w) / R;
            // a valve opens: the pressure grows no more
            const double reached = std::min(std::abs(w), relief);
            w += h * (k * i - wheel * signOf(w) * reached * reached) / J;
        }
    }
    csv.close();
    const Finding finding = discovered();
    // friction would explain half of it
    EXPECT_TRUE(finding.effects.empty()) << finding.effects.front().kind;
    EXPECT_EQ(finding.kind, FindingKind::Unexplained);
}

TEST_F(Discovery, SaysWhereAnEquationWithoutANameExplainsAsMuchAsOne) {
    // of so little, nobody can tell a cube from a square
    const Finding finding = search({0.02, [](double, double w, double) { return 0.03 * w + 1e-7 * w * w * w; }});
    ASSERT_EQ(finding.effects.size(), 1u);
    EXPECT_EQ(finding.effects.front().kind, "drag.quadratic");
    EXPECT_TRUE(std::any_of(finding.warnings.begin(), finding.warnings.end(), [](const Text& w) {
        return w.find("explains as much as drag.quadratic") != std::string::npos &&
               w.find("flange.tau = a*w^3") != std::string::npos;
    }));
}

// Also where the equation explains hardly less; none that is the name itself by another formula is told.
TEST_F(Discovery, SaysItWhereTheEquationExplainsHardlyLess) {
    const auto saysSo = [](const Text& w) { return w.find("an equation without a name explains as much") == 0; };
    const Finding square = search({0.02, [](double, double w, double) { return 0.03 * w + 4e-6 * w * std::abs(w); }});
    ASSERT_EQ(square.effects.size(), 1u);
    EXPECT_EQ(square.effects.front().kind, "drag.quadratic");
    EXPECT_TRUE(std::any_of(square.warnings.begin(), square.warnings.end(), saysSo));
    const Finding dry = search({0.02, [](double, double w, double) { return 0.03 * w + 0.1 * signOf(w); }});
    ASSERT_EQ(dry.effects.size(), 1u);
    EXPECT_TRUE(std::none_of(dry.warnings.begin(), dry.warnings.end(), saysSo));
}

TEST_F(Discovery, WritesALawWithWhatItMovesWith) {
    const Finding finding = search(
        {0.02, [](double t, double w, double) { return 0.03 * w + 0.15 * signOf(w) * std::abs(excitation(t)); }});
    EXPECT_TRUE(finding.effects.empty());
    ASSERT_FALSE(finding.unexplained.remainders.empty());
    const Remainder& r = finding.unexplained.remainders.front();
    EXPECT_NE(r.proposal.equation.find("sign(w)*abs(tau)"), std::string::npos) << r.proposal.equation;
    // the block is a model of its own, for the user's library
    EXPECT_NE(r.proposal.block.find("model " + r.proposal.className), std::string::npos) << r.proposal.block;
    EXPECT_NE(r.proposal.block.find("input Real x1"), std::string::npos) << r.proposal.block;
}

TEST_F(Discovery, TellsAPeriodicTorqueFromTheShaftsOwn) {
    const Finding finding = search(
        {0.02, [](double t, double w, double) { return 0.03 * w + 0.02 * std::sin(2 * 3.14159265358979 * t / 2.3); }});
    EXPECT_TRUE(finding.effects.empty());
    ASSERT_FALSE(finding.unexplained.remainders.empty());
    const std::string& equation = finding.unexplained.remainders.front().proposal.equation;
    const std::size_t at = equation.find("P = ");
    ASSERT_NE(at, std::string::npos) << equation;
    EXPECT_NEAR(std::stod(equation.substr(at + 4)), 2.3, 0.02);
}

/// A torque that grows with every turn anew: a wave of many, which several effects share.
const Shaft sawtooth{0.02, [](double, double w, double phi) {
                         const double turns = phi / (2 * std::numbers::pi);
                         return 0.03 * w + 0.04 * (2 * (turns - std::floor(turns)) - 1);
                     }};

TEST_F(Discovery, DoesNotTakeATorqueOfTheAngleForItsFirstWave) {
    const Finding finding = search(sawtooth, 0.1);
    EXPECT_TRUE(finding.effects.empty()) << finding.effects.front().kind;
    ASSERT_FALSE(finding.unexplained.remainders.empty());
    EXPECT_NE(finding.unexplained.remainders.front().proposal.equation.find("sin(2*phi)"), std::string::npos)
        << finding.unexplained.remainders.front().proposal.equation;
}

TEST_F(Discovery, GoesNoWayTwice) {
    search(sawtooth, 0.1);
    std::atomic<int> rounds{};
    discovered({}, Progress({}, [&](const Progress::Report& r) { rounds += r.stage == "screen" && r.fraction == 0; }));
    EXPECT_LE(rounds, 3);
}

TEST_F(Discovery, TellsWhatTurnsWithTheShaftByItsWave) {
    const Finding finding =
        search({0.02, [](double, double w, double phi) { return 0.03 * w + 0.03 * std::sin(phi - 0.5); }}, 0.1);
    ASSERT_EQ(finding.effects.size(), 1u);
    EXPECT_EQ(finding.effects.front().kind, "torque.gravity");
    EXPECT_EQ(finding.kind, FindingKind::Effect);
}

TEST_F(Discovery, ProposesATorqueForAWhileForWhatHappensOnce) {
    const Finding finding =
        search({0.02, [](double t, double w, double) { return 0.03 * w + (t > 11.3 && t < 13.1 ? 0.04 : 0.0); }});
    EXPECT_TRUE(finding.effects.empty());
    ASSERT_FALSE(finding.unexplained.remainders.empty());
    const std::string& equation = finding.unexplained.remainders.front().proposal.equation;
    EXPECT_EQ(finding.unexplained.remainders.front().proposal.className, "Analogon.Effects.Proposals.TorquePulse")
        << equation;
    EXPECT_NE(equation.find("t_s = 11.3"), std::string::npos) << equation;
    EXPECT_NE(equation.find("t_d = 1."), std::string::npos) << equation;
}

// Its speed is measured; the model turns on and on where the shaft stands.
TEST_F(Discovery, ProposesTheEndOfATravelThatTheModelRunsThrough) {
    const auto stopped = [](double, double w, double phi) {
        return 0.03 * w + 60 * std::max(0.0, phi - 120) * std::max(0.0, 1 + 0.3 * w);
    };
    const Finding finding = search({0.02, stopped});
    EXPECT_TRUE(finding.effects.empty());
    ASSERT_FALSE(finding.unexplained.remainders.empty());
    const std::string& equation = finding.unexplained.remainders.front().proposal.equation;
    EXPECT_EQ(finding.unexplained.remainders.front().proposal.className, "Analogon.Effects.Proposals.UpperStop")
        << equation;
    const auto at = equation.find("phi_s = ");
    ASSERT_NE(at, std::string::npos) << equation;
    EXPECT_NEAR(std::stod(equation.substr(at + 8)), 120, 1);
}

TEST_F(Discovery, SaysWithWhichUnusedChannelAParameterMoves) {
    const auto oil = [](double t) { return 40 + 25 * std::sin(0.4 * t) + 0.5 * t; };
    const Finding finding =
        search({0.02, [&](double t, double w, double) { return (0.05 - 4e-4 * (oil(t) - 40)) * w; }}, 0.05, oil);
    EXPECT_TRUE(finding.effects.empty());
    EXPECT_EQ(finding.kind, FindingKind::Unexplained);
    ASSERT_FALSE(finding.unexplained.remainders.empty());
    const std::string& equation = finding.unexplained.remainders.front().proposal.equation;
    EXPECT_NE(equation.find("load.b = "), std::string::npos) << equation;
    EXPECT_NE(equation.find(" - 0.00040"), std::string::npos) << equation;
    EXPECT_EQ(finding.unexplained.remainders.front().node, "load");
    EXPECT_EQ(finding.unexplained.remainders.size(), 1u) << "it accounts for all that is left";
    EXPECT_GT(finding.unexplained.remainders.front().proposal.errors.fit, 0);
    EXPECT_LT(finding.unexplained.remainders.front().proposal.errors.fit,
              0.5 * errorPercentOf(finding.baseline, Role::Fit));
}

TEST_F(Discovery, SaysWhenAParameterChangedInMidRun) {
    const Finding finding = search({0.02, [](double t, double w, double) { return (t < 16.0 ? 0.03 : 0.045) * w; }});
    EXPECT_TRUE(finding.effects.empty());
    EXPECT_EQ(finding.kind, FindingKind::Unexplained);
    ASSERT_FALSE(finding.unexplained.remainders.empty());
    EXPECT_EQ(finding.unexplained.remainders.front().node, "load");
    EXPECT_NEAR(finding.unexplained.remainders.front().from, 16.0, 0.2);
    EXPECT_EQ(finding.unexplained.remainders.size(), 1u) << "the change accounts for all that is left";
    EXPECT_GT(finding.unexplained.remainders.front().proposal.errors.fit, 0);
    EXPECT_LT(finding.unexplained.remainders.front().proposal.errors.fit,
              0.5 * errorPercentOf(finding.baseline, Role::Fit));
    ASSERT_FALSE(finding.warnings.empty());
    EXPECT_NE(finding.warnings.front().find("load.b"), std::string::npos) << finding.warnings.front();
}

TEST_F(Discovery, LooksForNoChangeBehindAnEffectThatLeavesNoise) {
    search({0.02, [](double, double w, double phi) { return 0.03 * w + 0.03 * std::sin(phi); }});
    std::atomic<int> changes{};
    const Finding finding = discovered({}, Progress({}, [&](const Progress::Report& r) {
                                           changes += r.detail.english() == "parameters that change";
                                       }));
    ASSERT_EQ(finding.effects.size(), 1u);
    EXPECT_EQ(finding.effects.front().kind, "torque.gravity");
    EXPECT_EQ(changes, 0);
}

TEST_F(Discovery, DoesNotTakeAChangeInMidRunForNoiseWithAMemory) {
    const Finding finding =
        search({0.02, [](double t, double w, double) { return (t < 16.0 ? 0.03 : 0.0315) * w; }}, 0.8);
    EXPECT_TRUE(finding.effects.empty());
    EXPECT_EQ(finding.kind, FindingKind::Unexplained);
    ASSERT_EQ(finding.unexplained.remainders.size(), 1u);
    EXPECT_EQ(finding.unexplained.remainders.front().output, "w");
    EXPECT_EQ(finding.unexplained.remainders.front().node, "load");
    EXPECT_NEAR(finding.unexplained.remainders.front().from, 16.0, 0.5);
    ASSERT_EQ(finding.warnings.size(), 1u);
    EXPECT_NE(finding.warnings.front().find("load.b"), std::string::npos) << finding.warnings.front();
}

TEST_F(Discovery, DrawsAHardLimitSharpEnoughToLeaveNoise) {
    const Finding finding = search({0.02, [](double, double w, double) { return 0.03 * w; }, 0.6}, 0.02);
    ASSERT_EQ(finding.effects.size(), 1u) << finding.effects.back().kind;
    EXPECT_EQ(finding.effects.front().kind, "actuator.saturation");
    EXPECT_NEAR(1 / finding.effects.front().parameters.front().value, 0.6, 0.001);
    EXPECT_NEAR(valueOf(finding.effects.front(), "limit"), 0.6, 0.001);
    EXPECT_EQ(finding.kind, FindingKind::Effect);
}

// Its two wires were exchanged, or those of the drive: no effect is looked for beside that.
TEST_F(Discovery, SaysThatATachometerIsOfTheWrongSign) {
    Shaft shaft{0.02, [](double, double w, double) { return 0.03 * w; }};
    shaft.isTurned = true;
    const Finding finding = search(shaft);
    EXPECT_EQ(finding.kind, FindingKind::Unexplained);
    EXPECT_TRUE(finding.effects.empty());
    const std::string& said = finding.end.notSearched.english();
    EXPECT_NE(said.find("w ('w') seems to be recorded with the wrong sign"), std::string::npos) << said;
    EXPECT_NE(said.find("tau ('tau') seems to be recorded with the wrong sign"), std::string::npos) << said;
    EXPECT_NE(said.find("(the data do not tell which)"), std::string::npos) << said;
}

/// A heater in a housing, each with a thermocouple.
class DiscoveryInAHousing : public Discovery {
protected:
    struct Thermocouples {
        bool areExchanged{};
        double lag{};  // [s] of that in the heater
    };

    Finding searchHousing(const Thermocouples& thermocouples) {
        put("model.mo", R"(model Housing
  Analogon.Interfaces.RealInput P(unit="W");
  Analogon.Interfaces.RealOutput T_core(unit="K");
  Analogon.Interfaces.RealOutput T_shell(unit="K");
  Analogon.Sources.PrescribedHeatFlow heater;
  Analogon.Thermal.HeatCapacitor core(C=40, T_start=293.15);
  Analogon.Thermal.ThermalConductor wall(G=3);
  Analogon.Thermal.HeatCapacitor shell(C=100, T_start=293.15);
  Analogon.Thermal.ThermalConductor loss(G=1);
  Analogon.Sources.FixedTemperature room(T=293.15);
  Analogon.Sensors.TemperatureSensor inside;
  Analogon.Sensors.TemperatureSensor outside;
equation
  connect(P, heater.Q_flow);
  connect(heater.port, core.port);
  connect(core.port, wall.port_a);
  connect(wall.port_b, shell.port);
  connect(shell.port, loss.port_a);
  connect(loss.port_b, room.port);
  connect(core.port, inside.port);
  connect(shell.port, outside.port);
  connect(inside.T, T_core);
  connect(outside.T, T_shell);
end Housing;
)");
        put("study.json", R"({"format": "analogon-study-1", "class": "Housing",
  "experiments": [{"name": "run", "role": "fit", "file": "run.csv", "time": "t",
                   "inputs": {"P": "P"}, "outputs": {"T_core": "TC1", "T_shell": "TC2"}}],
  "parameters": {"core.C": {"fit": true, "min": 4, "max": 400}, "wall.G": {"fit": true, "min": 0.3, "max": 30},
                 "shell.C": {"fit": true, "min": 10, "max": 1000}, "loss.G": {"fit": true, "min": 0.1, "max": 10}}})");
        constexpr double room = 20;  // [degC]
        std::mt19937 random(6);
        std::normal_distribution<double> scatter(0, 0.1);
        std::ofstream csv = recording("t [s],P [W],TC1 [degC],TC2 [degC]");
        double core = room, shell = room, shown = room;
        const auto power = [](int k) { return 60 + 40 * excitation(0.04 * k); };
        for (int k = 0; k < 1000; ++k) {
            const double first = (thermocouples.lag > 0 ? shown : core) + scatter(random);
            const double second = shell + scatter(random);
            csv << k << ',' << power(k) << ',' << (thermocouples.areExchanged ? second : first) << ','
                << (thermocouples.areExchanged ? first : second) << '\n';
            constexpr int inner = 50;
            for (int m = 0; m < inner; ++m) {
                const double a = (m + 0.5) / inner, through = 2.5 * (core - shell);
                if (thermocouples.lag > 0) shown += (core - shown) / thermocouples.lag / inner;
                core += ((1 - a) * power(k) + a * power(k + 1) - through) / 50 / inner;
                shell += (through - 1.4 * (shell - room)) / 120 / inner;
            }
        }
        csv.close();
        return discovered();
    }
};

TEST_F(DiscoveryInAHousing, SaysThatTwoThermocouplesAreExchanged) {
    const Finding finding = searchHousing({true});
    EXPECT_EQ(finding.kind, FindingKind::Unexplained);
    EXPECT_TRUE(finding.effects.empty());
    const std::string& said = finding.end.notSearched.english();
    EXPECT_EQ(said.find("T_core ('TC1') and T_shell ('TC2') seem to be exchanged: read so"), 0u) << said;
    EXPECT_NE(said.find("give each channel the other's column"), std::string::npos) << said;
}

TEST_F(DiscoveryInAHousing, TakesALagOfOneThermocoupleForNoExchange) {
    const Finding finding = searchHousing({false, 8});
    EXPECT_EQ(finding.kind, FindingKind::Effect);
    EXPECT_TRUE(finding.end.notSearched.empty()) << finding.end.notSearched;
    ASSERT_EQ(finding.effects.size(), 1u);
    EXPECT_EQ(finding.effects[0].kind, "sensor.lag");
    EXPECT_NEAR(finding.effects[0].parameters.front().value, 8, 0.5);
}

}  // namespace
}  // namespace analogon
