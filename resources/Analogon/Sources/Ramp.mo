within Analogon.Sources;
block Ramp "A ramp"
  Analogon.Interfaces.RealOutput y "Signal"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  parameter Real height = 1 "Height that is reached, in the unit of what is connected"
    annotation (Dialog(group="Parameters"));
  parameter Real duration(unit="s", min=0) = 1 "Duration of the rise"
    annotation (Dialog(group="Parameters"));
  parameter Real offset = 0 "Value before the start, in the unit of what is connected"
    annotation (Dialog(group="Parameters"));
  parameter Real startTime(unit="s") = 0 "Start"
    annotation (Dialog(group="Parameters"));
equation
  y = offset + (if time < startTime then 0 elseif time < startTime + duration then height*(time - startTime)/duration else height);
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-100,100},{100,-100}}, lineColor={0,0,127}, fillColor={255,255,255}, fillPattern=FillPattern.Solid),
        Line(points={{-70,70},{-70,-70},{80,-70}}, color={128,128,128}),
        Line(points={{-70,-50},{-35,-50},{35,50},{70,50}}, color={0,0,127}, thickness=0.75),
        Text(extent={{-90,-72},{90,-98}}, textString="h = %height", textColor={0,0,0}),
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>Rises on a straight line from one value to another, and keeps it. A duration of 0 makes it a step.</p>
<pre>
  y = offset                                                 before startTime
  y = offset + height*(time - startTime)/duration            for the duration
  y = offset + height                                        from then on
</pre>
</html>"));
end Ramp;
