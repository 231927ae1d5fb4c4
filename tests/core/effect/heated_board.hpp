#pragma once

#include <array>
#include <cmath>
#include <random>

#include "tests/core/effect/text_task.hpp"

namespace analogon {

inline constexpr const char* boardText = R"(model Board
  Analogon.Interfaces.RealInput P1(unit="W");
  Analogon.Interfaces.RealInput P2(unit="W");
  Analogon.Interfaces.RealOutput T1(unit="K");
  Analogon.Interfaces.RealOutput T2(unit="K");
  Analogon.Sources.PrescribedHeatFlow heater1;
  Analogon.Sources.PrescribedHeatFlow heater2;
  Analogon.Thermal.HeatCapacitor body1(C=4, T_start=300);
  Analogon.Thermal.HeatCapacitor body2(C=4, T_start=300);
  Analogon.Thermal.ThermalConductor loss1(G=0.1);
  Analogon.Thermal.ThermalConductor loss2(G=0.1);
  Analogon.Sources.FixedTemperature room(T=300);
  Analogon.Sensors.TemperatureSensor sensor1;
  Analogon.Sensors.TemperatureSensor sensor2;
equation
  connect(P1, heater1.Q_flow);
  connect(P2, heater2.Q_flow);
  connect(heater1.port, body1.port);
  connect(heater2.port, body2.port);
  connect(body1.port, loss1.port_a);
  connect(body2.port, loss2.port_a);
  connect(loss1.port_b, room.port);
  connect(loss2.port_b, room.port);
  connect(body1.port, sensor1.port);
  connect(body2.port, sensor2.port);
  connect(sensor1.T, T1);
  connect(sensor2.T, T2);
end Board;
)";

/// A flow of heat that nobody records: root mean square [W] and time constant [s] of a Gaussian process.
struct Draught {
    double size{}, time{1};
};

/// Two heated bodies that exchange heat (conductance `exchange`), the power of each passing an element that follows
/// with a time constant, the first of them in a draught; integrated in small explicit steps. `noise`: standard
/// deviation of each thermometer.
inline EstimationTask heatedBoard(double exchange, double element, std::array<double, 2> noise = {0.05, 0.05},
                                  Draught draught = {}) {
    constexpr double step = 0.5;
    constexpr int samples = 500, within = 100;
    EstimationTask task = taskOf(boardText, "Board");
    for (const char* name : {"body1.C", "body2.C"}) task.parameters.push_back({name, "J/K", 3, 0.1, 100});
    for (const char* name : {"loss1.G", "loss2.G"}) task.parameters.push_back({name, "W/K", 0.2, 0.001, 10});
    Recording r = blankRecording("steps", {"P1", "P2"}, {"T1", "T2"}, samples);
    std::mt19937 random(4);
    std::normal_distribution<double> normal;
    const auto powerAt = [](int body, int k) { return (k / (body == 0 ? 90 : 130)) % 2 == 0 ? 6.0 : 1.0; };
    double T[2] = {300, 300}, Q[2] = {powerAt(0, 0), powerAt(1, 0)}, blown = 0;
    std::mt19937 wind(11);
    for (int k = 0; k < samples; ++k) {
        r.time.push_back(step * k);
        for (const int b : {0, 1}) {
            r.inputs(b, k) = powerAt(b, k);
            r.outputs(b, k) = T[b] + noise[static_cast<std::size_t>(b)] * normal(random);
        }
        for (int i = 0; i < within; ++i) {
            const double part = (i + 0.5) / within, dt = step / within, over = exchange * (T[0] - T[1]);
            for (const int b : {0, 1}) {
                const double power = (1 - part) * powerAt(b, k) + part * powerAt(b, k + 1);
                Q[b] = element > 0 ? Q[b] + dt / element * (power - Q[b]) : power;
            }
            blown += -dt / draught.time * blown + draught.size * std::sqrt(2 * dt / draught.time) * normal(wind);
            T[0] += dt / 4 * (Q[0] - 0.1 * (T[0] - 300) - over + blown);
            T[1] += dt / 4 * (Q[1] - 0.1 * (T[1] - 300) + over);
        }
    }
    task.recordings = {r};
    return task;
}

}  // namespace analogon
