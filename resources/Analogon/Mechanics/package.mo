within Analogon;
package Mechanics "Rotational mechanics: shafts, gears, inertias and loads"
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-100,-100},{80,60}}, lineColor={128,128,128}, fillColor={240,240,240}, fillPattern=FillPattern.Solid),
        Polygon(points={{-100,60},{-80,80},{100,80},{80,60}}, lineColor={128,128,128}, fillColor={225,225,225}, fillPattern=FillPattern.Solid),
        Polygon(points={{80,60},{100,80},{100,-80},{80,-100}}, lineColor={128,128,128}, fillColor={210,210,210}, fillPattern=FillPattern.Solid),
        Ellipse(extent={{-70,-70},{30,30}}, lineColor={95,95,95}, fillColor={192,198,206}, fillPattern=FillPattern.Solid),
        Ellipse(extent={{-35,-35},{-5,-5}}, lineColor={95,95,95}, fillColor={255,255,255}, fillPattern=FillPattern.Solid),
        Ellipse(extent={{10,-30},{60,20}}, lineColor={95,95,95}, fillColor={240,240,240}, fillPattern=FillPattern.Solid)}),
    Documentation(info="<html>
<p>Components on a shaft. BasicMechanics is the basic class of the domain: two inertias, a gear and an elastic shaft in one block.</p>
</html>"));
end Mechanics;
