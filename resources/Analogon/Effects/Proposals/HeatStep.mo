within Analogon.Effects.Proposals;
model HeatStep "Heat flow that sets in during the run"
  extends Analogon.Interfaces.PartialOneHeatPort;
  parameter Real a(unit="W") = 0 "Heat flow from then on (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real t_s(unit="s") = 0 "When"
    annotation (Dialog(group="Effect"));
  parameter Real t_w(unit="s", min=1e-9) = 1 "Width of the step"
    annotation (Dialog(group="Effect"));
equation
  port.Q_flow = 0.5*a*(1 + tanh((time - t_s)/t_w));
  annotation (
    __Analogon(effect(
      kind = "proposal.heat.step",
      proposal = "port.Q_flow = if time > t_s then a else 0",
      way = "attach",
      ports = {"port"},
      strength = "a",
      fixed(t_w = "0.01*duration"),
      shape(t_s = {"0.15*duration", "0.3*duration", "0.45*duration", "0.6*duration", "0.75*duration", "0.9*duration"}))),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, pattern=LinePattern.Dash, radius=10),
        Text(extent={{-70,60},{70,-60}}, textString="?", textColor={213,94,0})}),
    Documentation(info="<html>
<p>A condition that changed in mid run: a fan, a draught, a neighbour.</p>
<pre>
  port.Q_flow = if time > t_s then a else 0
</pre>
</html>"));
end HeatStep;
