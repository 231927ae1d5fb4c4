#pragma once

#include "tests/core/effect/text_task.hpp"

namespace analogon {

/// A body (C [J/K]) that is heated with P and cools over a joint (G [W/K]) to 300 K; its temperature is measured as T.
/// A task with these fitted parameters, and without a recording.
inline EstimationTask warmBody(std::vector<FitParameter> parameters) {
    EstimationTask task = taskOf(R"(model Body
  Analogon.Interfaces.RealInput P(unit="W");
  Analogon.Interfaces.RealOutput T(unit="K");
  Analogon.Sources.PrescribedHeatFlow heater;
  Analogon.Thermal.HeatCapacitor body(C=4, T_start=300);
  Analogon.Thermal.ThermalConductor joint(G=0.2);
  Analogon.Sources.FixedTemperature surroundings(T=300);
  Analogon.Sensors.TemperatureSensor sensor;
equation
  connect(P, heater.Q_flow);
  connect(heater.port, body.port);
  connect(body.port, joint.port_a);
  connect(joint.port_b, surroundings.port);
  connect(body.port, sensor.port);
  connect(sensor.T, T);
end Body;
)",
                                 "Body");
    task.parameters = std::move(parameters);
    return task;
}

inline Recording warmBodyRecording(const std::string& name, int samples) {
    return blankRecording(name, {"P"}, {"T"}, samples);
}

}  // namespace analogon
