within Analogon;
package Tables "Functions given by points"
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-100,-100},{80,60}}, lineColor={128,128,128}, fillColor={240,240,240}, fillPattern=FillPattern.Solid),
        Polygon(points={{-100,60},{-80,80},{100,80},{80,60}}, lineColor={128,128,128}, fillColor={225,225,225}, fillPattern=FillPattern.Solid),
        Polygon(points={{80,60},{100,80},{100,-80},{80,-100}}, lineColor={128,128,128}, fillColor={210,210,210}, fillPattern=FillPattern.Solid),
        Line(points={{-80,-70},{-40,-50},{0,10},{60,30}}, color={0,0,127})}),
    Documentation(info="<html>
<p>Values between measured points, for equations of a block: <code>y = Analogon.Tables.linear(u, {0, 1, 2}, {0, 1, 4})</code>. The points must be known before the simulation and their abscissas must rise. Outside the points the value goes on with the outer slope.</p>
</html>"));
end Tables;
