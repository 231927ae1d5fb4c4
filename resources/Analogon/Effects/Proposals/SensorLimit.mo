within Analogon.Effects.Proposals;
block SensorLimit "Upper limit of a measured channel"
  extends Analogon.Interfaces.PartialSignal;
  parameter Real s(min=0) = 0 "1/limit (0: no limit)"
    annotation (Dialog(group="Effect"));
  final parameter Real y_max = if s > 0 then 1/s else 0 "Limit, in the unit of the signal (0 while there is none)";
  parameter Real y_e(min=1e-12) = 0.01 "Rounding of the corner"
    annotation (Dialog(group="Effect"));
  Real beyond "How far beyond the limit";
equation
  // from the smooth maximum of 0 and abs(u) - 1/s; written so that it is 0 for s = 0
  beyond = 0.5*(s*abs(u) - 1 + sqrt((s*abs(u) - 1)^2 + (s*y_e)^2))/max(s, 1e-12);
  y = u*(1 - beyond/max(abs(u), y_e));
  annotation (
    __Analogon(effect(
      kind = "proposal.sensor.limit",
      proposal = "y = min(u, y_max)",
      way = "insert",
      ports = {"u", "y"},
      at = "output",
      strength = "s",
      inSignalUnit = {"y_max"},
      oneSided = true,
      fixed(y_e = "0.005*range(u)"),
      sharper(y_e = 0.25),
      secant = {"1/(maxabs(u) - 0.02*range(u))", "1/(maxabs(u) - 0.08*range(u))", "1/(maxabs(u) - 0.2*range(u))"})),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, pattern=LinePattern.Dash, radius=10),
        Text(extent={{-70,60},{70,-60}}, textString="?", textColor={213,94,0})}),
    Documentation(info="<html>
<p>A sensor or an amplifier that runs into its limit.</p>
<pre>
  y = min(u, y_max)   with y_max = 1/s
</pre>
</html>"));
end SensorLimit;
