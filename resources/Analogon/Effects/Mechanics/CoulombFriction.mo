within Analogon.Effects.Mechanics;
model CoulombFriction "Dry friction"
  extends Analogon.Interfaces.PartialOneFlange;
  parameter Real tau_c(unit="N.m", min=0) = 0 "Friction torque (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real w_eps(unit="rad/s", min=1e-12) = 0.01 "Speed over which the jump at standstill is smoothed"
    annotation (Dialog(group="Numerics"));
equation
  flange.tau = tau_c*tanh(w/w_eps);
  annotation (
    __Analogon(effect(
      kind = "friction.coulomb",
      way = "attach",
      ports = {"flange"},
      strength = "tau_c",
      oneSided = true,
      fixed(w_eps = "0.002*rms(w)"),
      sharper(w_eps = 0.25))),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=10),
        Line(points={{-100,0},{-90,0}}, color={95,95,95}, thickness=0.5),
        Line(points={{-70,0},{80,0}}, color={128,128,128}),
        Line(points={{0,-70},{0,75}}, color={128,128,128}),
        Line(points={{-70,-40},{-6,-40},{6,40},{75,40}}, color={95,95,95}, thickness=0.75)}),
    Documentation(info="<html>
<p>A constant torque against the motion.</p>
<pre>
  flange.tau = tau_c*sign(w)
</pre>
<p>The jump at standstill is smoothed over the small speed w_eps, so that the torque has a slope everywhere: a stuck shaft creeps at a fraction of w_eps.</p>
</html>"));
end CoulombFriction;
