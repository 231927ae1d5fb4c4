within Analogon.Effects.ElectricThermal;
model VoltageDrop "Voltage drop of a switch or contact"
  extends Analogon.ElectricThermal.PartialElectricThermal;
  parameter Real V_b(unit="V", min=0) = 0 "Voltage drop (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real v_eps(unit="V", min=1e-12) = 0.01 "Voltage over which the onset is smoothed"
    annotation (Dialog(group="Numerics"));
equation
  R_T*i = v + (sqrt((v - V_b)^2 + v_eps^2) - sqrt((v + V_b)^2 + v_eps^2))/2;
  heatPort.Q_flow = -R_T*i^2;
  annotation (
    __Analogon(effect(
      kind = "voltage.drop",
      way = "specialise",
      strength = "V_b",
      oneSided = true,
      fixed(v_eps = "0.004*rms(v)"),
      sharper(v_eps = 0.25))),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{30,-50},{110,-100}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=8),
        Text(extent={{34,-56},{106,-94}}, textString="V_b", textColor={213,94,0}, textStyle={TextStyle.Bold})}),
    Documentation(info="<html>
<p>BasicElectricThermal behind a switch or contact with a constant drop. No current flows while the voltage is below the drop.</p>
<pre>
  R_T*i = v - V_b*sign(v)   beyond V_b, else 0
  heatPort.Q_flow = -R_T*i^2
</pre>
<p>The corners are rounded over v_eps.</p>
</html>"));
end VoltageDrop;
