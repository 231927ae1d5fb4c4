within Analogon.Effects.Translation;
model StribeckFriction "Dry friction of a rod with extra breakaway force that falls off with velocity"
  extends Analogon.Interfaces.PartialOneTranslationalFlange;
  parameter Real F_s(unit="N", min=0) = 0 "Extra force at breakaway (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real F_c(unit="N", min=0) = 0 "Friction force at speed"
    annotation (Dialog(group="Effect"));
  parameter Real v_s(unit="m/s", min=1e-12) = 0.1 "Velocity at which the extra force has fallen to 1/e"
    annotation (Dialog(group="Effect"));
  parameter Real v_eps(unit="m/s", min=1e-12) = 1e-4 "Velocity over which the jump at standstill is smoothed"
    annotation (Dialog(group="Numerics"));
equation
  flange.f = (F_c + F_s*exp(-(v/v_s)^2))*tanh(v/v_eps);
  annotation (
    __Analogon(effect(
      kind = "friction.stribeck",
      way = "attach",
      ports = {"flange"},
      strength = "F_s",
      oneSided = true,
      linear = {"F_c"},
      part(F_c = 0.25),
      fixed(v_eps = "0.002*rms(v)"),
      sharper(v_eps = 0.25),
      reach(v_s = 8),
      shape(v_s = {"0.03*maxabs(v)", "0.1*maxabs(v)", "0.3*maxabs(v)"}))),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=10),
        Line(points={{-100,0},{-90,0}}, color={0,127,0}, thickness=0.5),
        Line(points={{-70,0},{80,0}}, color={128,128,128}),
        Line(points={{0,-70},{0,75}}, color={128,128,128}),
        Line(points={{6,64},{14,50},{26,38},{44,30},{75,27}}, color={95,95,95}, thickness=0.75, smooth=Smooth.Bezier),
        Line(points={{-6,-64},{-14,-50},{-26,-38},{-44,-30},{-70,-27}}, color={95,95,95}, thickness=0.75, smooth=Smooth.Bezier),
        Line(points={{-6,-64},{6,64}}, color={95,95,95}, thickness=0.75)}),
    Documentation(info="<html>
<p>Dry friction that is higher at breakaway than at speed.</p>
<pre>
  flange.f = (F_c + F_s*exp(-(v/v_s)^2))*sign(v)
</pre>
<p>The jump at standstill is smoothed over the small velocity v_eps, so that the force has a slope everywhere: a stuck rod creeps at a fraction of v_eps.</p>
</html>"));
end StribeckFriction;
