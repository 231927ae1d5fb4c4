within Analogon.Effects.Proposals;
model TorqueOfAngle "Torque of any course that repeats with every turn"
  extends Analogon.Interfaces.PartialOneFlange;
  parameter Real a_1(unit="N.m") = 0 "Once per turn, with the sine of the angle (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real b_1(unit="N.m") = 0 "Once per turn, with the cosine"
    annotation (Dialog(group="Effect"));
  parameter Real a_2(unit="N.m") = 0 "Twice per turn, with the sine"
    annotation (Dialog(group="Effect"));
  parameter Real b_2(unit="N.m") = 0 "Twice per turn, with the cosine"
    annotation (Dialog(group="Effect"));
  parameter Real a_3(unit="N.m") = 0 "Three times per turn, with the sine"
    annotation (Dialog(group="Effect"));
  parameter Real b_3(unit="N.m") = 0 "Three times per turn, with the cosine"
    annotation (Dialog(group="Effect"));
equation
  flange.tau = a_1*sin(phi) + b_1*cos(phi) + a_2*sin(2*phi) + b_2*cos(2*phi) + a_3*sin(3*phi) + b_3*cos(3*phi);
  annotation (
    __Analogon(effect(
      kind = "proposal.torque.angle",
      proposal = "flange.tau = a_1*sin(phi) + b_1*cos(phi) + a_2*sin(2*phi) + b_2*cos(2*phi) + a_3*sin(3*phi) + b_3*cos(3*phi)",
      way = "attach",
      ports = {"flange"},
      strength = "a_1",
      linear = {"b_1", "a_2", "b_2", "a_3", "b_3"},
      along = "phi",
      valid = "range(phi) - 6.283185")),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, pattern=LinePattern.Dash, radius=10),
        Text(extent={{-70,60},{70,-60}}, textString="?", textColor={213,94,0})}),
    Documentation(info="<html>
<p>A cam, an eccentric gear or an uneven pull of the poles: the torque depends on the angle, and a single wave does not
describe it.</p>
<pre>
  flange.tau = a_1*sin(phi) + b_1*cos(phi)
             + a_2*sin(2*phi) + b_2*cos(2*phi)
             + a_3*sin(3*phi) + b_3*cos(3*phi)
</pre>
</html>"));
end TorqueOfAngle;
