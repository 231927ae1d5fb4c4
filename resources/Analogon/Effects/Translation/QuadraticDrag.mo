within Analogon.Effects.Translation;
model QuadraticDrag "Force proportional to the square of the velocity"
  extends Analogon.Interfaces.PartialOneTranslationalFlange;
  parameter Real k_q(unit="N.s2/m2", min=0) = 0 "Force per square of the velocity (0: off)"
    annotation (Dialog(group="Effect"));
equation
  flange.f = k_q*v*noEvent(abs(v));
  annotation (
    __Analogon(effect(
      kind = "drag.quadratic",
      way = "attach",
      ports = {"flange"},
      strength = "k_q",
      oneSided = true)),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=10),
        Line(points={{-100,0},{-90,0}}, color={0,127,0}, thickness=0.5),
        Line(points={{-70,0},{80,0}}, color={128,128,128}),
        Line(points={{0,-70},{0,75}}, color={128,128,128}),
        Line(points={{-65,-68},{-50,-40},{-32,-16},{0,0},{32,16},{50,40},{65,68}}, color={95,95,95}, thickness=0.75, smooth=Smooth.Bezier)}),
    Documentation(info="<html>
<p>Drag of a body that moves in air or liquid, or throttling.</p>
<pre>
  flange.f = k_q*v*abs(v)
</pre>
</html>"));
end QuadraticDrag;
