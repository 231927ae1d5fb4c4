within Analogon.Effects.ElectricThermal;
model Combined "Heater with leads and the drop of a switch"
  extends Analogon.ElectricThermal.PartialElectricThermal;
  parameter Real R_s(unit="Ohm", min=0) = 0 "Resistance whose heat is lost elsewhere (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real V_b(unit="V", min=0) = 0 "Voltage drop (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real v_eps(unit="V", min=1e-12) = 0.01 "Voltage over which the onset is smoothed"
    annotation (Dialog(group="Numerics"));
equation
  (R_T + R_s)*i = v + (sqrt((v - V_b)^2 + v_eps^2) - sqrt((v + V_b)^2 + v_eps^2))/2;
  heatPort.Q_flow = -R_T*i^2;
  annotation (
    __Analogon(combines = {
      "Analogon.Effects.ElectricThermal.SeriesResistance",
      "Analogon.Effects.ElectricThermal.VoltageDrop"}),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{30,-50},{110,-100}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=8),
        Text(extent={{34,-56},{106,-94}}, textString="+ +", textColor={213,94,0}, textStyle={TextStyle.Bold})}),
    Documentation(info="<html>
<p>BasicElectricThermal behind a switch or contact with a constant drop and the resistance of leads, contacts or the supply; only the heat of R_T goes to the heat port.</p>
<pre>
  (R_T + R_s)*i = v - V_b*sign(v)   beyond V_b, else 0
  heatPort.Q_flow = -R_T*i^2
</pre>
<p>The corners are rounded over v_eps.</p>
</html>"));
end Combined;
