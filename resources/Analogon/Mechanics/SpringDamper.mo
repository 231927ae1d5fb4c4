within Analogon.Mechanics;
model SpringDamper "Linear spring and damper in parallel between two flanges"
  extends Analogon.Interfaces.PartialTwoFlanges;
  parameter Real c(unit="N.m/rad", min=0) = 1e3 "Stiffness"
    annotation (Dialog(group="Parameters"));
  parameter Real d(unit="N.m.s/rad", min=0) = 1 "Damping"
    annotation (Dialog(group="Parameters"));
  Real phi_rel(unit="rad") "Twist: flange_b against flange_a";
  Real w_rel(unit="rad/s") "Rate of twist";
  Real tau(unit="N.m") "Torque of spring and damper";
equation
  phi_rel = flange_b.phi - flange_a.phi;
  w_rel = der(phi_rel);
  tau = c*phi_rel + d*w_rel;
  flange_b.tau = tau;
  flange_a.tau = -tau;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-100,0},{-60,0},{-60,40},{-40,40},{-30,60},{-15,20},{0,60},{15,20},{30,60},{40,40},{60,40},{60,0},{100,0}}, color={95,95,95}, thickness=0.5),
        Line(points={{-60,0},{-60,-40},{0,-40}}, color={95,95,95}, thickness=0.5),
        Line(points={{60,0},{60,-40},{20,-40}}, color={95,95,95}, thickness=0.5),
        Line(points={{40,-65},{-10,-65},{-10,-15},{40,-15}}, color={95,95,95}, thickness=0.5),
        Rectangle(extent={{0,-20},{20,-60}}, lineColor={95,95,95}, fillColor={192,198,206}, fillPattern=FillPattern.Solid)}),
    Documentation(info="<html>
<p>A massless elastic and damped shaft.</p>
<pre>
  phi_rel = flange_b.phi - flange_a.phi
  flange_b.tau = c*phi_rel + d*der(phi_rel)
  flange_a.tau = -flange_b.tau
</pre>
</html>"));
end SpringDamper;
