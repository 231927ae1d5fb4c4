within Analogon.Effects.Electric;
model VoltageDrop "Voltage drop of a diode or of brushes in a wire"
  extends Analogon.Interfaces.PartialTwoPins;
  parameter Real V_b(unit="V", min=0) = 0 "Voltage drop (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real i_eps(unit="A", min=1e-12) = 0.01 "Current over which the change of sign is smoothed"
    annotation (Dialog(group="Numerics"));
equation
  v = V_b*tanh(i/i_eps);
  annotation (
    __Analogon(effect(
      kind = "voltage.drop",
      way = "insert",
      ports = {"p", "n"},
      strength = "V_b",
      oneSided = true,
      fixed(i_eps = "0.004*rms(i)"),
      sharper(i_eps = 0.25))),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=10),
        Line(points={{-70,0},{80,0}}, color={128,128,128}),
        Line(points={{0,-70},{0,75}}, color={128,128,128}),
        Line(points={{-70,-40},{-6,-40},{6,40},{75,40}}, color={95,95,95}, thickness=0.75)}),
    Documentation(info="<html>
<p>A constant drop against the current. While the voltage cannot overcome it the current stays at 0.</p>
<pre>
  p.v - n.v = V_b*sign(p.i)
</pre>
<p>The change of sign is smoothed over the small current i_eps.</p>
</html>"));
end VoltageDrop;
