within Analogon.Effects;
package Electric "Effects in a circuit"
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-100,-100},{80,60}}, lineColor={128,128,128}, fillColor={240,240,240}, fillPattern=FillPattern.Solid),
        Polygon(points={{-100,60},{-80,80},{100,80},{80,60}}, lineColor={128,128,128}, fillColor={225,225,225}, fillPattern=FillPattern.Solid),
        Polygon(points={{80,60},{100,80},{100,-80},{80,-100}}, lineColor={128,128,128}, fillColor={210,210,210}, fillPattern=FillPattern.Solid),
        Line(points={{-90,-20},{-60,-20}}, color={0,0,255}, thickness=1),
        Rectangle(extent={{-60,0},{40,-40}}, lineColor={0,0,255}, fillColor={255,255,255}, fillPattern=FillPattern.Solid),
        Line(points={{40,-20},{70,-20}}, color={0,0,255}, thickness=1),
        Line(points={{-70,-60},{50,-60}}, color={213,94,0}, thickness=1)}),
    Documentation(info="<html>
<p>What may lie in a wire, and what may flow beside the load.</p>
</html>"));
end Electric;
