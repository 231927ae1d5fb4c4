within Analogon.Mechanics;
model BasicMechanics "Two inertias joined by a gear and an elastic, damped shaft"
  extends PartialMechanics;
  parameter Real c(unit="N.m/rad", min=0) = 1e3 "Stiffness of the shaft, on the side of flange_b"
    annotation (Dialog(group="Parameters"));
  parameter Real d(unit="N.m.s/rad", min=0) = 1 "Damping of the shaft, on the side of flange_b"
    annotation (Dialog(group="Parameters"));
equation
  tau_s = c*(phi1/r - phi2) + d*(w1/r - w2);
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-62,60},{-34,-60}}, lineColor={95,95,95}, fillColor={192,198,206}, fillPattern=FillPattern.Solid),
        Rectangle(extent={{34,40},{62,-40}}, lineColor={95,95,95}, fillColor={192,198,206}, fillPattern=FillPattern.Solid),
        Line(points={{-34,0},{-26,0},{-20,20},{-10,-20},{0,20},{10,-20},{20,20},{26,0},{34,0}}, color={95,95,95}, thickness=0.5),
        Text(extent={{-100,-64},{100,-96}}, textString="r = %r", textColor={0,0,0})}),
    Documentation(info="<html>
<p>The basic class of rotational mechanics: an inertia J1 at flange_a, a gear of ratio r, an elastic shaft with stiffness c and damping d, an inertia J2 at flange_b. All starts at rest at angle 0.</p>
<pre>
  phi1 = flange_a.phi,  w1 = der(phi1)
  phi2 = flange_b.phi,  w2 = der(phi2)
  r*J1*der(w1) = r*flange_a.tau - tau_s
  J2*der(w2)   = tau_s + flange_b.tau
  tau_s = c*(phi1/r - phi2) + d*(w1/r - w2)
</pre>
<p>Stiffness and damping refer to the slow side (flange_b). J1 = 0 or J2 = 0 is legal: the inertia then belongs to what is connected there.</p>
</html>"));
end BasicMechanics;
