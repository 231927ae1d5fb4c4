within Analogon.Effects.Mechanics;
model ReturnSpring "Spring to the housing"
  extends Analogon.Interfaces.PartialOneFlange;
  parameter Real c_r(unit="N.m/rad", min=0) = 0 "Stiffness (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real phi_r(unit="rad") = 0 "Angle at which the spring is relaxed"
    annotation (Dialog(group="Effect"));
equation
  flange.tau = c_r*(phi - phi_r);
  annotation (
    __Analogon(effect(
      kind = "spring.return",
      way = "attach",
      ports = {"flange"},
      strength = "c_r",
      oneSided = true,
      shape(phi_r = {"start(phi)", "mean(phi)"}))),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=10),
        Line(points={{-100,0},{-90,0}}, color={95,95,95}, thickness=0.5),
        Line(points={{-90,0},{-60,0},{-50,30},{-30,-30},{-10,30},{10,-30},{30,30},{40,0},{60,0}}, color={95,95,95}, thickness=0.5),
        Line(points={{60,-50},{60,50}}, color={95,95,95}, thickness=0.75)}),
    Documentation(info="<html>
<p>A spring between shaft and housing.</p>
<pre>
  flange.tau = c_r*(flange.phi - phi_r)
</pre>
</html>"));
end ReturnSpring;
