within Analogon.Effects;
package ThermalFluid "Extensions of the body in a stream"
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-100,-100},{80,60}}, lineColor={128,128,128}, fillColor={240,240,240}, fillPattern=FillPattern.Solid),
        Polygon(points={{-100,60},{-80,80},{100,80},{80,60}}, lineColor={128,128,128}, fillColor={225,225,225}, fillPattern=FillPattern.Solid),
        Polygon(points={{80,60},{100,80},{100,-80},{80,-100}}, lineColor={128,128,128}, fillColor={210,210,210}, fillPattern=FillPattern.Solid),
        Rectangle(extent={{-70,-70},{-30,30}}, lineColor={191,0,0}, fillColor={250,224,216}, fillPattern=FillPattern.Solid),
        Line(points={{-20,-20},{0,-8},{20,-32},{50,-20}}, color={213,94,0}, thickness=1, smooth=Smooth.Bezier)}),
    Documentation(info="<html>
<p>Classes that replace BasicThermalFluid: they extend the same base and take the same parameters.</p>
</html>"));
end ThermalFluid;
