within Analogon.Sources;
block Sine "A sine"
  Analogon.Interfaces.RealOutput y "Signal"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  parameter Real amplitude = 1 "Amplitude, in the unit of what is connected"
    annotation (Dialog(group="Parameters"));
  parameter Real f(unit="Hz", min=0) = 1 "Frequency"
    annotation (Dialog(group="Parameters"));
  parameter Real phase(unit="rad") = 0 "Phase at the start"
    annotation (Dialog(group="Parameters"));
  parameter Real offset = 0 "Value about which it swings, in the unit of what is connected"
    annotation (Dialog(group="Parameters"));
  parameter Real startTime(unit="s") = 0 "Start"
    annotation (Dialog(group="Parameters"));
equation
  y = offset + (if time < startTime then 0 else amplitude*sin(6.283185307179586*f*(time - startTime) + phase));
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-100,100},{100,-100}}, lineColor={0,0,127}, fillColor={255,255,255}, fillPattern=FillPattern.Solid),
        Line(points={{-70,70},{-70,-70},{80,-70}}, color={128,128,128}),
        Line(points={{-70,0},{-60,31},{-50,50},{-40,50},{-30,31},{-20,0},{-10,-31},{0,-50},{10,-50},{20,-31},{30,0},{40,31},{50,50},{60,50},{70,31}}, color={0,0,127}, thickness=0.75),
        Text(extent={{-90,-72},{90,-98}}, textString="f = %f Hz", textColor={0,0,0}),
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>Swings about the offset from the start on.</p>
<pre>
  y = offset + amplitude*sin(2*pi*f*(time - startTime) + phase)
</pre>
</html>"));
end Sine;
