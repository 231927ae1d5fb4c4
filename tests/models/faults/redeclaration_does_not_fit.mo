model M
  model Drive
    replaceable Analogon.Mechanics.Inertia load;
    Analogon.Mechanics.ViscousLoad brake;
  equation
    connect(load.flange_b, brake.flange);
  end Drive;
  Drive drive(redeclare Analogon.Thermal.HeatCapacitor load);
end M;
