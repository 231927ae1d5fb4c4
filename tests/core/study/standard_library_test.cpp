// Studies on models that are drawn with the Modelica Standard Library, each with something in the recording that the
// model lacks. The recordings are made here, by equations of their own; without the library the tests are skipped.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <random>

#include "core/study/run.hpp"
#include "study_fixture.hpp"

namespace analogon {
namespace {

/// A column that is measured, its noise, and its value where a recording stands.
struct Measured {
    const char* header;
    double noise;
    std::vector<double> values{};
};

/// One step of the classical Runge-Kutta method.
template <std::size_t N, class Rate>
void advance(std::array<double, N>& x, double t, double h, const Rate& rate) {
    const auto along = [&](const std::array<double, N>& k, double part) {
        std::array<double, N> y = x;
        for (std::size_t i = 0; i < N; ++i) y[i] += part * h * k[i];
        return y;
    };
    const auto a = rate(t, x), b = rate(t + h / 2, along(a, 0.5)), c = rate(t + h / 2, along(b, 0.5)),
               d = rate(t + h, along(c, 1));
    for (std::size_t i = 0; i < N; ++i) x[i] += h * (a[i] + 2 * b[i] + 2 * c[i] + d[i]) / 6;
}

/// The command of a recording: levels of many sizes from `low` to `high`, joined by straight lines from one sample to
/// the next.
struct Command {
    double step;  // [s] between samples
    int pause;    // samples of a level
    double low, high;
    int first{};  // level with which the recording begins: each has another course

    double atSample(int k) const {
        constexpr std::array<double, 11> levels{0, 0.7, 0.3, 1, 0.5, 0.15, 0.85, 0.4, 0.95, 0.05, 0.6};
        return low + (high - low) * levels[static_cast<std::size_t>(k / pause + first) % levels.size()];
    }
    double operator()(double t) const {
        const int k = static_cast<int>(std::floor(t / step));
        return atSample(k) + (atSample(k + 1) - atSample(k)) * (t / step - k);
    }
};

class DiscoveryInStandardLibrary : public testing::StudyTest {
protected:
    void SetUp() override {
        StudyTest::SetUp();
        const char* const path = std::getenv("MODELICAPATH");
        if (!path || !*path) GTEST_SKIP() << "MODELICAPATH names no directory with the Modelica Standard Library";
    }

    /// Writes a recording of `samples` of the command and of what `measured` says of each state.
    template <std::size_t N, class Rate, class Shown>
    void record(const std::string& file, const std::string& input, const Command& command, int samples, int within,
                std::array<double, N> x, const Rate& rate, const std::vector<Measured>& measured, const Shown& shown) {
        std::mt19937 random(static_cast<unsigned>(command.first) + 3);
        std::normal_distribution<double> normal;
        std::ofstream csv(directory_ / file);
        csv.precision(10);
        csv << "t [s]," << input;
        for (const Measured& m : measured) csv << ',' << m.header;
        csv << '\n';
        for (int k = 0; k < samples; ++k) {
            const double t = k * command.step;
            csv << t << ',' << command(t);
            const std::vector<double> values = shown(t, x);
            for (std::size_t m = 0; m < measured.size(); ++m)
                csv << ',' << values[m] + measured[m].noise * normal(random);
            csv << '\n';
            for (int j = 0; j < within; ++j) advance(x, t + j * command.step / within, command.step / within, rate);
        }
    }

