within Analogon.Effects.Proposals;
model PeriodicTorque "Torque that repeats in time"
  extends Analogon.Interfaces.PartialOneFlange;
  parameter Real a(unit="N.m") = 0 "Sine part (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real b(unit="N.m") = 0 "Cosine part"
    annotation (Dialog(group="Effect"));
  parameter Real P(unit="s", min=1e-9) = 1 "Period"
    annotation (Dialog(group="Effect"));
equation
  flange.tau = a*sin(6.283185307179586*time/P) + b*cos(6.283185307179586*time/P);
  annotation (
    __Analogon(effect(
      kind = "proposal.torque.periodic",
      proposal = "flange.tau = a*sin(2*pi*time/P) + b*cos(2*pi*time/P)",
      way = "attach",
      ports = {"flange"},
      strength = "a",
      linear = {"b"},
      shape(P = {"period"}))),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, pattern=LinePattern.Dash, radius=10),
        Text(extent={{-70,60},{70,-60}}, textString="?", textColor={213,94,0})}),
    Documentation(info="<html>
<p>Something outside the model that turns or switches at its own pace.</p>
<pre>
  flange.tau = a*sin(2*pi*time/P) + b*cos(2*pi*time/P)
</pre>
</html>"));
end PeriodicTorque;
