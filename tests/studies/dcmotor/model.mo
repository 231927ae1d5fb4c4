model BrushedMotor "Brushed motor with encoder, bare shaft"
  Analogon.Interfaces.RealInput v(unit="V") "Voltage of the driver"
    annotation (Placement(transformation(extent={{-130,-10},{-110,10}})));
  Analogon.Interfaces.RealOutput w(unit="rad/s") "Speed"
    annotation (Placement(transformation(extent={{130,-50},{150,-30}})));
  Analogon.ElectricMechanical.BasicElectricMechanical motor(R=3.824, L=0, k=0.05)
    annotation (Placement(transformation(extent={{-80,-10},{-60,10}})));
  Analogon.Mechanics.Inertia rotor(J=1e-5)
    annotation (Placement(transformation(extent={{-20,-10},{0,10}})));
  Analogon.Sensors.SpeedSensor encoder
    annotation (Placement(transformation(extent={{50,-50},{70,-30}})));
equation
  connect(v, motor.v);
  connect(motor.flange, rotor.flange_a);
  connect(rotor.flange_b, encoder.flange);
  connect(encoder.w, w);
  annotation (Diagram(coordinateSystem(extent={{-140,-70},{160,40}})));
end BrushedMotor;