    /// The study of fit.csv and check.csv; `inputs`, `outputs`, `parameters`: as in study.json.
    void putStudy(const std::string& name, const std::string& inputs, const std::string& outputs,
                  const std::string& parameters) {
        const auto experiment = [&](const std::string& file, const std::string& role) {
            return R"({"name": ")" + role + R"(", "role": ")" + role + R"(", "file": ")" + file +
                   R"(", "time": "t", "inputs": {)" + inputs + R"(}, "outputs": {)" + outputs + "}}";
        };
        put("study.json", R"({"format": "analogon-study-1", "class": ")" + name + R"(", "experiments": [)" +
                              experiment("fit.csv", "fit") + ",\n" + experiment("check.csv", "validate") +
                              R"(], "parameters": {)" + parameters + "}}");
    }

    Finding discovered() {
        if (const char* kept = std::getenv("ANALOGON_KEEP_STUDIES")) {
            const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
            std::filesystem::copy(
                directory_, std::filesystem::path(kept) / test->name(),
                std::filesystem::copy_options::overwrite_existing | std::filesystem::copy_options::recursive);
            return {};
        }
        const Outcome<RunResult> result = runDiscover(read(), {});
        EXPECT_TRUE(result) << format(result.diagnostics());
        return result ? result->finding : Finding{};
    }

    /// Expects one effect, of this kind at one of these places (which the data cannot tell apart) and of this strength,
    /// and that what was not fitted is met as well as the noise allows.
    static void expectFound(const Finding& finding, const std::string& kind, const std::string& at, double strength,
                            double tolerance, const std::vector<Measured>& measured) {
        EXPECT_EQ(finding.kind, FindingKind::Effect);
        ASSERT_EQ(finding.effects.size(), 1u);
        const AddedEffect& effect = finding.effects.front();
        EXPECT_EQ(effect.kind, kind);
        EXPECT_EQ(effect.at, at);
        EXPECT_NEAR(effect.parameters.at(0).value, strength, tolerance);
        int checked = 0;
        for (const ExperimentState& experiment : finding.final.experiments)
            for (const OutputState& output : experiment.outputs)
                for (const Measured& m : measured)
                    if (experiment.role == Role::Validate && std::string(m.header).starts_with(output.name)) {
                        EXPECT_LT(output.figures.rmse, 1.1 * m.noise) << output.name;
                        ++checked;
                    }
        EXPECT_EQ(checked, static_cast<int>(measured.size()));
    }
};

// ------------------------------------------------------------------------------------------ a heated body

constexpr const char* heatedText = R"(model Heated "A heater on a plate"
  Modelica.Blocks.Interfaces.RealInput P(unit="W");
  Modelica.Blocks.Interfaces.RealOutput T_heater(unit="K");
  Modelica.Blocks.Interfaces.RealOutput T_plate(unit="K");
  Modelica.Thermal.HeatTransfer.Sources.PrescribedHeatFlow source;
  Modelica.Thermal.HeatTransfer.Components.HeatCapacitor heater(C=30, T(fixed=true, start=293.15));
  Modelica.Thermal.HeatTransfer.Components.ThermalConductor joint(G=0.8);
  Modelica.Thermal.HeatTransfer.Components.HeatCapacitor plate(C=100, T(fixed=true, start=293.15));
  Modelica.Thermal.HeatTransfer.Components.Convection convection;
  Modelica.Thermal.HeatTransfer.Sources.FixedTemperature ambient(T=293.15);
  Modelica.Blocks.Sources.Constant G(k=0.3);
  Modelica.Thermal.HeatTransfer.Sensors.TemperatureSensor sensor1;
  Modelica.Thermal.HeatTransfer.Sensors.TemperatureSensor sensor2;
equation
  connect(P, source.Q_flow);
  connect(source.port, heater.port);
  connect(heater.port, joint.port_a);
  connect(joint.port_b, plate.port);
  connect(plate.port, convection.solid);
  connect(convection.fluid, ambient.port);
  connect(G.y, convection.Gc);
  connect(heater.port, sensor1.port);
  connect(plate.port, sensor2.port);
  connect(sensor1.T, T_heater);
  connect(sensor2.T, T_plate);
end Heated;
)";

TEST_F(DiscoveryInStandardLibrary, FindsASecondHeatLoss) {
    put("model.mo", heatedText);
    putStudy("Heated", R"("P": "P")", R"("T_heater": "T_heater", "T_plate": "T_plate")",
             R"("heater.C": {"fit": true, "min": 1, "max": 1000}, "plate.C": {"fit": true, "min": 1, "max": 1000},
                "joint.G": {"fit": true, "min": 0.01, "max": 10}, "G.k": {"fit": true, "min": 0.01, "max": 10})");
    for (const auto& [file, first] : {std::pair("fit.csv", 0), std::pair("check.csv", 4)}) {
        const Command command{2, 60, 0, 50, first};
        constexpr double ambient = 293.15;
        record<2>(
            file, "P [W]", command, 600, 4, {ambient, ambient},
            [&](double t, const std::array<double, 2>& T) {
                const double joint = 1.1 * (T[0] - T[1]);
                const double radiation = 2e-9 * (std::pow(T[0], 4) - std::pow(ambient, 4));
                return std::array<double, 2>{(command(t) - joint - radiation) / 40,
                                             (joint - 0.4 * (T[1] - ambient)) / 150};
            },
            {{"T_heater [K]", 0.2}, {"T_plate [K]", 0.2}},
            [](double, const std::array<double, 2>& T) {
                return std::vector<double>{T[0], T[1]};
            });
    }
    expectFound(discovered(), "thermal.radiation", "source.port", 2e-9, 6e-11,
                {{"T_heater [K]", 0.2}, {"T_plate [K]", 0.2}});
}

