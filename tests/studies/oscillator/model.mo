model Oscillator "Electronic oscillator, read as a mass on a spring"
  Analogon.Interfaces.RealInput u(unit="N.m") annotation (Placement(transformation(extent={{-120,-10},{-100,10}})));
  Analogon.Interfaces.RealOutput y(unit="rad") annotation (Placement(transformation(extent={{100,-10},{120,10}})));
  Analogon.Sources.PrescribedTorque drive annotation (Placement(transformation(extent={{-80,-10},{-60,10}})));
  Analogon.Mechanics.Inertia mass(J=5e-6) annotation (Placement(transformation(extent={{-40,-10},{-20,10}})));
  Analogon.Mechanics.SpringDamper spring(c=1, d=2e-4) annotation (Placement(transformation(extent={{0,-10},{20,10}})));
  Analogon.Mechanics.Fixed wall annotation (Placement(transformation(extent={{40,-10},{60,10}})));
  Analogon.Sensors.AngleSensor sensor annotation (Placement(transformation(extent={{0,40},{20,60}})));
equation
  connect(u, drive.tau);
  connect(drive.flange, mass.flange_a);
  connect(mass.flange_b, spring.flange_a);
  connect(spring.flange_b, wall.flange);
  connect(mass.flange_b, sensor.flange);
  connect(sensor.phi, y);
end Oscillator;
