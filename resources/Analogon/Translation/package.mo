within Analogon;
package Translation "Translational mechanics: rods, masses and springs"
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-100,-100},{80,60}}, lineColor={128,128,128}, fillColor={240,240,240}, fillPattern=FillPattern.Solid),
        Polygon(points={{-100,60},{-80,80},{100,80},{80,60}}, lineColor={128,128,128}, fillColor={225,225,225}, fillPattern=FillPattern.Solid),
        Polygon(points={{80,60},{100,80},{100,-80},{80,-100}}, lineColor={128,128,128}, fillColor={210,210,210}, fillPattern=FillPattern.Solid),
        Rectangle(extent={{-60,10},{40,-50}}, lineColor={0,127,0}, fillColor={214,232,214}, fillPattern=FillPattern.Solid),
        Line(points={{-90,-60},{70,-60}}, color={0,127,0}, thickness=1)}),
    Documentation(info="<html>
<p>Components on a rod, and the rack that joins it to a shaft. The flange carries the position s and the flow f, as in the Modelica Standard Library.</p>
</html>"));
end Translation;