// ------------------------------------------------------------------------------------------ a pump

constexpr const char* pumpText = R"(model Pump "A pump whose load and flow stand in tables"
  Modelica.Blocks.Interfaces.RealInput tau(unit="N.m");
  Modelica.Blocks.Interfaces.RealOutput w(unit="rad/s");
  Modelica.Blocks.Interfaces.RealOutput q;
  Modelica.Mechanics.Rotational.Sources.Torque motor;
  Modelica.Mechanics.Rotational.Components.Inertia wheel(J=1e-3, phi(fixed=true, start=0), w(fixed=true, start=0));
  Modelica.Mechanics.Rotational.Sources.Torque water;
  Modelica.Mechanics.Rotational.Sensors.SpeedSensor speed;
  Modelica.Blocks.Tables.CombiTable1Ds characteristic(table=[0, 0, 0; 50, -0.02, 0.2; 100, -0.09, 0.6; 200, -0.4, 1.3;
    300, -0.9, 1.9], smoothness=Modelica.Blocks.Types.Smoothness.ContinuousDerivative);
  Modelica.Blocks.Math.Gain loss(k=1);
  Modelica.Blocks.Math.Gain delivery(k=1);
equation
  connect(tau, motor.tau);
  connect(motor.flange, wheel.flange_a);
  connect(wheel.flange_b, water.flange);
  connect(wheel.flange_b, speed.flange);
  connect(speed.w, characteristic.u);
  connect(characteristic.y[1], loss.u);
  connect(loss.y, water.tau);
  connect(characteristic.y[2], delivery.u);
  connect(delivery.y, q);
  connect(speed.w, w);
end Pump;
)";

/// The cubic pieces of Akima through what a maker wrote down of the pump.
struct Characteristic {
    std::vector<double> x, y;
    double operator()(double at) const {
        const std::size_t n = x.size();
        std::vector<double> slope(n + 3);  // of the pieces, two more at either end
        for (std::size_t k = 0; k + 1 < n; ++k) slope[k + 2] = (y[k + 1] - y[k]) / (x[k + 1] - x[k]);
        slope[1] = 2 * slope[2] - slope[3];
        slope[0] = 2 * slope[1] - slope[2];
        slope[n + 1] = 2 * slope[n] - slope[n - 1];
        slope[n + 2] = 2 * slope[n + 1] - slope[n];
        const auto tangent = [&](std::size_t k) {
            const double a = std::abs(slope[k + 3] - slope[k + 2]), b = std::abs(slope[k + 1] - slope[k]);
            return a + b > 0 ? (a * slope[k + 1] + b * slope[k + 2]) / (a + b) : (slope[k + 1] + slope[k + 2]) / 2;
        };
        std::size_t k = 0;
        while (k + 2 < n && at > x[k + 1]) ++k;
        const double h = x[k + 1] - x[k], s = (at - x[k]) / h;
        return y[k] * (1 + 2 * s) * (1 - s) * (1 - s) + h * tangent(k) * s * (1 - s) * (1 - s) +
               y[k + 1] * s * s * (3 - 2 * s) + h * tangent(k + 1) * s * s * (s - 1);
    }
};

