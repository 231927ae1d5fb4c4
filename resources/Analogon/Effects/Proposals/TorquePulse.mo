within Analogon.Effects.Proposals;
model TorquePulse "Torque that acts for a while"
  extends Analogon.Interfaces.PartialOneFlange;
  parameter Real a(unit="N.m") = 0 "Torque for that while (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real t_s(unit="s") = 0 "When it sets in"
    annotation (Dialog(group="Effect"));
  parameter Real t_d(unit="s", min=1e-9) = 1 "How long it lasts"
    annotation (Dialog(group="Effect"));
  parameter Real t_w(unit="s", min=1e-9) = 1 "Width of its edges"
    annotation (Dialog(group="Effect"));
equation
  flange.tau = 0.5*a*(tanh((time - t_s)/t_w) - tanh((time - t_s - t_d)/t_w));
  annotation (
    __Analogon(effect(
      kind = "proposal.torque.pulse",
      proposal = "flange.tau = if time > t_s and time < t_s + t_d then a else 0",
      way = "attach",
      ports = {"flange"},
      strength = "a",
      fixed(t_w = "0.005*duration"),
      shape(t_s = {"0.08*duration", "0.22*duration", "0.36*duration", "0.5*duration", "0.64*duration", "0.78*duration"}, t_d = {"0.05*duration", "0.15*duration"}))),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, pattern=LinePattern.Dash, radius=10),
        Text(extent={{-70,60},{70,-60}}, textString="?", textColor={213,94,0})}),
    Documentation(info="<html>
<p>Something that happened once in the run: a hand on the shaft, a body in the way, a gust.</p>
<pre>
  flange.tau = if time &gt; t_s and time &lt; t_s + t_d then a else 0
</pre>
</html>"));
end TorquePulse;
