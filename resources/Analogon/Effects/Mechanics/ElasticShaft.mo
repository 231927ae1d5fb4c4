within Analogon.Effects.Mechanics;
model ElasticShaft "Shaft that twists"
  extends Analogon.Interfaces.PartialTwoFlanges;
  parameter Real e(unit="rad/(N.m)", min=0) = 0 "Compliance 1/c (0: rigid)"
    annotation (Dialog(group="Effect"));
  parameter Real d(unit="N.m.s/rad", min=0) = 0 "Damping"
    annotation (Dialog(group="Effect"));
  final parameter Real c(unit="N.m/rad") = if e > 0 then 1/e else 0 "Stiffness 1/e (0 while the shaft is rigid)";
  Real phi_rel(unit="rad") "Twist: flange_b against flange_a";
  Real w_rel(unit="rad/s") "Rate of twist";
  Real tau(unit="N.m") "Torque in the shaft";
  Real w(unit="rad/s") "Speed of flange_a";
initial equation
  w_rel = 0;
equation
  phi_rel = flange_b.phi - flange_a.phi;
  w_rel = der(phi_rel);
  w = der(flange_a.phi);
  e*(tau - d*w_rel) = phi_rel;
  flange_b.tau = tau;
  flange_a.tau = -tau;
  annotation (
    __Analogon(effect(
      kind = "compliance.shaft",
      way = "insert",
      ports = {"flange_a", "flange_b"},
      strength = "e",
      oneSided = true,
      states = 2,
      shape(d = {"0.2*sqrt(maxabs(tau)/rate(w)/e)", "sqrt(maxabs(tau)/rate(w)/e)"}),
      secant = {"(6*sample)^2*rate(w)/maxabs(tau)", "(24*sample)^2*rate(w)/maxabs(tau)", "(96*sample)^2*rate(w)/maxabs(tau)", "0.1/maxabs(tau)"})),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=10),
        Line(points={{-100,0},{-50,0},{-40,30},{-20,-30},{0,30},{20,-30},{40,30},{50,0},{100,0}}, color={95,95,95}, thickness=0.75)}),
    Documentation(info="<html>
<p>An elastic, damped shaft where the model had a rigid one. The strength is the compliance e = 1/c, so that 0 is the rigid shaft.</p>
<pre>
  phi_rel = flange_b.phi - flange_a.phi
  tau     = phi_rel/e + d*der(phi_rel)
  flange_b.tau = tau,  flange_a.tau = -tau
</pre>
</html>"));
end ElasticShaft;
