model LambdaSensorHeating "Exhaust-gas sensor with an electric heater in the exhaust"
  Analogon.Interfaces.RealInput ctrl_var(unit="V") "Voltage at the heater"
    annotation (Placement(transformation(extent={{-150,-10},{-130,10}})));
  Analogon.Interfaces.RealInput T_amb(unit="K") "Temperature of the exhaust gas"
    annotation (Placement(transformation(extent={{-150,-90},{-130,-70}})));
  Analogon.Interfaces.RealOutput i_mod(unit="A") "Current of the heater"
    annotation (Placement(transformation(extent={{130,30},{150,50}})));
  Analogon.ElectricThermal.BasicElectricThermal heater(R=3, alpha=0.003, T_ref=293.15)
    annotation (Placement(transformation(extent={{-70,-10},{-50,10}})));
  Analogon.ThermalFluid.BasicThermalFluid element(C=1, c_o=2, A=2.2e-4)
    annotation (Placement(transformation(extent={{-10,-10},{10,10}})));
  Analogon.Sources.PrescribedTemperature exhaust
    annotation (Placement(transformation(extent={{85,-10},{105,10}})));
equation
  connect(ctrl_var, heater.v)
    annotation (Line(points={{-130,0},{-70,0}}, color={0,0,127}));
  connect(heater.heatPort, element.solid)
    annotation (Line(points={{-50,0},{-10,0}}, color={191,0,0}));
  connect(element.fluid, exhaust.port)
    annotation (Line(points={{10,0},{85,0}}, color={191,0,0}));
  connect(T_amb, exhaust.T)
    annotation (Line(points={{-130,-80},{95,-80},{95,-10}}, color={0,0,127}));
  connect(heater.i, i_mod)
    annotation (Line(points={{-60,10},{-60,40},{130,40}}, color={0,0,127}));
  annotation (Diagram(coordinateSystem(extent={{-160,-110},{160,70}})));
end LambdaSensorHeating;
