within Analogon.Sources;
model FixedTemperature "Imposes a constant temperature"
  Analogon.Interfaces.HeatPort_b port "Place that is kept at T"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  parameter Real T(unit="K", displayUnit="degC", min=0) = 293.15 "Temperature"
    annotation (Dialog(group="Parameters"));
equation
  port.T = T;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-70,70},{70,-70}}, lineColor={191,0,0}, fillColor={250,236,214}, fillPattern=FillPattern.Solid, radius=30),
        Line(points={{-100,0},{-70,0}}, color={191,0,0}, thickness=0.5),
        Rectangle(extent={{14,44},{26,-20}}, lineColor={191,0,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=6),
        Ellipse(extent={{8,-14},{32,-38}}, lineColor={191,0,0}, fillColor={191,0,0}, fillPattern=FillPattern.Solid),
        Line(points={{20,-20},{20,24}}, color={191,0,0}, thickness=1),
        Text(extent={{-66,30},{10,-30}}, textString="%T K", textColor={191,0,0}),
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>The surroundings at a constant temperature.</p>
<pre>
  port.T = T
</pre>
</html>"));
end FixedTemperature;
