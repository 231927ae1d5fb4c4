within Analogon.Effects.Proposals;
block SensorStep "Offset that sets in during the run"
  extends Analogon.Interfaces.PartialSignal;
  parameter Real a = 0 "Offset from then on (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real t_s(unit="s") = 0 "When"
    annotation (Dialog(group="Effect"));
  parameter Real t_w(unit="s", min=1e-9) = 1 "Width of the step"
    annotation (Dialog(group="Effect"));
equation
  y = u + 0.5*a*(1 + tanh((time - t_s)/t_w));
  annotation (
    __Analogon(effect(
      kind = "proposal.sensor.step",
      proposal = "y = u + (if time > t_s then a else 0)",
      way = "insert",
      ports = {"u", "y"},
      at = "output",
      strength = "a",
      inSignalUnit = {"a"},
      fixed(t_w = "0.002*duration"),
      shape(t_s = {"0.15*duration", "0.3*duration", "0.45*duration", "0.6*duration", "0.75*duration", "0.9*duration"}))),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, pattern=LinePattern.Dash, radius=10),
        Text(extent={{-70,60},{70,-60}}, textString="?", textColor={213,94,0})}),
    Documentation(info="<html>
<p>A sensor that was knocked, unplugged or re-zeroed in mid run.</p>
<pre>
  y = if time > t_s then u + a else u
</pre>
</html>"));
end SensorStep;
