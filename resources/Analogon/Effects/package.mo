within Analogon;
package Effects "Effects that a measurement may show to be missing"
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-100,-100},{80,60}}, lineColor={128,128,128}, fillColor={240,240,240}, fillPattern=FillPattern.Solid),
        Polygon(points={{-100,60},{-80,80},{100,80},{80,60}}, lineColor={128,128,128}, fillColor={225,225,225}, fillPattern=FillPattern.Solid),
        Polygon(points={{80,60},{100,80},{100,-80},{80,-100}}, lineColor={128,128,128}, fillColor={210,210,210}, fillPattern=FillPattern.Solid),
        Polygon(points={{-10,35},{-40,-25},{-15,-20},{-30,-70},{25,-5},{0,-5},{20,35}}, lineColor={213,94,0}, fillColor={255,226,190}, fillPattern=FillPattern.Solid)}),
    Documentation(info="<html>
<p>An effect is an ordinary class with a vendor annotation that says its kind, where it may go and which parameter is its strength. At strength 0 the model is the one without the effect.</p>
<p>Three ways to add one: attach it to a connection (one connector), insert it into a connection or a signal (two connectors), or specialise a component: its class is replaced by one that extends the same base.</p>
<p>A class of your own with the same annotation takes part in the search like these.</p>
</html>"));
end Effects;
