within Analogon.Effects.Proposals;
model HardeningSpring "Spring that stiffens with its travel"
  extends Analogon.Interfaces.PartialOneFlange;
  parameter Real a(unit="N.m/rad3", min=0) = 0 "Coefficient (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real phi_0(unit="rad") = 0 "Angle at rest"
    annotation (Dialog(group="Effect"));
equation
  flange.tau = a*(phi - phi_0)^3;
  annotation (
    __Analogon(effect(
      kind = "proposal.spring.hardening",
      proposal = "flange.tau = a*(phi - phi_0)^3",
      way = "attach",
      ports = {"flange"},
      strength = "a",
      oneSided = true,
      fixed(phi_0 = "start(phi)"),
      valid = "6.283185 - range(phi)")),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, pattern=LinePattern.Dash, radius=10),
        Text(extent={{-70,60},{70,-60}}, textString="?", textColor={213,94,0})}),
    Documentation(info="<html>
<p>A spring, a bush or a seal that grows stiffer the further it is moved from where the recording begins.</p>
<pre>
  flange.tau = a*(phi - phi_0)^3
</pre>
</html>"));
end HardeningSpring;
