within Analogon;
package Thermal "Heat storage and conduction"
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-100,-100},{80,60}}, lineColor={128,128,128}, fillColor={240,240,240}, fillPattern=FillPattern.Solid),
        Polygon(points={{-100,60},{-80,80},{100,80},{80,60}}, lineColor={128,128,128}, fillColor={225,225,225}, fillPattern=FillPattern.Solid),
        Polygon(points={{80,60},{100,80},{100,-80},{80,-100}}, lineColor={128,128,128}, fillColor={210,210,210}, fillPattern=FillPattern.Solid),
        Rectangle(extent={{-60,-60},{30,20}}, lineColor={191,0,0}, fillColor={250,224,216}, fillPattern=FillPattern.Solid)}),
    Documentation(info="<html>
<p>Lumped heat capacities and conductances.</p>
</html>"));
end Thermal;
