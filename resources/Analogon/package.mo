within ;
package Analogon "Blocks for physical models of automotive components"
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-100,-100},{80,60}}, lineColor={128,128,128}, fillColor={240,240,240}, fillPattern=FillPattern.Solid),
        Polygon(points={{-100,60},{-80,80},{100,80},{80,60}}, lineColor={128,128,128}, fillColor={225,225,225}, fillPattern=FillPattern.Solid),
        Polygon(points={{80,60},{100,80},{100,-80},{80,-100}}, lineColor={128,128,128}, fillColor={210,210,210}, fillPattern=FillPattern.Solid),
        Ellipse(extent={{-60,-70},{40,30}}, lineColor={95,95,95}, fillColor={192,198,206}, fillPattern=FillPattern.Solid),
        Line(points={{-10,-20},{90,-20}}, color={191,0,0}, thickness=1),
        Ellipse(extent={{-30,-40},{10,0}}, lineColor={191,0,0}, fillColor={191,0,0}, fillPattern=FillPattern.Solid)}),
    Documentation(info="<html>
<p>Blocks of the mechanical, electrical, thermal and fluid domains from which a component is composed, one class per pair of coupled domains, with sources, sensors and loads, and the effects that a measurement may show to be missing.</p>
<p>Variables and signs are those of the Modelica Standard Library: a rotational flange carries the angle phi and the flow tau, a heat port the temperature T and the flow Q_flow; a flow is positive into the component. The library needs no other library.</p>
<p>A new block is one more text file: extend the partial class of its domain package and add the equations.</p>
</html>"));
end Analogon;
