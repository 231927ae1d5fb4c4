within Analogon.Effects.Translation;
model ReturnSpring "Spring from a rod to the housing"
  extends Analogon.Interfaces.PartialOneTranslationalFlange;
  parameter Real c_r(unit="N/m", min=0) = 0 "Stiffness (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real s_r(unit="m") = 0 "Position at which the spring is relaxed"
    annotation (Dialog(group="Effect"));
equation
  flange.f = c_r*(s - s_r);
  annotation (
    __Analogon(effect(
      kind = "spring.return",
      way = "attach",
      ports = {"flange"},
      strength = "c_r",
      oneSided = true,
      shape(s_r = {"start(s)", "mean(s)"}))),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=10),
        Line(points={{-100,0},{-90,0}}, color={0,127,0}, thickness=0.5),
        Line(points={{-90,0},{-60,0},{-50,30},{-30,-30},{-10,30},{10,-30},{30,30},{40,0},{60,0}}, color={95,95,95}, thickness=0.75),
        Line(points={{60,-50},{60,50}}, color={95,95,95}, thickness=0.75)}),
    Documentation(info="<html>
<p>A spring between rod and housing.</p>
<pre>
  flange.f = c_r*(flange.s - s_r)
</pre>
</html>"));
end ReturnSpring;
