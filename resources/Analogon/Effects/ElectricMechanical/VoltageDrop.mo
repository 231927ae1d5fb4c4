within Analogon.Effects.ElectricMechanical;
model VoltageDrop "Voltage drop of brushes or diodes"
  extends Analogon.ElectricMechanical.PartialElectricMechanical;
  parameter Real V_b(unit="V", min=0) = 0 "Voltage drop (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real i_eps(unit="A", min=1e-12) = 0.01 "Current over which the change of sign is smoothed"
    annotation (Dialog(group="Numerics"));
equation
  v = R*i + V_b*tanh(i/i_eps) + L*der(i) + k*w;
  flange.tau = -k*i;
  annotation (
    __Analogon(effect(
      kind = "voltage.drop",
      way = "specialise",
      strength = "V_b",
      oneSided = true,
      fixed(i_eps = "0.004*rms(i)"),
      sharper(i_eps = 0.25))),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Text(extent={{-50,40},{50,-40}}, textString="M", textColor={0,0,0}, textStyle={TextStyle.Bold}),
        Rectangle(extent={{30,-50},{110,-100}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=8),
        Text(extent={{34,-56},{106,-94}}, textString="V_b", textColor={213,94,0}, textStyle={TextStyle.Bold})}),
    Documentation(info="<html>
<p>BasicElectricMechanical with a constant drop against the current. While the voltage cannot overcome it the current stays at 0.</p>
<pre>
  v = V_b*sign(i) + R*i + L*der(i) + k*der(flange.phi)
  flange.tau = -k*i
</pre>
<p>The change of sign is smoothed over the small current i_eps.</p>
</html>"));
end VoltageDrop;
