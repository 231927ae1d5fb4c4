within Analogon.Sources;
block Chirp "A sine whose frequency rises"
  Analogon.Interfaces.RealOutput y "Signal"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  parameter Real amplitude = 1 "Amplitude, in the unit of what is connected"
    annotation (Dialog(group="Parameters"));
  parameter Real f1(unit="Hz", min=0) = 0.1 "Frequency at the start"
    annotation (Dialog(group="Parameters"));
  parameter Real f2(unit="Hz", min=0) = 10 "Frequency at the end"
    annotation (Dialog(group="Parameters"));
  parameter Real duration(unit="s", min=0) = 10 "Duration of the sweep"
    annotation (Dialog(group="Parameters"));
  parameter Real offset = 0 "Value about which it swings, in the unit of what is connected"
    annotation (Dialog(group="Parameters"));
  parameter Real startTime(unit="s") = 0 "Start"
    annotation (Dialog(group="Parameters"));
protected
  Real since(unit="s") "Time since the start";
  Real swept(unit="s") "Time that the frequency has risen";
equation
  since = max(0, time - startTime);
  swept = min(since, duration);
  y = offset + amplitude*sin(6.283185307179586*(f1*swept + 0.5*(f2 - f1)*swept*swept/duration + f2*(since - swept)));
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-100,100},{100,-100}}, lineColor={0,0,127}, fillColor={255,255,255}, fillPattern=FillPattern.Solid),
        Line(points={{-70,70},{-70,-70},{80,-70}}, color={128,128,128}),
        Line(points={{-70,0},{-58,35},{-46,50},{-34,35},{-24,0},{-16,-35},{-8,-50},{0,-35},{7,0},{13,40},{18,50},{23,40},{28,0},{33,-42},{37,-50},{41,-42},{45,0},{49,45},{52,50},{55,45},{58,0},{62,-50},{66,0},{70,50}}, color={0,0,127}, thickness=0.75),
        Text(extent={{-90,-72},{90,-98}}, textString="%f1 … %f2 Hz", textColor={0,0,0}),
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>A sine that excites one frequency after the other: its frequency runs on a straight line from f1 to f2, and stays there.</p>
<pre>
  f = f1 + (f2 - f1)*(time - startTime)/duration
  y = offset + amplitude*sin(2*pi*integral(f))
</pre>
</html>"));
end Chirp;
