within Analogon.Effects.Electric;
model LeakageBetween "Leakage between two wires that no component joins"
  extends Analogon.Interfaces.PartialTwoPins;
  parameter Real G_p(unit="S", min=0) = 0 "Conductance 1/R_p between the wires (0: off)"
    annotation (Dialog(group="Effect"));
  final parameter Real R_p(unit="Ohm") = if G_p > 0 then 1/G_p else 0 "Resistance 1/G_p (0 while there is no leakage)";
equation
  i = G_p*v;
  annotation (
    __Analogon(effect(
      kind = "leakage",
      way = "bridge",
      ports = {"p", "n"},
      strength = "G_p",
      oneSided = true)),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=10),
        Line(points={{-100,0},{-50,0}}, color={0,0,255}, thickness=0.5),
        Line(points={{50,0},{100,0}}, color={0,0,255}, thickness=0.5),
        Rectangle(extent={{-50,20},{50,-20}}, lineColor={0,0,255}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, pattern=LinePattern.Dash)}),
    Documentation(info="<html>
<p>Isolation between two wires that is not perfect.</p>
<pre>
  p.i = G_p*(p.v - n.v)
</pre>
</html>"));
end LeakageBetween;
