within Analogon.Effects.Mechanics;
model StribeckFriction "Dry friction with extra breakaway torque that falls off with speed"
  extends Analogon.Interfaces.PartialOneFlange;
  parameter Real tau_s(unit="N.m", min=0) = 0 "Extra torque at breakaway (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real tau_c(unit="N.m", min=0) = 0 "Friction torque at speed"
    annotation (Dialog(group="Effect"));
  parameter Real w_s(unit="rad/s", min=1e-9) = 1 "Speed at which the extra torque has fallen to 1/e"
    annotation (Dialog(group="Effect"));
  parameter Real w_eps(unit="rad/s", min=1e-12) = 0.01 "Speed over which the jump at standstill is smoothed"
    annotation (Dialog(group="Numerics"));
equation
  flange.tau = (tau_c + tau_s*exp(-(w/w_s)^2))*tanh(w/w_eps);
  annotation (
    __Analogon(effect(
      kind = "friction.stribeck",
      way = "attach",
      ports = {"flange"},
      strength = "tau_s",
      oneSided = true,
      linear = {"tau_c"},
      part(tau_c = 0.25),
      fixed(w_eps = "0.002*rms(w)"),
      sharper(w_eps = 0.25),
      reach(w_s = 8),
      shape(w_s = {"0.03*maxabs(w)", "0.1*maxabs(w)", "0.3*maxabs(w)"}))),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=10),
        Line(points={{-100,0},{-90,0}}, color={95,95,95}, thickness=0.5),
        Line(points={{-70,0},{80,0}}, color={128,128,128}),
        Line(points={{0,-70},{0,75}}, color={128,128,128}),
        Line(points={{6,64},{14,50},{26,38},{44,30},{75,27}}, color={95,95,95}, thickness=0.75, smooth=Smooth.Bezier),
        Line(points={{-6,-64},{-14,-50},{-26,-38},{-44,-30},{-70,-27}}, color={95,95,95}, thickness=0.75, smooth=Smooth.Bezier),
        Line(points={{-6,-64},{6,64}}, color={95,95,95}, thickness=0.75)}),
    Documentation(info="<html>
<p>Dry friction that is higher at breakaway than at speed.</p>
<pre>
  flange.tau = (tau_c + tau_s*exp(-(w/w_s)^2))*sign(w)
</pre>
<p>The jump at standstill is smoothed over the small speed w_eps, so that the torque has a slope everywhere: a stuck shaft creeps at a fraction of w_eps.</p>
</html>"));
end StribeckFriction;
