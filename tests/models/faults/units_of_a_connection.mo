model M
  block Source
    Analogon.Interfaces.RealOutput y(unit = "V");
  equation
    y = 12;
  end Source;
  Source source;
  Analogon.Sources.PrescribedTorque torque;
  Analogon.Mechanics.Inertia rotor;
equation
  connect(source.y, torque.tau);
  connect(torque.flange, rotor.flange_a);
end M;
