within Analogon.Effects.Proposals;
model CubicDrag "Torque that grows with the third power of speed"
  extends Analogon.Interfaces.PartialOneFlange;
  parameter Real a(unit="N.m.s3/rad3", min=0) = 0 "Coefficient (0: off)"
    annotation (Dialog(group="Effect"));
equation
  flange.tau = a*w^3;
  annotation (
    __Analogon(effect(
      kind = "proposal.drag.cubic",
      proposal = "flange.tau = a*w^3",
      way = "attach",
      ports = {"flange"},
      strength = "a",
      oneSided = true)),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, pattern=LinePattern.Dash, radius=10),
        Text(extent={{-70,60},{70,-60}}, textString="?", textColor={213,94,0})}),
    Documentation(info="<html>
<p>A drag that grows faster than the square of the speed.</p>
<pre>
  flange.tau = a*w^3
</pre>
</html>"));
end CubicDrag;
