within Analogon;
package Sources "Sources: imposed temperatures, flows and signals"
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-100,-100},{80,60}}, lineColor={128,128,128}, fillColor={240,240,240}, fillPattern=FillPattern.Solid),
        Polygon(points={{-100,60},{-80,80},{100,80},{80,60}}, lineColor={128,128,128}, fillColor={225,225,225}, fillPattern=FillPattern.Solid),
        Polygon(points={{80,60},{100,80},{100,-80},{80,-100}}, lineColor={128,128,128}, fillColor={210,210,210}, fillPattern=FillPattern.Solid),
        Polygon(points={{-60,-60},{-60,20},{40,-20}}, lineColor={0,0,127}, fillColor={236,236,248}, fillPattern=FillPattern.Solid)}),
    Documentation(info="<html>
<p>What the surroundings impose. Prescribed sources read a signal, fixed ones have a parameter.</p>
</html>"));
end Sources;
