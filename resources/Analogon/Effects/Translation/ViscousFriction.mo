within Analogon.Effects.Translation;
model ViscousFriction "Force proportional to the velocity"
  extends Analogon.Interfaces.PartialOneTranslationalFlange;
  parameter Real b(unit="N.s/m", min=0) = 0 "Force per velocity (0: off)"
    annotation (Dialog(group="Effect"));
equation
  flange.f = b*v;
  annotation (
    __Analogon(effect(
      kind = "friction.viscous",
      way = "attach",
      ports = {"flange"},
      strength = "b",
      oneSided = true)),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=10),
        Line(points={{-100,0},{-90,0}}, color={0,127,0}, thickness=0.5),
        Line(points={{-70,0},{80,0}}, color={128,128,128}),
        Line(points={{0,-70},{0,75}}, color={128,128,128}),
        Line(points={{-65,-60},{65,60}}, color={95,95,95}, thickness=0.75)}),
    Documentation(info="<html>
<p>Friction of a film of oil or grease.</p>
<pre>
  flange.f = b*v
</pre>
</html>"));
end ViscousFriction;
