within Analogon.Effects.Electric;
model Leakage "Leakage from a wire to ground"
  extends Analogon.Interfaces.PartialOnePin;
  parameter Real G_p(unit="S", min=0) = 0 "Conductance 1/R_p to ground (0: off)"
    annotation (Dialog(group="Effect"));
  final parameter Real R_p(unit="Ohm") = if G_p > 0 then 1/G_p else 0 "Resistance 1/G_p (0 while there is no leakage)";
equation
  pin.i = G_p*v;
  annotation (
    __Analogon(effect(
      kind = "leakage",
      way = "attach",
      ports = {"pin"},
      strength = "G_p",
      oneSided = true)),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=10),
        Line(points={{-100,0},{-40,0},{-40,-20}}, color={0,0,255}, thickness=0.5),
        Line(points={{-70,-70},{-10,-70}}, color={0,0,255}, thickness=0.5),
        Line(points={{-55,-80},{-25,-80}}, color={0,0,255}, thickness=0.5),
        Rectangle(extent={{-52,-16},{-28,-60}}, lineColor={0,0,255}, fillColor={255,255,255}, fillPattern=FillPattern.Solid),
        Line(points={{-40,-60},{-40,-70}}, color={0,0,255}, thickness=0.5)}),
    Documentation(info="<html>
<p>Isolation that is not perfect, a bleeder, a filter: current that flows to ground beside the load.</p>
<pre>
  pin.i = G_p*pin.v
</pre>
</html>"));
end Leakage;
