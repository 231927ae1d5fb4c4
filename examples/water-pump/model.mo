model WaterPump "Electric water pump: motor, rotor, impeller"
  Analogon.Interfaces.RealInput v_cmd(unit="V") "Voltage at the motor"
    annotation (Placement(transformation(extent={{-150,-10},{-130,10}})));
  Analogon.Interfaces.RealOutput i_mot(unit="A") "Current of the motor"
    annotation (Placement(transformation(extent={{150,40},{170,60}})));
  Analogon.Interfaces.RealOutput w_pump(unit="rad/s") "Speed of the pump"
    annotation (Placement(transformation(extent={{150,-50},{170,-30}})));
  Analogon.ElectricMechanical.BasicElectricMechanical motor(R=0.5, L=3.5e-4, k=0.025)
    annotation (Placement(transformation(extent={{-90,-10},{-70,10}})));
  Analogon.Mechanics.Inertia rotor(J=5e-5)
    annotation (Placement(transformation(extent={{-30,-10},{-10,10}})));
  Analogon.Mechanics.Inertia impeller(J=1.4e-5)
    annotation (Placement(transformation(extent={{30,-10},{50,10}})));
  Analogon.Mechanics.QuadraticLoad load(k_q=2e-6)
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  Analogon.Sensors.SpeedSensor speed
    annotation (Placement(transformation(extent={{90,-50},{110,-30}})));
equation
  connect(v_cmd, motor.v)
    annotation (Line(points={{-130,0},{-90,0}}, color={0,0,127}));
  connect(motor.flange, rotor.flange_a)
    annotation (Line(points={{-70,0},{-30,0}}, color={95,95,95}));
  connect(rotor.flange_b, impeller.flange_a)
    annotation (Line(points={{-10,0},{30,0}}, color={95,95,95}));
  connect(impeller.flange_b, load.flange)
    annotation (Line(points={{50,0},{90,0}}, color={95,95,95}));
  connect(impeller.flange_b, speed.flange)
    annotation (Line(points={{50,0},{70,0},{70,-40},{90,-40}}, color={95,95,95}));
  connect(motor.i, i_mot)
    annotation (Line(points={{-80,10},{-80,50},{150,50}}, color={0,0,127}));
  connect(speed.w, w_pump)
    annotation (Line(points={{110,-40},{150,-40}}, color={0,0,127}));
  annotation (Diagram(coordinateSystem(extent={{-160,-70},{180,80}})));
end WaterPump;
