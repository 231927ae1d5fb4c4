within Analogon.Sources;
model PrescribedHeatFlow "Imposes a heat flow given by a signal"
  Analogon.Interfaces.RealInput Q_flow(unit="W") "Heat to give out"
    annotation (Placement(transformation(extent={{-120,-20},{-80,20}})));
  Analogon.Interfaces.HeatPort_b port "Place that is heated"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
equation
  port.Q_flow = -Q_flow;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-100,0},{-60,0}}, color={0,0,127}),
        Line(points={{-60,-30},{40,-30}}, color={191,0,0}, thickness=1),
        Line(points={{-60,30},{40,30}}, color={191,0,0}, thickness=1),
        Polygon(points={{40,0},{40,60},{80,30},{40,0}}, lineColor={191,0,0}, fillColor={191,0,0}, fillPattern=FillPattern.Solid),
        Polygon(points={{40,-60},{40,0},{80,-30},{40,-60}}, lineColor={191,0,0}, fillColor={191,0,0}, fillPattern=FillPattern.Solid),
        Rectangle(extent={{80,60},{90,-60}}, lineColor={191,0,0}, fillColor={191,0,0}, fillPattern=FillPattern.Solid),
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>Gives the heat Q_flow to whatever is connected, at any temperature.</p>
<pre>
  port.Q_flow = -Q_flow
</pre>
</html>"));
end PrescribedHeatFlow;
