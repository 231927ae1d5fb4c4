within Analogon.Effects.Electric;
model SeriesResistance "Resistance of a lead or a contact"
  extends Analogon.Interfaces.PartialTwoPins;
  parameter Real R_s(unit="Ohm", min=0) = 0 "Resistance (0: none)"
    annotation (Dialog(group="Effect"));
  Real u(unit="V") "Potential of p against ground";
equation
  u = p.v;
  v = R_s*i;
  annotation (
    __Analogon(effect(
      kind = "resistance.series",
      way = "insert",
      ports = {"p", "n"},
      strength = "R_s",
      oneSided = true,
      secant = {"0.03*range(u)/maxabs(i)", "0.2*range(u)/maxabs(i)"})),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=10),
        Line(points={{-100,0},{-50,0}}, color={0,0,255}, thickness=0.5),
        Line(points={{50,0},{100,0}}, color={0,0,255}, thickness=0.5),
        Rectangle(extent={{-50,20},{50,-20}}, lineColor={0,0,255}, fillColor={255,255,255}, fillPattern=FillPattern.Solid)}),
    Documentation(info="<html>
<p>Lead, contact or inner resistance of the supply, where the model had an ideal wire. Its heat is lost.</p>
<pre>
  p.v - n.v = R_s*p.i
</pre>
</html>"));
end SeriesResistance;
