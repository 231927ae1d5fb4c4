within Analogon.Mechanics;
partial model PartialMechanics "Geared shaft with two inertias, without its stiffness"
  extends Analogon.Interfaces.PartialTwoFlanges;
  parameter Real r(unit="1", min=1e-6) = 1 "Gear ratio: turns of flange_a per turn of flange_b"
    annotation (Dialog(group="Parameters"));
  parameter Real J1(unit="kg.m2", min=0) = 1e-4 "Inertia at flange_a"
    annotation (Dialog(group="Parameters"));
  parameter Real J2(unit="kg.m2", min=0) = 1e-4 "Inertia at flange_b"
    annotation (Dialog(group="Parameters"));
  Real phi1(unit="rad") "Angle of the first inertia";
  Real w1(unit="rad/s") "Speed of the first inertia";
  Real phi2(unit="rad") "Angle of the second inertia";
  Real w2(unit="rad/s") "Speed of the second inertia";
  Real tau_s(unit="N.m") "Torque in the shaft, on the side of flange_b";
equation
  phi1 = flange_a.phi;
  phi2 = flange_b.phi;
  w1 = der(phi1);
  w2 = der(phi2);
  r*J1*der(w1) = r*flange_a.tau - tau_s;
  J2*der(w2) = tau_s + flange_b.tau;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-100,8},{-60,-8}}, lineColor={95,95,95}, fillColor={192,198,206}, fillPattern=FillPattern.Solid),
        Rectangle(extent={{60,8},{100,-8}}, lineColor={95,95,95}, fillColor={192,198,206}, fillPattern=FillPattern.Solid)}),
    Documentation(info="<html>
<p>Base of the geared shafts. A class that extends it says how the torque tau_s comes about.</p>
<pre>
  r*J1*der(w1) = r*flange_a.tau - tau_s
  J2*der(w2)   = tau_s + flange_b.tau
</pre>
</html>"));
end PartialMechanics;
