within Analogon.Effects.Proposals;
model UpperStop "End stop at a large angle"
  extends Analogon.Interfaces.PartialOneFlange;
  parameter Real a(unit="N.m/rad", min=0) = 0 "Stiffness of the stop (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real phi_s(unit="rad") = 1 "Angle where it touches"
    annotation (Dialog(group="Effect"));
  parameter Real e(unit="s/rad", min=0) = 0 "Damping of the touch, of its stiffness"
    annotation (Dialog(group="Effect"));
  parameter Real phi_e(unit="rad", min=1e-12) = 0.01 "Rounding of the touch"
    annotation (Dialog(group="Effect"));
equation
  flange.tau = 0.5*a*(phi - phi_s + sqrt((phi - phi_s)^2 + phi_e^2))*(1 + e*w);
  annotation (
    __Analogon(effect(
      kind = "proposal.stop.upper",
      proposal = "flange.tau = a*max(0, phi - phi_s)*(1 + e*w)",
      way = "attach",
      ports = {"flange"},
      strength = "a",
      oneSided = true,
      along = "phi",
      fixed(phi_e = "0.001*range(phi)"),
      secant = {"through(flange)/(0.2*range(phi))", "through(flange)/(0.005*range(phi))"},
      shape(e = {"2/maxabs(w)"}, phi_s = {"maximum(phi) - 0.003*range(phi)", "maximum(phi) - 0.03*range(phi)", "maximum(phi) - 0.15*range(phi)"}))),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, pattern=LinePattern.Dash, radius=10),
        Text(extent={{-70,60},{70,-60}}, textString="?", textColor={213,94,0})}),
    Documentation(info="<html>
<p>A stop, a seal or an end of travel.</p>
<pre>
  flange.tau = a*max(0, phi - phi_s)*(1 + e*w)
</pre>
</html>"));
end UpperStop;
