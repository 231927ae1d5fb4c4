within Analogon.Effects.Translation;
model CoulombFriction "Dry friction of a rod"
  extends Analogon.Interfaces.PartialOneTranslationalFlange;
  parameter Real F_c(unit="N", min=0) = 0 "Friction force (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real v_eps(unit="m/s", min=1e-12) = 1e-4 "Velocity over which the jump at standstill is smoothed"
    annotation (Dialog(group="Numerics"));
equation
  flange.f = F_c*tanh(v/v_eps);
  annotation (
    __Analogon(effect(
      kind = "friction.coulomb",
      way = "attach",
      ports = {"flange"},
      strength = "F_c",
      oneSided = true,
      fixed(v_eps = "0.002*rms(v)"),
      sharper(v_eps = 0.25))),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=10),
        Line(points={{-100,0},{-90,0}}, color={0,127,0}, thickness=0.5),
        Line(points={{-70,0},{80,0}}, color={128,128,128}),
        Line(points={{0,-70},{0,75}}, color={128,128,128}),
        Line(points={{-70,-40},{-6,-40},{6,40},{75,40}}, color={95,95,95}, thickness=0.75)}),
    Documentation(info="<html>
<p>A constant force against the motion.</p>
<pre>
  flange.f = F_c*sign(v)
</pre>
<p>The jump at standstill is smoothed over the small velocity v_eps, so that the force has a slope everywhere: a stuck rod creeps at a fraction of v_eps.</p>
</html>"));
end CoulombFriction;