TEST_F(DiscoveryInStandardLibrary, FindsTheFrictionOfAPump) {
    put("model.mo", pumpText);
    putStudy("Pump", R"("tau": "tau")", R"("w": "w", "q": "q")",
             R"("wheel.J": {"fit": true, "min": 1e-5, "max": 0.1}, "loss.k": {"fit": true, "min": 0.1, "max": 10},
                "delivery.k": {"fit": true, "min": 0.1, "max": 10})");
    const std::vector<double> speeds{0, 50, 100, 200, 300};
    const Characteristic load{speeds, {0, 0.02, 0.09, 0.4, 0.9}}, flow{speeds, {0, 0.2, 0.6, 1.3, 1.9}};
    for (const auto& [file, first] : {std::pair("fit.csv", 0), std::pair("check.csv", 4)}) {
        const Command command{0.02, 60, 0.1, 0.9, first};
        record<1>(
            file, "tau [N.m]", command, 800, 20, {},
            [&](double t, const std::array<double, 1>& x) {
                return std::array<double, 1>{(command(t) - 1.1 * load(x[0]) - 6e-4 * x[0]) / 1.5e-3};
            },
            {{"w [rad/s]", 0.5}, {"q", 0.01}},
            [&](double, const std::array<double, 1>& x) {
                return std::vector<double>{x[0], 0.9 * flow(x[0])};
            });
    }
    expectFound(discovered(), "friction.viscous", "motor.flange", 6e-4, 1e-5, {{"w [rad/s]", 0.5}, {"q", 0.01}});
}

// ------------------------------------------------------------------------------------------ a machine as a whole

constexpr const char* wholeMachineText = R"(model Machine "A machine with a load"
  Modelica.Blocks.Interfaces.RealInput v(unit="V");
  Modelica.Blocks.Interfaces.RealOutput i(unit="A");
  Modelica.Blocks.Interfaces.RealOutput w(unit="rad/s");
  Modelica.Electrical.Machines.BasicMachines.DCMachines.DC_PermanentMagnet machine(VaNominal=100, IaNominal=100,
    wNominal=149.22565104552, TaNominal=293.15, Ra=0.05, TaRef=293.15, alpha20a=0, La=0.0015, Jr=0.15,
    TaOperational=293.15, phiMechanical(fixed=true, start=0), wMechanical(fixed=true, start=0), ia(fixed=true, start=0));
  Modelica.Electrical.Analog.Sources.SignalVoltage supply;
  Modelica.Electrical.Analog.Basic.Ground ground;
  Modelica.Electrical.Analog.Sensors.CurrentSensor ammeter;
  Modelica.Mechanics.Rotational.Components.Inertia load(J=0.15);
  Modelica.Mechanics.Rotational.Sensors.SpeedSensor tacho;
equation
  connect(v, supply.v);
  connect(supply.p, ammeter.p);
  connect(ammeter.n, machine.pin_ap);
  connect(machine.pin_an, supply.n);
  connect(supply.n, ground.p);
  connect(machine.flange, load.flange_a);
  connect(load.flange_b, tacho.flange);
  connect(ammeter.i, i);
  connect(tacho.w, w);
end Machine;
)";

TEST_F(DiscoveryInStandardLibrary, FindsTheFanOfAMachine) {
    put("model.mo", wholeMachineText);
    putStudy(
        "Machine", R"("v": "v")", R"("i": "i", "w": "w")",
        R"("machine.Ra": {"fit": true, "min": 0.005, "max": 1}, "machine.La": {"fit": true, "min": 1e-4, "max": 0.1},
                "load.J": {"fit": true, "min": 0.01, "max": 10})");
    const double k = (100 - 0.06 * 100) / 149.22565104552;  // [V.s]
    for (const auto& [file, first] : {std::pair("fit.csv", 0), std::pair("check.csv", 4)}) {
        const Command command{0.02, 60, -40, 100, first};
        record<2>(
            file, "v [V]", command, 800, 40, {},
            [&](double t, const std::array<double, 2>& x) {
                return std::array<double, 2>{(command(t) - 0.06 * x[0] - k * x[1]) / 2e-3,
                                             (k * x[0] - 1.5e-3 * x[1] * std::abs(x[1])) / (0.15 + 0.2)};
            },
            {{"i [A]", 1.5}, {"w [rad/s]", 0.3}},
            [](double, const std::array<double, 2>& x) {
                return std::vector<double>{x[0], x[1]};
            });
    }
    expectFound(discovered(), "drag.quadratic", "machine.flange", 1.5e-3, 3e-5, {{"i [A]", 1.5}, {"w [rad/s]", 0.3}});
}

}  // namespace
}  // namespace analogon
