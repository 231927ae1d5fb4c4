model M
  Analogon.Sources.PrescribedTorque torque;
  Analogon.Mechanics.Inertia rotor;
equation
  connect(torque.flange, rotor.flange_a);
end M;
