model TwoHeaters "Two equal transistor heaters side by side on a board, each with a thermistor"
  parameter Real C(unit="J/K") = 2 "Heat capacity of one transistor: 4 g of 500 J/(kg.K)";
  parameter Real G(unit="W/K") = 0.006 "Convection of one transistor to the room";
  parameter Real T_room(unit="K") = 296.15 "Temperature of the room";
  parameter Real k_r(unit="W/K4") = 0.9*1e-3*5.67e-8 "Radiation of one transistor: 10 cm2 of emissivity 0.9";
  Analogon.Interfaces.RealInput heater1(unit="1") "Duty of heater 1"
    annotation (Placement(transformation(extent={{-170,30},{-150,50}})));
  Analogon.Interfaces.RealInput heater2(unit="1") "Duty of heater 2"
    annotation (Placement(transformation(extent={{-170,-50},{-150,-30}})));
  Analogon.Interfaces.RealOutput T1(unit="K") "Temperature at heater 1"
    annotation (Placement(transformation(extent={{150,70},{170,90}})));
  Analogon.Interfaces.RealOutput T2(unit="K") "Temperature at heater 2"
    annotation (Placement(transformation(extent={{150,-90},{170,-70}})));
  Analogon.Signals.Gain power1(k=0.5) "Watts at full duty"
    annotation (Placement(transformation(extent={{-130,30},{-110,50}})));
  Analogon.Signals.Gain power2(k=0.375) "Watts at full duty"
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
  Analogon.Thermal.ThermalConductor between(G=0.0025)
    annotation (Placement(transformation(extent={{-10,-10},{10,10}}, rotation=270)));
  Analogon.Sources.FixedTemperature room(T=T_room)
    annotation (Placement(transformation(extent={{100,-10},{80,10}})));
  Analogon.Effects.Thermal.Radiation rays1(k_r=k_r, T_amb=T_room)
    annotation (Placement(transformation(extent={{-10,80},{10,100}})));
  Analogon.Effects.Thermal.Radiation rays2(k_r=k_r, T_amb=T_room)
    annotation (Placement(transformation(extent={{-10,-100},{10,-80}})));
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
  connect(body1.port, rays1.port);
  connect(body2.port, rays2.port);
  connect(body1.port, thermistor1.port);
  connect(body2.port, thermistor2.port);
  connect(thermistor1.T, T1);
  connect(thermistor2.T, T2);
  annotation (Diagram(coordinateSystem(extent={{-180,-110},{180,110}})));
end TwoHeaters;
