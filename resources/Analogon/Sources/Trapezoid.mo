within Analogon.Sources;
block Trapezoid "A train of trapezoids"
  Analogon.Interfaces.RealOutput y "Signal"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  parameter Real amplitude = 1 "Height of the trapezoids, in the unit of what is connected"
    annotation (Dialog(group="Parameters"));
  parameter Real rising(unit="s", min=0) = 0.1 "Duration of the rise"
    annotation (Dialog(group="Parameters"));
  parameter Real width(unit="s", min=0) = 0.4 "Duration of the flat top"
    annotation (Dialog(group="Parameters"));
  parameter Real falling(unit="s", min=0) = 0.1 "Duration of the fall"
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
  y = offset + (if time < startTime then 0
    elseif since < rising then amplitude*since/rising
    elseif since < rising + width then amplitude
    elseif since < rising + width + falling then amplitude*(rising + width + falling - since)/falling
    else 0);
  since = time - startTime - period*floor((time - startTime)/period);
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-100,100},{100,-100}}, lineColor={0,0,127}, fillColor={255,255,255}, fillPattern=FillPattern.Solid),
        Line(points={{-70,70},{-70,-70},{80,-70}}, color={128,128,128}),
        Line(points={{-70,-50},{-60,-50},{-40,50},{-20,50},{0,-50},{20,-50},{40,50},{60,50},{70,0}}, color={0,0,127}, thickness=0.75),
        Text(extent={{-90,-72},{90,-98}}, textString="T = %period s", textColor={0,0,0}),
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>Rises to a value, keeps it, falls back and waits for the next period.</p>
<pre>
  y = offset + amplitude*since/rising                                 while it rises
  y = offset + amplitude                                              at the top
  y = offset + amplitude*(rising + width + falling - since)/falling   while it falls
  y = offset                                                          until the period ends
</pre>
</html>"));
end Trapezoid;
