model UnsignedSpeedSensor "Pulse counter: speed without its sign, as a voltage"
  parameter Real k(unit="V.s/rad") = 1 "Volts at 1 rad/s";
  Analogon.Interfaces.Flange_a flange annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  Analogon.Interfaces.RealOutput y(unit="V") annotation (Placement(transformation(extent={{100,-10},{120,10}})));
equation
  flange.tau = 0;
  y = k*abs(der(flange.phi));
end UnsignedSpeedSensor;

model CoupledDrives "Two motors on one belt, a pulley on springs"
  Analogon.Interfaces.RealInput u(unit="V");
  Analogon.Interfaces.RealOutput y(unit="V");
  Analogon.ElectricMechanical.BasicElectricMechanical motor(R=1, L=0, k=1);
  Analogon.Mechanics.BasicMechanics belt(r=1, J1=0.3, J2=0.05, c=30, d=0.1);
  Analogon.Mechanics.ViscousLoad bearing(b=0.05);
  UnsignedSpeedSensor sensor(k=1);
equation
  connect(u, motor.v);
  connect(motor.flange, belt.flange_a);
  connect(belt.flange_b, bearing.flange);
  connect(belt.flange_b, sensor.flange);
  connect(sensor.y, y);
end CoupledDrives;
