within Analogon.Effects.Proposals;
model UnequalDrag "Viscous friction that differs with the direction"
  extends Analogon.Interfaces.PartialOneFlange;
  parameter Real a(unit="N.m.s/rad") = 0 "Half the difference of the two coefficients (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real w_eps(unit="rad/s", min=1e-12) = 0.01 "Rounding at rest"
    annotation (Dialog(group="Numerics"));
equation
  flange.tau = a*sqrt(w^2 + w_eps^2);
  annotation (
    __Analogon(effect(
      kind = "proposal.drag.direction",
      proposal = "flange.tau = a*abs(w)",
      way = "attach",
      ports = {"flange"},
      strength = "a",
      fixed(w_eps = "0.002*maxabs(w)"))),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, pattern=LinePattern.Dash, radius=10),
        Text(extent={{-70,60},{70,-60}}, textString="?", textColor={213,94,0})}),
    Documentation(info="<html>
<p>A guide or a gear that runs harder one way than the other.</p>
<pre>
  flange.tau = a*abs(w)
</pre>
</html>"));
end UnequalDrag;
