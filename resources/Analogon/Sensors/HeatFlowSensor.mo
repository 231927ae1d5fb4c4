within Analogon.Sensors;
model HeatFlowSensor "Ideal heat flow sensor between two places"
  Analogon.Interfaces.HeatPort_a port_a "One side"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  Analogon.Interfaces.HeatPort_b port_b "Other side"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  Analogon.Interfaces.RealOutput Q_flow(unit="W") "Heat from port_a to port_b"
    annotation (Placement(transformation(origin={0,-100}, extent={{-10,-10},{10,10}}, rotation=270)));
equation
  port_a.T = port_b.T;
  port_a.Q_flow + port_b.Q_flow = 0;
  Q_flow = port_a.Q_flow;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-100,0},{-70,0}}, color={191,0,0}, thickness=0.5),
        Line(points={{70,0},{100,0}}, color={191,0,0}, thickness=0.5),
        Line(points={{0,-70},{0,-100}}, color={0,0,127}),
        Ellipse(extent={{-70,70},{70,-70}}, lineColor={0,0,0}, fillColor={245,245,245}, fillPattern=FillPattern.Solid),
        Line(points={{0,70},{0,52}}, color={0,0,0}),
        Line(points={{50,50},{37,37}}, color={0,0,0}),
        Line(points={{-50,50},{-37,37}}, color={0,0,0}),
        Line(points={{70,0},{52,0}}, color={0,0,0}),
        Line(points={{-70,0},{-52,0}}, color={0,0,0}),
        Line(points={{0,0},{28,40}}, color={0,0,0}, thickness=0.75),
        Ellipse(extent={{-7,7},{7,-7}}, lineColor={0,0,0}, fillColor={0,0,0}, fillPattern=FillPattern.Solid),
        Text(extent={{-50,-14},{50,-50}}, textString="Q", textColor={191,0,0}),
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>Tells the heat that passes and hinders nothing.</p>
<pre>
  port_a.T = port_b.T
  port_a.Q_flow + port_b.Q_flow = 0
  Q_flow = port_a.Q_flow
</pre>
</html>"));
end HeatFlowSensor;
