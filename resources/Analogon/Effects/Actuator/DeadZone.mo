within Analogon.Effects.Actuator;
block DeadZone "Dead zone of an input channel"
  extends Analogon.Interfaces.PartialSignal;
  parameter Real b(min=0) = 0 "Width of the dead zone on either side of 0 (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real u_eps(min=1e-12) = 1e-3 "Rounding of the corners"
    annotation (Dialog(group="Numerics"));
equation
  y = u + (sqrt((u - b)^2 + u_eps^2) - sqrt((u + b)^2 + u_eps^2))/2;
  annotation (
    __Analogon(effect(
      kind = "actuator.deadzone",
      way = "insert",
      ports = {"u", "y"},
      at = "input",
      strength = "b",
      inSignalUnit = {"b"},
      oneSided = true,
      fixed(u_eps = "0.003*maxabs(u)"),
      sharper(u_eps = 0.25),
      secant = {"0.02*maxabs(u)", "0.1*maxabs(u)"})),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-80,0},{85,0}}, color={128,128,128}),
        Line(points={{0,80},{0,-80}}, color={128,128,128}),
        Line(points={{-75,-60},{-25,0},{25,0},{75,60}}, color={0,0,127}, thickness=0.75)}),
    Documentation(info="<html>
<p>An error of an actuator or its driver: inserted behind an input.</p>
<pre>
  y = u - b   for u >  b
  y = 0       between
  y = u + b   for u < -b
</pre>
</html>"));
end DeadZone;
