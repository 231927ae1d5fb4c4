within Analogon.Effects;
package Mechanics "Effects on a shaft"
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-100,-100},{80,60}}, lineColor={128,128,128}, fillColor={240,240,240}, fillPattern=FillPattern.Solid),
        Polygon(points={{-100,60},{-80,80},{100,80},{80,60}}, lineColor={128,128,128}, fillColor={225,225,225}, fillPattern=FillPattern.Solid),
        Polygon(points={{80,60},{100,80},{100,-80},{80,-100}}, lineColor={128,128,128}, fillColor={210,210,210}, fillPattern=FillPattern.Solid),
        Ellipse(extent={{-60,-60},{30,30}}, lineColor={95,95,95}, fillColor={192,198,206}, fillPattern=FillPattern.Solid),
        Line(points={{-60,-70},{40,-70}}, color={213,94,0}, thickness=1)}),
    Documentation(info="<html>
<p>Friction, drag, loads, springs and inertias attached to a shaft, and what may lie between two shafts.</p>
</html>"));
end Mechanics;
