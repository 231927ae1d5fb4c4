within Analogon.Effects.Mechanics;
model ConstantTorque "Constant load torque"
  extends Analogon.Interfaces.PartialOneFlange;
  parameter Real tau_0(unit="N.m") = 0 "Torque on the shaft, positive against positive motion (0: off)"
    annotation (Dialog(group="Effect"));
equation
  flange.tau = tau_0;
  annotation (
    __Analogon(effect(
      kind = "torque.constant",
      way = "attach",
      ports = {"flange"},
      strength = "tau_0")),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=10),
        Line(points={{-100,0},{-90,0}}, color={95,95,95}, thickness=0.5),
        Line(points={{-70,0},{80,0}}, color={128,128,128}),
        Line(points={{0,-70},{0,75}}, color={128,128,128}),
        Line(points={{-70,35},{75,35}}, color={95,95,95}, thickness=0.75)}),
    Documentation(info="<html>
<p>A weight on a drum, a preload: the same torque at every angle and speed.</p>
<pre>
  flange.tau = tau_0
</pre>
</html>"));
end ConstantTorque;
