within Analogon.Sensors;
model TemperatureSensor "Ideal temperature sensor"
  Analogon.Interfaces.HeatPort_a port "Place that is observed"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  Analogon.Interfaces.RealOutput T(unit="K") "Temperature of the port"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
equation
  T = port.T;
  port.Q_flow = 0;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-100,0},{-14,0}}, color={191,0,0}, thickness=0.5),
        Line(points={{14,0},{100,0}}, color={0,0,127}),
        Rectangle(extent={{-14,84},{14,-40}}, lineColor={0,0,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=14),
        Ellipse(extent={{-24,-34},{24,-84}}, lineColor={0,0,0}, fillColor={191,0,0}, fillPattern=FillPattern.Solid),
        Rectangle(extent={{-7,40},{7,-44}}, lineColor={191,0,0}, fillColor={191,0,0}, fillPattern=FillPattern.Solid),
        Line(points={{14,20},{26,20}}, color={0,0,0}),
        Line(points={{14,40},{26,40}}, color={0,0,0}),
        Line(points={{14,60},{26,60}}, color={0,0,0}),
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>Reads the temperature of a place and takes no heat.</p>
<pre>
  T = port.T
  port.Q_flow = 0
</pre>
</html>"));
end TemperatureSensor;
