within Analogon.Effects.ElectricMechanical;
partial model PartialCombined "Leads, brushes and a saturating inductance at once"
  extends Analogon.ElectricMechanical.PartialElectricMechanical;
  parameter Real R_s(unit="Ohm", min=0) = 0 "Resistance outside the winding (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real V_b(unit="V", min=0) = 0 "Voltage drop (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real i_eps(unit="A", min=1e-12) = 0.01 "Current over which the change of sign is smoothed"
    annotation (Dialog(group="Numerics"));
  parameter Real s_i(unit="1/A", min=0) = 0 "Saturation 1/i_s: at the current i_s half of the inductance is left (0: off)"
    annotation (Dialog(group="Effect"));
  final parameter Real i_s(unit="A") = if s_i > 0 then 1/s_i else 0 "Current at which half of the inductance is left (0 while off)";
  Real L_i(unit="H") "Inductance at the present current";
  Real R_w(unit="Ohm") "Resistance of the winding";
  Real k_T(unit="N.m/A") "Torque constant";
equation
  L_i = L/(1 + (s_i*i)^2);
  v = (R_w + R_s)*i + V_b*tanh(i/i_eps) + L*(der(i)/(1 + (s_i*i)^2)) + k_T*w;
  flange.tau = -k_T*i;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{30,-50},{110,-100}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=8),
        Text(extent={{34,-56},{106,-94}}, textString="+ +", textColor={213,94,0}, textStyle={TextStyle.Bold})}),
    Documentation(info="<html>
<p>Base of the electric machines with several effects at once. A class that extends it says what the resistance of the winding and the torque constant are.</p>
<pre>
  L_i = L/(1 + (i/i_s)^2),  i_s = 1/s_i
  v = (R_w + R_s)*i + V_b*sign(i) + L_i*der(i) + k_T*der(flange.phi)
  flange.tau = -k_T*i
</pre>
</html>"));
end PartialCombined;
