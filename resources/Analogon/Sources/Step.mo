within Analogon.Sources;
block Step "A step"
  Analogon.Interfaces.RealOutput y "Signal"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  parameter Real height = 1 "Height of the step, in the unit of what is connected"
    annotation (Dialog(group="Parameters"));
  parameter Real offset = 0 "Value before the start, in the unit of what is connected"
    annotation (Dialog(group="Parameters"));
  parameter Real startTime(unit="s") = 0 "Start"
    annotation (Dialog(group="Parameters"));
equation
  y = offset + (if time < startTime then 0 else height);
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-100,100},{100,-100}}, lineColor={0,0,127}, fillColor={255,255,255}, fillPattern=FillPattern.Solid),
        Line(points={{-70,70},{-70,-70},{80,-70}}, color={128,128,128}),
        Line(points={{-70,-50},{-10,-50},{-10,50},{70,50}}, color={0,0,127}, thickness=0.75),
        Text(extent={{-90,-72},{90,-98}}, textString="h = %height", textColor={0,0,0}),
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>Keeps one value until the start, and another one from then on.</p>
<pre>
  y = offset                 before startTime
  y = offset + height        from startTime on
</pre>
</html>"));
end Step;
