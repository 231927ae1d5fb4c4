within Analogon.Effects;
package Sensor "Effects of a measured channel"
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-100,-100},{80,60}}, lineColor={128,128,128}, fillColor={240,240,240}, fillPattern=FillPattern.Solid),
        Polygon(points={{-100,60},{-80,80},{100,80},{80,60}}, lineColor={128,128,128}, fillColor={225,225,225}, fillPattern=FillPattern.Solid),
        Polygon(points={{80,60},{100,80},{100,-80},{80,-100}}, lineColor={128,128,128}, fillColor={210,210,210}, fillPattern=FillPattern.Solid),
        Ellipse(extent={{-60,-60},{40,40}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid),
        Line(points={{-10,-10},{20,20}}, color={0,0,0}, thickness=0.75)}),
    Documentation(info="<html>
<p>Errors of sensors, inserted in front of an output.</p>
</html>"));
end Sensor;
