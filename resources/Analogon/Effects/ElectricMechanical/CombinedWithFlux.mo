within Analogon.Effects.ElectricMechanical;
model CombinedWithFlux "Electric machine with several effects, warm magnets among them"
  extends PartialCombined;
  parameter Real e_m(unit="K/J", min=0) = 0 "Heating of the magnets per loss, 1/C_m (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real tau_m(unit="s", min=1e-6) = 100 "Time constant with which the magnets cool, C_m/G_m"
    annotation (Dialog(group="Effect"));
  final parameter Real C_m(unit="J/K") = if e_m > 0 then 1/e_m else 0 "Heat capacity of the magnets (0 while off)";
  final parameter Real G_m(unit="W/K") = C_m/tau_m "Conductance from the magnets to their surroundings (0 while off)";
  parameter Real beta(unit="1/K") = 0.002 "Loss of torque constant per temperature (ferrite magnets)"
    annotation (Dialog(group="Effect"));
  Real dT_m(unit="K", start=0, fixed=true, nominal=10) "Magnets over their temperature at the start";
  Real P_w(unit="W") "Loss in the winding";
equation
  R_w = R;
  k_T = k*(1 - beta*dT_m);
  P_w = R*i^2;
  der(dT_m) = e_m*P_w - dT_m/tau_m;
  annotation (
    __Analogon(combines = {
      "Analogon.Effects.ElectricMechanical.SeriesResistance",
      "Analogon.Effects.ElectricMechanical.VoltageDrop",
      "Analogon.Effects.ElectricMechanical.InductanceSaturation",
      "Analogon.Effects.ElectricMechanical.FluxTemperature"}),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Text(extent={{-50,40},{50,-40}}, textString="M", textColor={0,0,0}, textStyle={TextStyle.Bold}),
        Rectangle(extent={{30,-50},{110,-100}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=8),
        Text(extent={{34,-56},{106,-94}}, textString="+ +", textColor={213,94,0}, textStyle={TextStyle.Bold})}),
    Documentation(info="<html>
<p>Resistance of leads, drop of brushes, saturation of the inductance and magnets that the loss of the winding warms, in one machine. What is not asked for is off.</p>
<pre>
  k_T = k*(1 - beta*dT_m)
  C_m*der(dT_m) = R*i^2 - G_m*dT_m
  v = (R + R_s)*i + V_b*sign(i) + L/(1 + (i/i_s)^2)*der(i) + k_T*der(flange.phi)
  flange.tau = -k_T*i
</pre>
</html>"));
end CombinedWithFlux;
