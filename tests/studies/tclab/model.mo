model TwoHeaters "Two equal transistor heaters side by side on a board, each with a thermistor"
  parameter Real C(unit="J/K") = 4 "Heat capacity of one transistor";
  parameter Real G(unit="W/K") = 0.012 "Loss of one transistor to the room";
  Analogon.Interfaces.RealInput heater1(unit="1") "Duty of heater 1"
    annotation (Placement(transformation(extent={{-170,30},{-150,50}})));
  Analogon.Interfaces.RealInput heater2(unit="1") "Duty of heater 2"
    annotation (Placement(transformation(extent={{-170,-50},{-150,-30}})));
  Analogon.Interfaces.RealOutput T1(unit="K") "Temperature at heater 1"
    annotation (Placement(transformation(extent={{150,70},{170,90}})));
  Analogon.Interfaces.RealOutput T2(unit="K") "Temperature at heater 2"
    annotation (Placement(transformation(extent={{150,-90},{170,-70}})));
  Analogon.Signals.Gain power1(k=1) "Watts at full duty"
    annotation (Placement(transformation(extent={{-130,30},{-110,50}})));
  Analogon.Signals.Gain power2(k=0.75) "Watts at full duty"
    annotation (Placement(transformation(extent={{-130,-50},{-110,-30}})));
  Analogon.Sources.PrescribedHeatFlow loss1
    annotation (Placement(transformation(extent={{-90,30},{-70,50}})));
  Analogon.Sources.PrescribedHeatFlow loss2
    annotation (Placement(transformation(extent={{-90,-50},{-70,-30}})));
  Analogon.Thermal.HeatCapacitor body1(C=C)
    annotation (Placement(transformation(extent={{-40,50},{-20,70}})));
  Analogon.Thermal.HeatCapacitor body2(C=C)
    annotation (Placement(transformation(extent={{-40,-70},{-20,-50}})));
  Analogon.Thermal.ThermalConductor air1(G=G)
    annotation (Placement(transformation(extent={{20,30},{40,50}})));
  Analogon.Thermal.ThermalConductor air2(G=G)
    annotation (Placement(transformation(extent={{20,-50},{40,-30}})));
  Analogon.Thermal.ThermalConductor between(G=0.005)
    annotation (Placement(transformation(extent={{-10,-10},{10,10}}, rotation=270)));
  Analogon.Sources.FixedTemperature room(T=294)
    annotation (Placement(transformation(extent={{100,-10},{80,10}})));
  Analogon.Sensors.TemperatureSensor thermistor1
    annotation (Placement(transformation(extent={{80,70},{100,90}})));
  Analogon.Sensors.TemperatureSensor thermistor2
    annotation (Placement(transformation(extent={{80,-90},{100,-70}})));
equation
  connect(heater1, power1.u);
  connect(heater2, power2.u);
  connect(power1.y, loss1.Q_flow);
  connect(power2.y, loss2.Q_flow);
  connect(loss1.port, body1.port);
  connect(loss2.port, body2.port);
  connect(body1.port, air1.port_a);
  connect(body2.port, air2.port_a);
  connect(body1.port, between.port_a);
  connect(between.port_b, body2.port);
  connect(air1.port_b, room.port);
  connect(air2.port_b, room.port);
  connect(body1.port, thermistor1.port);
  connect(body2.port, thermistor2.port);
  connect(thermistor1.T, T1);
  connect(thermistor2.T, T2);
  annotation (Diagram(coordinateSystem(extent={{-180,-110},{180,110}})));
end TwoHeaters;
