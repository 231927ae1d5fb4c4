#pragma once

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

/// Ten studies on which a command is at work for long, each in another place: stiff chains, models of many equations,
/// events, loops that Newton's method solves, recordings with many samples, columns or experiments.
namespace analogon::cli {

struct StudyText {
    std::string name, className, model, inputs, outputs, parameters;
    std::string header;
    std::function<std::string(int)> row;
    int rows{}, experiments{1};
};

inline void writeStudy(const std::filesystem::path& directory, const StudyText& text) {
    std::filesystem::create_directories(directory);
    std::ofstream(directory / "model.mo") << text.model;
    std::string experiments;
    for (int i = 0; i < text.experiments; ++i)
        experiments += fmt::format(
            R"({}{{"name": "run {}", "role": "fit", "file": "run.csv", "time": "t", "inputs": {{{}}}, "outputs": {{{}}}}})",
            i > 0 ? ",\n  " : "", i, text.inputs, text.outputs);
    std::ofstream(directory / "study.json") << fmt::format(
        "{{\"format\": \"analogon-study-1\", \"class\": \"{}\",\n  \"experiments\": [{}],\n  \"parameters\": "
        "{{{}}}}}\n",
        text.className, experiments, text.parameters);
    std::ofstream csv(directory / "run.csv");
    csv << text.header << '\n';
    for (int k = 0; k < text.rows; ++k) csv << text.row(k) << '\n';
}

inline std::string fittedWithin(const std::string& name, double min, double max) {
    return fmt::format(R"("{}": {{"fit": true, "min": {}, "max": {}}})", name, min, max);
}

/// A number that repeats after 13 steps, for noise.
inline double wiggle(int k) { return (k * 7919LL) % 13 - 6.0; }

/// Thermal masses in a row, every other one a thousand times lighter: stiff, and the more of them the slower.
inline StudyText chain(int masses, int samples) {
    StudyText text{fmt::format("chain-{}-{}", masses, samples),
                   "Chain",
                   {},
                   R"("P": "P")",
                   R"("T": "T")",
                   {},
                   "t [s],P [W],T [K]",
                   {},
                   samples};
    std::string& model = text.model;
    model =
        "model Chain\n  Analogon.Interfaces.RealInput P(unit=\"W\");\n"
        "  Analogon.Interfaces.RealOutput T(unit=\"K\");\n"
        "  Analogon.Sources.PrescribedHeatFlow heat;\n  Analogon.Sources.FixedTemperature around(T=293.15);\n"
        "  Analogon.Thermal.ThermalConductor out(G=0.5);\n  Analogon.Sensors.TemperatureSensor sensor;\n";
    for (int i = 0; i < masses; ++i) {
        model += fmt::format("  Analogon.Thermal.HeatCapacitor c{}(C={}, T_start=293.15);\n", i, i % 2 ? 0.005 : 5.0);
        if (i > 0) model += fmt::format("  Analogon.Thermal.ThermalConductor g{}(G=2);\n", i);
    }
    model +=
        "equation\n  connect(P, heat.Q_flow);\n  connect(heat.port, c0.port);\n  connect(c0.port, sensor.port);\n"
        "  connect(sensor.T, T);\n  connect(out.port_b, around.port);\n";
    for (int i = 1; i < masses; ++i)
        model += fmt::format("  connect(c{0}.port, g{1}.port_a);\n  connect(g{1}.port_b, c{1}.port);\n", i - 1, i);
    model += fmt::format("  connect(c{}.port, out.port_a);\nend Chain;\n", masses - 1);
    text.parameters = fittedWithin("c0.C", 0.1, 100) + ", " + fittedWithin("c2.C", 0.1, 100) + ", " +
                      fittedWithin("g1.G", 0.05, 50) + ", " + fittedWithin("out.G", 0.05, 50);
    text.row = [T = 293.15](int k) mutable {
        const double P = 20 + 10 * (k / 100 % 2) + 5 * std::sin(0.01 * k);
        T += 0.5 / 60 * (1.5 * P + 293.15 - T);
        return fmt::format("{},{:.4f},{:.4f}", 0.5 * k, P, T + 0.005 * wiggle(k));
    };
    return text;
}

/// One mass with `columns` columns that nobody uses.
inline StudyText lag(const std::string& name, int samples, int columns) {
    StudyText text{
        name,
        "Lag",
        "model Lag\n  Analogon.Interfaces.RealInput u; Analogon.Interfaces.RealOutput y(start=0, fixed=true);\n"
        "  parameter Real T(unit=\"s\") = 1; parameter Real k = 1;\nequation\n  T*der(y) = k*u - y;\nend Lag;\n",
        R"("u": "u")",
        R"("y": "y")",
        fittedWithin("T", 0.1, 100) + ", " + fittedWithin("k", 0.1, 10),
        "t [s],u,y",
        {},
        samples};
    for (int i = 0; i < columns; ++i) text.header += fmt::format(",spare{}", i);
    text.row = [columns, y = 0.0](int k) mutable {
        const double u = k / 500 % 2;
        std::string row = fmt::format("{:.2f},{},{:.5f}", 0.01 * k, u, y + 0.001 * wiggle(k));
        y += 0.01 / 1.5 * (2 * u - y);
        for (int i = 0; i < columns; ++i) row += fmt::format(",{}", (k * (i + 3)) % 101);
        return row;
    };
    return text;
}

/// Van der Pol's oscillator: rests that are hundreds of times longer than its leaps.
inline StudyText oscillator() {
    StudyText text{"oscillator",
                   "Oscillator",
                   "model Oscillator\n  Analogon.Interfaces.RealInput u; Analogon.Interfaces.RealOutput y;\n"
                   "  parameter Real mu = 300; parameter Real a = 1;\n"
                   "  Real x(start=2, fixed=true); Real v(start=0, fixed=true);\n"
                   "equation\n  der(x) = v; der(v) = mu*(1 - x^2)*v - a*x + u; y = x;\nend Oscillator;\n",
                   R"("u": "u")",
                   R"("y": "y")",
                   fittedWithin("mu", 50, 2000) + ", " + fittedWithin("a", 0.2, 5),
                   "t [s],u,y",
                   {},
                   6000};
    text.row = [](int k) {
        const double phase = std::fmod(0.5 * k / 490, 1);  // a period is about 490 s
        const double y = phase < 0.5 ? 2 - 2 * phase : -3 + 2 * phase;
        return fmt::format("{},{:.4f},{:.5f}", 0.5 * k, 0.01 * std::sin(0.02 * k), y + 0.001 * wiggle(k));
    };
    return text;
}

/// Bodies, each heated by a switch of its own that turns about its set point again and again.
inline StudyText switches(int bodies, int samples) {
    StudyText text{"switches",
                   "Switches",
                   {},
                   R"("P": "P")",
                   R"("T": "T")",
                   fittedWithin("C", 1, 100) + ", " + fittedWithin("G", 0.05, 5),
                   "t [s],P [W],T [K]",
                   {},
                   samples};
    text.model =
        "model Switches\n  Analogon.Interfaces.RealInput P(unit=\"W\");\n"
        "  Analogon.Interfaces.RealOutput T(unit=\"K\");\n  parameter Real C = 8; parameter Real G = 0.6;\n";
    for (int i = 0; i < bodies; ++i) text.model += fmt::format("  Real T{}(start=293.15, fixed=true);\n", i);
    text.model += "equation\n  T = T0;\n";
    for (int i = 0; i < bodies; ++i)
        text.model += fmt::format("  C*der(T{0}) = (if T{0} < {1} then P else 0) - G*(T{0} - 293.15);\n", i, 300 + i);
    text.model += "end Switches;\n";
    text.row = [T = 293.15](int k) mutable {
        const double P = 30 + 10 * (k / 200 % 2);
        const double shown = T + 0.01 * wiggle(k);
        T += 0.1 / 10 * ((T < 300 ? P : 0) - 0.5 * (T - 293.15));
        return fmt::format("{:.1f},{},{:.4f}", 0.1 * k, P, shown);
    };
    return text;
}

/// Diodes in a ladder, a capacitor at its end: a system of nonlinear equations at every look.
inline StudyText diodes(int rungs, int samples) {
    StudyText text{"diodes",
                   "Diodes",
                   {},
                   R"("u": "u")",
                   R"("y": "y")",
                   fittedWithin("R", 1, 1000) + ", " + fittedWithin("C", 1e-6, 1e-2),
                   "t [s],u [V],y [V]",
                   {},
                   samples};
    text.model =
        "model Diodes\n  Analogon.Interfaces.RealInput u(unit=\"V\");\n"
        "  Analogon.Interfaces.RealOutput y(unit=\"V\");\n  parameter Real R = 40; parameter Real C = 1e-4;\n"
        "  Real v(start=0, fixed=true);\n";
    for (int i = 0; i < rungs; ++i) text.model += fmt::format("  Real u{};\n", i);
    text.model += "equation\n  y = v;\n";
    for (int i = 0; i < rungs; ++i)
        text.model += fmt::format("  ({} - u{})/R = 1e-6*(exp(u{}/0.2) - 1) + (u{} - {})/R;\n",
                                  i > 0 ? fmt::format("u{}", i - 1) : "u", i, i, i,
                                  i + 1 < rungs ? fmt::format("u{}", i + 1) : "v");
    text.model += fmt::format("  C*der(v) = (u{} - v)/R;\nend Diodes;\n", rungs - 1);
    text.row = [rungs, v = 0.0](int k) mutable {
        const double u = 1 + std::sin(0.02 * k), shown = v + 0.001 * wiggle(k);
        v += 1e-3 / (40 * rungs * 1.2e-4) * (u - v);
        return fmt::format("{:.3f},{:.4f},{:.5f}", 1e-3 * k, u, shown);
    };
    return text;
}

/// A pump of library components, and many recordings of it.
inline StudyText pump(int experiments, int samples) {
    StudyText text{
        "pump",
        "Pump",
        "model Pump\n  Analogon.Interfaces.RealInput v(unit=\"V\");\n"
        "  Analogon.Interfaces.RealOutput i(unit=\"A\"); Analogon.Interfaces.RealOutput w(unit=\"rad/s\");\n"
        "  Analogon.ElectricMechanical.BasicElectricMechanical motor(R=0.5, L=3.5e-4, k=0.025);\n"
        "  Analogon.Mechanics.Inertia rotor(J=5e-5);\n  Analogon.Mechanics.QuadraticLoad load(k_q=2e-6);\n"
        "  Analogon.Sensors.SpeedSensor speed;\nequation\n  connect(v, motor.v);\n"
        "  connect(motor.flange, rotor.flange_a);\n  connect(rotor.flange_b, load.flange);\n"
        "  connect(rotor.flange_b, speed.flange);\n  connect(motor.i, i);\n  connect(speed.w, w);\nend Pump;\n",
        R"("v": "v")",
        R"("i": "i", "w": "w")",
        fittedWithin("motor.R", 0.05, 5) + ", " + fittedWithin("motor.k", 0.002, 0.2) + ", " +
            fittedWithin("rotor.J", 1e-6, 1e-3) + ", " + fittedWithin("load.k_q", 1e-7, 1e-4),
        "t [s],v [V],i [A],w [rad/s]",
        {},
        samples,
        experiments};
    text.row = [w = 0.0, i = 0.0](int k) mutable {
        const double v = 6 + 5 * (k / 250 % 2);
        const std::string row =
            fmt::format("{:.3f},{},{:.4f},{:.3f}", 2e-3 * k, v, i + 0.01 * wiggle(k), w + 0.05 * wiggle(k));
        for (int part = 0; part < 20; ++part) {
            i += 1e-4 / 3.5e-4 * (v - 0.55 * i - 0.024 * w);
            w += 1e-4 / 6e-5 * (0.024 * i - 2.2e-6 * w * w - 0.01 * std::tanh(w));
        }
        return row;
    };
    return text;
}

/// All ten below a directory.
inline std::vector<std::filesystem::path> writeInterruptStudies(const std::filesystem::path& below) {
    std::vector<std::filesystem::path> all;
    for (const StudyText& text :
         {chain(4, 10000), pump(1, 3000), lag("long", 400'000, 0), oscillator(), chain(60, 660), switches(12, 4000),
          diodes(8, 3000), chain(30, 20000), lag("wide", 4000, 400), pump(12, 1500)}) {
        all.push_back(below / fmt::format("{}-{}", all.size(), text.name));
        writeStudy(all.back(), text);
    }
    return all;
}

}  // namespace analogon::cli
