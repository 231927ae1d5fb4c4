within Analogon.Effects.ElectricMechanical;
model SeriesResistance "Lead or contact resistance in series with the winding"
  extends Analogon.ElectricMechanical.PartialElectricMechanical;
  parameter Real R_s(unit="Ohm", min=0) = 0 "Resistance outside the winding (0: off)"
    annotation (Dialog(group="Effect"));
equation
  v = (R + R_s)*i + L*der(i) + k*w;
  flange.tau = -k*i;
  annotation (
    __Analogon(effect(
      kind = "resistance.series",
      way = "specialise",
      strength = "R_s",
      oneSided = true)),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Text(extent={{-50,40},{50,-40}}, textString="M", textColor={0,0,0}, textStyle={TextStyle.Bold}),
        Rectangle(extent={{30,-50},{110,-100}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=8),
        Text(extent={{34,-56},{106,-94}}, textString="R_s", textColor={213,94,0}, textStyle={TextStyle.Bold})}),
    Documentation(info="<html>
<p>BasicElectricMechanical with the resistance of leads, contacts or the supply in series.</p>
<pre>
  v = (R + R_s)*i + L*der(i) + k*der(flange.phi)
  flange.tau = -k*i
</pre>
</html>"));
end SeriesResistance;
