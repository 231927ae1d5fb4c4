within Analogon.Effects.Translation;
model ConstantForce "Constant load force"
  extends Analogon.Interfaces.PartialOneTranslationalFlange;
  parameter Real F_0(unit="N") = 0 "Force on the rod, positive against positive motion (0: off)"
    annotation (Dialog(group="Effect"));
equation
  flange.f = F_0;
  annotation (
    __Analogon(effect(
      kind = "force.constant",
      way = "attach",
      ports = {"flange"},
      strength = "F_0")),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=10),
        Line(points={{-100,0},{-90,0}}, color={0,127,0}, thickness=0.5),
        Line(points={{-70,0},{80,0}}, color={128,128,128}),
        Line(points={{0,-70},{0,75}}, color={128,128,128}),
        Line(points={{-70,35},{75,35}}, color={95,95,95}, thickness=0.75)}),
    Documentation(info="<html>
<p>A weight, a preload: the same force at every position and velocity.</p>
<pre>
  flange.f = F_0
</pre>
</html>"));
end ConstantForce;
