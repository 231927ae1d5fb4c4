within Analogon.Effects.ElectricThermal;
model SeriesResistance "Lead or contact resistance whose heat is lost elsewhere"
  extends Analogon.ElectricThermal.PartialElectricThermal;
  parameter Real R_s(unit="Ohm", min=0) = 0 "Resistance whose heat is lost elsewhere (0: off)"
    annotation (Dialog(group="Effect"));
equation
  v = (R_T + R_s)*i;
  heatPort.Q_flow = -R_T*i^2;
  annotation (
    __Analogon(effect(
      kind = "resistance.series",
      way = "specialise",
      strength = "R_s",
      oneSided = true)),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{30,-50},{110,-100}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=8),
        Text(extent={{34,-56},{106,-94}}, textString="R_s", textColor={213,94,0}, textStyle={TextStyle.Bold})}),
    Documentation(info="<html>
<p>BasicElectricThermal with the resistance of leads, contacts or the supply in series; only the heat of R_T goes to the heat port.</p>
<pre>
  v = (R_T + R_s)*i
  heatPort.Q_flow = -R_T*i^2
</pre>
</html>"));
end SeriesResistance;
