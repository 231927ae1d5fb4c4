within Analogon.Effects.Mechanics;
model ViscousFriction "Torque proportional to the speed"
  extends Analogon.Interfaces.PartialOneFlange;
  parameter Real b(unit="N.m.s/rad", min=0) = 0 "Torque per speed (0: off)"
    annotation (Dialog(group="Effect"));
equation
  flange.tau = b*w;
  annotation (
    __Analogon(effect(
      kind = "friction.viscous",
      way = "attach",
      ports = {"flange"},
      strength = "b",
      oneSided = true)),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=10),
        Line(points={{-100,0},{-90,0}}, color={95,95,95}, thickness=0.5),
        Line(points={{-70,0},{80,0}}, color={128,128,128}),
        Line(points={{0,-70},{0,75}}, color={128,128,128}),
        Line(points={{-65,-60},{65,60}}, color={95,95,95}, thickness=0.75)}),
    Documentation(info="<html>
<p>Friction of a film of oil or grease.</p>
<pre>
  flange.tau = b*w
</pre>
</html>"));
end ViscousFriction;
