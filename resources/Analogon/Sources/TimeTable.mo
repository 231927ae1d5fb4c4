within Analogon.Sources;
block TimeTable "A signal through points"
  Analogon.Interfaces.RealOutput y "Signal"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  parameter Real t[:](each unit="s") = {0, 1} "Times of the points, rising"
    annotation (Dialog(group="Parameters"));
  parameter Real value[size(t, 1)] = {0, 1} "Values at these times, in the unit of what is connected"
    annotation (Dialog(group="Parameters"));
equation
  y = Analogon.Tables.linear(max(t[1], min(t[end], time)), t, value);
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-100,100},{100,-100}}, lineColor={0,0,127}, fillColor={255,255,255}, fillPattern=FillPattern.Solid),
        Line(points={{-70,70},{-70,-70},{80,-70}}, color={128,128,128}),
        Line(points={{-70,-50},{-45,-20},{-20,-30},{5,45},{30,20},{55,50},{70,50}}, color={0,0,127}, thickness=0.75),
        Ellipse(extent={{-49,-16},{-41,-24}}, lineColor={0,0,127}, fillColor={0,0,127}, fillPattern=FillPattern.Solid),
        Ellipse(extent={{-24,-26},{-16,-34}}, lineColor={0,0,127}, fillColor={0,0,127}, fillPattern=FillPattern.Solid),
        Ellipse(extent={{1,49},{9,41}}, lineColor={0,0,127}, fillColor={0,0,127}, fillPattern=FillPattern.Solid),
        Ellipse(extent={{26,24},{34,16}}, lineColor={0,0,127}, fillColor={0,0,127}, fillPattern=FillPattern.Solid),
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>Runs on straight lines from point to point; before the first and behind the last it keeps their values.</p>
<pre>
  y = value[i] + (value[i + 1] - value[i])*(time - t[i])/(t[i + 1] - t[i])
</pre>
</html>"));
end TimeTable;
