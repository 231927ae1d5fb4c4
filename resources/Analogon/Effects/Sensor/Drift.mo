within Analogon.Effects.Sensor;
block Drift "Drift of a measured channel"
  extends Analogon.Interfaces.PartialSignal;
  parameter Real a = 0 "Drift, unit of the signal per second (0: off)"
    annotation (Dialog(group="Effect"));
  Real t_r(unit="s", start=0, fixed=true, nominal=100) "Time since the start of the recording";
equation
  der(t_r) = 1;
  y = u + a*t_r;
  annotation (
    __Analogon(effect(
      kind = "sensor.drift",
      way = "insert",
      ports = {"u", "y"},
      at = "output",
      strength = "a",
      inSignalRate = {"a"})),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-80,-70},{85,-70}}, color={128,128,128}),
        Line(points={{-70,80},{-70,-80}}, color={128,128,128}),
        Line(points={{-70,-20},{80,60}}, color={0,0,127}, thickness=0.75),
        Line(points={{-70,-20},{80,-20}}, color={128,128,128}, thickness=0.25, pattern=LinePattern.Dash)}),
    Documentation(info="<html>
<p>An error of a sensor: inserted in front of a measured output.</p>
<pre>
  y(t) = u(t) + a*(t - t_0)
</pre>
</html>"));
end Drift;
