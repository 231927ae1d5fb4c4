within Analogon.Effects.Mechanics;
model GravityTorque "Torque of an unbalanced mass: once per turn"
  extends Analogon.Interfaces.PartialOneFlange;
  parameter Real tau_g(unit="N.m") = 0 "Largest torque (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real phi_0(unit="rad") = 0 "Angle at which the mass hangs at its lowest point"
    annotation (Dialog(group="Effect"));
equation
  flange.tau = tau_g*sin(phi - phi_0);
  annotation (
    __Analogon(effect(
      kind = "torque.gravity",
      way = "attach",
      ports = {"flange"},
      strength = "tau_g",
      phase = "phi_0",
      along = "phi")),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=10),
        Line(points={{-100,0},{-90,0}}, color={95,95,95}, thickness=0.5),
        Ellipse(extent={{-50,50},{50,-50}}, lineColor={95,95,95}, fillColor={240,240,240}, fillPattern=FillPattern.Solid),
        Ellipse(extent={{-6,6},{6,-6}}, lineColor={95,95,95}, fillColor={95,95,95}, fillPattern=FillPattern.Solid),
        Line(points={{0,0},{28,-28}}, color={95,95,95}, thickness=0.75),
        Ellipse(extent={{18,-18},{46,-46}}, lineColor={95,95,95}, fillColor={95,95,95}, fillPattern=FillPattern.Solid),
        Line(points={{66,10},{66,-40}}, color={213,94,0}, thickness=0.75, arrow={Arrow.None,Arrow.Filled})}),
    Documentation(info="<html>
<p>The weight of an arm, a flap or an eccentric on a horizontal shaft.</p>
<pre>
  flange.tau = tau_g*sin(phi - phi_0)
</pre>
</html>"));
end GravityTorque;
