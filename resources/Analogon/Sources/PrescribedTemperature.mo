within Analogon.Sources;
model PrescribedTemperature "Imposes a temperature given by a signal"
  Analogon.Interfaces.RealInput T(unit="K") "Temperature to impose"
    annotation (Placement(transformation(origin={0,-100}, extent={{-20,-20},{20,20}}, rotation=90)));
  Analogon.Interfaces.HeatPort_b port "Place that is kept at T"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
equation
  port.T = T;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-70,70},{70,-70}}, lineColor={191,0,0}, fillColor={250,236,214}, fillPattern=FillPattern.Solid, radius=30),
        Line(points={{-100,0},{-70,0}}, color={191,0,0}, thickness=0.5),
        Line(points={{0,-100},{0,-70}}, color={0,0,127}),
        Text(extent={{-62,36},{8,-36}}, textString="T", textColor={191,0,0}),
        Rectangle(extent={{14,44},{26,-20}}, lineColor={191,0,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=6),
        Ellipse(extent={{8,-14},{32,-38}}, lineColor={191,0,0}, fillColor={191,0,0}, fillPattern=FillPattern.Solid),
        Line(points={{20,-20},{20,24}}, color={191,0,0}, thickness=1),
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>A stream or body so large that its temperature is not changed by the heat it takes.</p>
<pre>
  port.T = T
</pre>
</html>"));
end PrescribedTemperature;
