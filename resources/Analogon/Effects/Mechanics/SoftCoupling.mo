within Analogon.Effects.Mechanics;
model SoftCoupling "Soft coupling between shafts that are not neighbours"
  extends Analogon.Interfaces.PartialTwoFlanges;
  parameter Real c(unit="N.m/rad", min=0) = 0 "Stiffness (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real d(unit="N.m.s/rad", min=0) = 0 "Damping"
    annotation (Dialog(group="Effect"));
  parameter Real phi_0(unit="rad") = 0 "Twist at which the coupling is relaxed"
    annotation (Dialog(group="Effect"));
  final parameter Real e(unit="rad/(N.m)") = if c > 0 then 1/c else 0 "Compliance 1/c (0 while there is no coupling)";
  Real phi_rel(unit="rad") "Twist: flange_b against flange_a";
  Real w_rel(unit="rad/s") "Rate of twist";
  Real tau(unit="N.m") "Torque in the coupling";
equation
  phi_rel = flange_b.phi - flange_a.phi;
  w_rel = der(phi_rel);
  tau = c*(phi_rel - phi_0) + d*w_rel;
  flange_b.tau = tau;
  flange_a.tau = -tau;
  annotation (
    __Analogon(effect(
      kind = "compliance.bridge",
      way = "bridge",
      ports = {"flange_a", "flange_b"},
      strength = "c",
      oneSided = true,
      linear = {"d"},
      fixed(phi_0 = "start(phi_rel)"))),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=10),
        Line(points={{-100,0},{-60,0}}, color={95,95,95}, thickness=0.5),
        Line(points={{60,0},{100,0}}, color={95,95,95}, thickness=0.5),
        Rectangle(extent={{-60,50},{-44,-50}}, lineColor={95,95,95}, fillColor={225,225,225}, fillPattern=FillPattern.Solid),
        Rectangle(extent={{44,50},{60,-50}}, lineColor={95,95,95}, fillColor={225,225,225}, fillPattern=FillPattern.Solid),
        Line(points={{-44,30},{-32,30},{-24,48},{-8,12},{8,48},{24,12},{32,30},{44,30}}, color={95,95,95}, thickness=0.75),
        Line(points={{-44,-30},{-10,-30}}, color={95,95,95}, thickness=0.5),
        Line(points={{16,-14},{-10,-14},{-10,-46},{16,-46}}, color={95,95,95}, thickness=0.5),
        Line(points={{4,-30},{44,-30}}, color={95,95,95}, thickness=0.5)}),
    Documentation(info="<html>
<p>A spring with a damper between two shafts that the model does not join: a belt, a hose, a common housing. The strength is the stiffness c, so that 0 leaves them apart; its inverse e is told beside it.</p>
<pre>
  phi_rel = flange_b.phi - flange_a.phi
  tau     = c*(phi_rel - phi_0) + d*der(phi_rel)
  flange_b.tau = tau,  flange_a.tau = -tau
</pre>
</html>"));
end SoftCoupling;
