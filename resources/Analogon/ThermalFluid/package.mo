within Analogon;
package ThermalFluid "Thermal and fluid domain: bodies in a stream"
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-100,-100},{80,60}}, lineColor={128,128,128}, fillColor={240,240,240}, fillPattern=FillPattern.Solid),
        Polygon(points={{-100,60},{-80,80},{100,80},{80,60}}, lineColor={128,128,128}, fillColor={225,225,225}, fillPattern=FillPattern.Solid),
        Polygon(points={{80,60},{100,80},{100,-80},{80,-100}}, lineColor={128,128,128}, fillColor={210,210,210}, fillPattern=FillPattern.Solid),
        Rectangle(extent={{-70,-70},{-30,30}}, lineColor={191,0,0}, fillColor={250,224,216}, fillPattern=FillPattern.Solid),
        Line(points={{-20,-50},{0,-38},{20,-62},{50,-50}}, color={0,127,255}, thickness=0.75, smooth=Smooth.Bezier),
        Line(points={{-20,-20},{0,-8},{20,-32},{50,-20}}, color={0,127,255}, thickness=0.75, smooth=Smooth.Bezier),
        Line(points={{-20,10},{0,22},{20,-2},{50,10}}, color={0,127,255}, thickness=0.75, smooth=Smooth.Bezier)}),
    Documentation(info="<html>
<p>BasicThermalFluid is the basic class: a body with heat capacity that exchanges heat with a stream. Extensions inherit from PartialThermalFluid.</p>
</html>"));
end ThermalFluid;
