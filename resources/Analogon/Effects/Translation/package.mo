within Analogon.Effects;
package Translation "Effects on a rod"
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-100,-100},{80,60}}, lineColor={128,128,128}, fillColor={240,240,240}, fillPattern=FillPattern.Solid),
        Polygon(points={{-100,60},{-80,80},{100,80},{80,60}}, lineColor={128,128,128}, fillColor={225,225,225}, fillPattern=FillPattern.Solid),
        Polygon(points={{80,60},{100,80},{100,-80},{80,-100}}, lineColor={128,128,128}, fillColor={210,210,210}, fillPattern=FillPattern.Solid),
        Rectangle(extent={{-60,10},{40,-50}}, lineColor={0,127,0}, fillColor={214,232,214}, fillPattern=FillPattern.Solid),
        Line(points={{-70,-60},{50,-60}}, color={213,94,0}, thickness=1)}),
    Documentation(info="<html>
<p>Friction, drag, loads, springs and masses attached to a rod, and what may lie between two rods.</p>
</html>"));
end Translation;
