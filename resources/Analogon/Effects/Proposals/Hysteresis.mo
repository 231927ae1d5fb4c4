within Analogon.Effects.Proposals;
model Hysteresis "Friction that builds up over a travel"
  extends Analogon.Interfaces.PartialOneFlange;
  parameter Real tau_h(unit="N.m", min=0) = 0 "Torque once it has built up (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real phi_h(unit="rad", min=1e-12) = 1 "Travel over which it builds up"
    annotation (Dialog(group="Effect"));
  Real z(start=0, fixed=true, unit="1") "Share that has built up";
equation
  phi_h*der(z) = w - abs(w)*z;
  flange.tau = tau_h*z;
  annotation (
    __Analogon(effect(
      kind = "proposal.hysteresis",
      proposal = "flange.tau = tau_h*z with phi_h*der(z) = w - abs(w)*z",
      way = "attach",
      ports = {"flange"},
      strength = "tau_h",
      oneSided = true,
      reach(phi_h = 3),
      shape(phi_h = {"0.03*range(phi)", "0.1*range(phi)", "0.3*range(phi)"}))),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, pattern=LinePattern.Dash, radius=10),
        Text(extent={{-70,60},{70,-60}}, textString="?", textColor={213,94,0})}),
    Documentation(info="<html>
<p>A torque that does not come at once where the motion turns round, but over a travel, whatever the speed: the bristles of a seal, the hysteresis of a spring, of a magnet or of a belt (Dahl 1968).</p>
<pre>
  flange.tau = tau_h*z
  phi_h*der(z) = w - abs(w)*z
</pre>
</html>"));
end Hysteresis;
