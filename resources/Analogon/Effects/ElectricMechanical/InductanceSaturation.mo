within Analogon.Effects.ElectricMechanical;
model InductanceSaturation "Saturation of the inductance with the current"
  extends Analogon.ElectricMechanical.PartialElectricMechanical;
  parameter Real s_i(unit="1/A", min=0) = 0 "Saturation 1/i_s: at the current i_s half of the inductance is left (0: off)"
    annotation (Dialog(group="Effect"));
  final parameter Real i_s(unit="A") = if s_i > 0 then 1/s_i else 0 "Current at which half of the inductance is left (0 while off)";
  Real L_i(unit="H") "Inductance at the present current";
equation
  L_i = L/(1 + (s_i*i)^2);
  v = R*i + L*(der(i)/(1 + (s_i*i)^2)) + k*w;
  flange.tau = -k*i;
  annotation (
    __Analogon(effect(
      kind = "inductance.saturation",
      way = "specialise",
      strength = "s_i",
      oneSided = true,
      secant = {"0.5/maxabs(i)", "1.5/maxabs(i)"})),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Text(extent={{-50,40},{50,-40}}, textString="M", textColor={0,0,0}, textStyle={TextStyle.Bold}),
        Rectangle(extent={{30,-50},{110,-100}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=8),
        Text(extent={{34,-56},{106,-94}}, textString="L(i)", textColor={213,94,0}, textStyle={TextStyle.Bold})}),
    Documentation(info="<html>
<p>BasicElectricMechanical with an iron path that saturates.</p>
<pre>
  L_i = L/(1 + (i/i_s)^2),  i_s = 1/s_i
  v = R*i + L_i*der(i) + k*der(flange.phi)
  flange.tau = -k*i
</pre>
</html>"));
end InductanceSaturation;
