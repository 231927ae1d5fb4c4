model M
  Analogon.Mechanics.Inertia rotor;
  Analogon.Thermal.HeatCapacitor housing;
equation
  connect(rotor.flange_a, housing.port);
end M;
