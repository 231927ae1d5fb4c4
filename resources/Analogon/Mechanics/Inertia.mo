within Analogon.Mechanics;
model Inertia "Rigid body on a shaft"
  extends Analogon.Interfaces.PartialTwoFlanges;
  parameter Real J(unit="kg.m2", min=0) = 1e-4 "Moment of inertia"
    annotation (Dialog(group="Parameters"));
  Real phi(unit="rad") "Angle";
  Real w(unit="rad/s") "Speed";
  Real a(unit="rad/s2") "Acceleration";
equation
  phi = flange_a.phi;
  phi = flange_b.phi;
  w = der(phi);
  a = der(w);
  J*a = flange_a.tau + flange_b.tau;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-100,8},{-60,-8}}, lineColor={95,95,95}, fillColor={192,198,206}, fillPattern=FillPattern.Solid),
        Rectangle(extent={{60,8},{100,-8}}, lineColor={95,95,95}, fillColor={192,198,206}, fillPattern=FillPattern.Solid),
        Rectangle(extent={{-60,60},{60,-60}}, lineColor={95,95,95}, fillColor={192,198,206}, fillPattern=FillPattern.Solid, radius=8),
        Text(extent={{-100,-64},{100,-96}}, textString="J = %J", textColor={0,0,0})}),
    Documentation(info="<html>
<p>An inertia on a rigid shaft; both flanges are the same place.</p>
<pre>
  phi = flange_a.phi = flange_b.phi
  w = der(phi),  a = der(w)
  J*a = flange_a.tau + flange_b.tau
</pre>
</html>"));
end Inertia;
