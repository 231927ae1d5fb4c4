within Analogon.Effects.Electric;
model ParallelCapacitance "Stray or filter capacitance from a wire to ground"
  extends Analogon.Interfaces.PartialOnePin;
  parameter Real C_p(unit="F", min=0) = 0 "Capacitance (0: off)"
    annotation (Dialog(group="Effect"));
equation
  pin.i = C_p*der(v);
  annotation (
    __Analogon(effect(
      kind = "capacitance.parallel",
      way = "attach",
      ports = {"pin"},
      strength = "C_p",
      oneSided = true)),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=10),
        Line(points={{-100,0},{-40,0},{-40,-20}}, color={0,0,255}, thickness=0.5),
        Line(points={{-70,-70},{-10,-70}}, color={0,0,255}, thickness=0.5),
        Line(points={{-55,-80},{-25,-80}}, color={0,0,255}, thickness=0.5),
        Line(points={{-60,-34},{-20,-34}}, color={0,0,255}, thickness=0.75),
        Line(points={{-60,-48},{-20,-48}}, color={0,0,255}, thickness=0.75),
        Line(points={{-40,-20},{-40,-34}}, color={0,0,255}, thickness=0.5),
        Line(points={{-40,-48},{-40,-70}}, color={0,0,255}, thickness=0.5)}),
    Documentation(info="<html>
<p>A long cable, a filter: charge that the wire must take up before its potential rises.</p>
<pre>
  pin.i = C_p*der(pin.v)
</pre>
</html>"));
end ParallelCapacitance;
