model M
  Analogon.Mechanics.Inertja rotor;
  Analogon.Thermal.HeatCapacitor housing(CC = 5);
  Real x = unknown + 1;
  Real y;
equation
  y = sin(time, 2);
  connect(housing.port, housing.prot);
end M;
