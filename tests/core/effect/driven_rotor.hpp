#pragma once

#include <utility>

#include "tests/core/effect/text_task.hpp"

namespace analogon {

/// A rotor (J [kg.m2]) that a torque drives against a damper (b [N.m.s/rad]); its speed is measured: tau, w.
inline EstimationTask drivenRotor(Recording recording) {
    EstimationTask task = taskOf(R"(model Rotor
  Analogon.Interfaces.RealInput tau(unit="N.m");
  Analogon.Interfaces.RealOutput w(unit="rad/s");
  Analogon.Sources.PrescribedTorque drive;
  Analogon.Mechanics.Inertia rotor(J=1);
  Analogon.Mechanics.ViscousLoad damper(b=0.05);
  Analogon.Sensors.SpeedSensor sensor;
equation
  connect(tau, drive.tau);
  connect(drive.flange, rotor.flange_a);
  connect(rotor.flange_b, damper.flange);
  connect(rotor.flange_b, sensor.flange);
  connect(sensor.w, w);
end Rotor;
)",
                                 "Rotor");
    task.parameters = {{"rotor.J", "kg.m2", 1, 0.1, 10}, {"damper.b", "N.m.s/rad", 0.05, 0.005, 0.5}};
    task.recordings = {std::move(recording)};
    return task;
}

}  // namespace analogon
