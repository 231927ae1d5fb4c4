within Analogon.Effects.Electric;
model SeriesInductance "Inductance of a lead or a loop"
  extends Analogon.Interfaces.PartialTwoPins;
  parameter Real L_s(unit="H", min=0) = 0 "Inductance (0: none)"
    annotation (Dialog(group="Effect"));
  Real u(unit="V") "Potential of p against ground";
equation
  u = p.v;
  v = L_s*der(i);
  annotation (
    __Analogon(effect(
      kind = "inductance.series",
      way = "insert",
      ports = {"p", "n"},
      strength = "L_s",
      oneSided = true,
      states = 1,
      secant = {"2*sample*maxabs(u)/maxabs(i)", "20*sample*maxabs(u)/maxabs(i)", "200*sample*maxabs(u)/maxabs(i)"})),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=10),
        Line(points={{-100,0},{-50,0}}, color={0,0,255}, thickness=0.5),
        Line(points={{50,0},{100,0}}, color={0,0,255}, thickness=0.5),
        Line(points={{-50,0},{-42,24},{-25,24},{-17,0},{-9,24},{9,24},{17,0},{25,24},{42,24},{50,0}}, color={0,0,255}, thickness=0.5, smooth=Smooth.Bezier)}),
    Documentation(info="<html>
<p>A loop of wire that the current must build its field in.</p>
<pre>
  p.v - n.v = L_s*der(p.i)
</pre>
</html>"));
end SeriesInductance;
