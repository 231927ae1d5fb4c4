within Analogon.Sources;
block Pulse "A train of pulses"
  Analogon.Interfaces.RealOutput y "Signal"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  parameter Real amplitude = 1 "Height of the pulses, in the unit of what is connected"
    annotation (Dialog(group="Parameters"));
  parameter Real width(unit="%", min=0, max=100) = 50 "Part of the period that a pulse lasts"
    annotation (Dialog(group="Parameters"));
  parameter Real period(unit="s", min=0) = 1 "Period"
    annotation (Dialog(group="Parameters"));
  parameter Real offset = 0 "Value before the start, in the unit of what is connected"
    annotation (Dialog(group="Parameters"));
  parameter Real startTime(unit="s") = 0 "Start"
    annotation (Dialog(group="Parameters"));
protected
  Real since(unit="s") "Time since the present period began";
equation
  y = offset + (if time < startTime then 0 elseif since < period*width/100 then amplitude else 0);
  since = time - startTime - period*floor((time - startTime)/period);
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-100,100},{100,-100}}, lineColor={0,0,127}, fillColor={255,255,255}, fillPattern=FillPattern.Solid),
        Line(points={{-70,70},{-70,-70},{80,-70}}, color={128,128,128}),
        Line(points={{-70,-50},{-50,-50},{-50,50},{-20,50},{-20,-50},{10,-50},{10,50},{40,50},{40,-50},{70,-50}}, color={0,0,127}, thickness=0.75),
        Text(extent={{-90,-72},{90,-98}}, textString="T = %period s", textColor={0,0,0}),
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>Switches a value on and off again, once in each period from the start on.</p>
<pre>
  y = offset + amplitude        for the first width/100 of each period
  y = offset                    for the rest of it, and before startTime
</pre>
</html>"));
end Pulse;
