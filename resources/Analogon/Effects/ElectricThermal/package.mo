within Analogon.Effects;
package ElectricThermal "Extensions of the heating resistor"
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-100,-100},{80,60}}, lineColor={128,128,128}, fillColor={240,240,240}, fillPattern=FillPattern.Solid),
        Polygon(points={{-100,60},{-80,80},{100,80},{80,60}}, lineColor={128,128,128}, fillColor={225,225,225}, fillPattern=FillPattern.Solid),
        Polygon(points={{80,60},{100,80},{100,-80},{80,-100}}, lineColor={128,128,128}, fillColor={210,210,210}, fillPattern=FillPattern.Solid),
        Line(points={{-70,-20},{-50,-20},{-40,10},{-25,-50},{-10,10},{5,-50},{20,10},{30,-20},{60,-20}}, color={213,94,0}, thickness=0.75)}),
    Documentation(info="<html>
<p>Classes that replace BasicElectricThermal: they extend the same base and take the same parameters.</p>
</html>"));
end ElectricThermal;
