model M
  Analogon.Mechanics.Inertia rotor;
  Analogon.Mechanics.ViscousLoad load;
equation
  connect(rotor.flange_c, load.flange);
end M;
