model Drive "Ball screw drive: mass and viscous friction, written as its rotational equivalent"
  Analogon.Interfaces.RealInput force(unit="N.m") annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  Analogon.Interfaces.RealOutput speed(unit="rad/s") annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  Analogon.Sources.PrescribedTorque motor annotation (Placement(transformation(extent={{-70,-10},{-50,10}})));
  Analogon.Mechanics.Inertia carriage(J=100) annotation (Placement(transformation(extent={{-20,-10},{0,10}})));
  Analogon.Mechanics.ViscousLoad guide(b=200) annotation (Placement(transformation(extent={{30,-40},{50,-20}})));
  Analogon.Sensors.SpeedSensor encoder annotation (Placement(transformation(extent={{40,-10},{60,10}})));
equation
  connect(force, motor.tau);
  connect(motor.flange, carriage.flange_a);
  connect(carriage.flange_b, guide.flange);
  connect(carriage.flange_b, encoder.flange);
  connect(encoder.w, speed);
end Drive;
