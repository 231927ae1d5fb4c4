within Analogon.Effects.ElectricMechanical;
model CombinedWithWindingAndFlux "Electric machine with several effects, a warm winding and warm magnets among them"
  extends PartialCombined;
  parameter Real e_w(unit="K/J", min=0) = 0 "Heating of the winding per loss, 1/C_w (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real tau_w(unit="s", min=1e-6) = 100 "Time constant with which the winding cools, C_w/G_w"
    annotation (Dialog(group="Effect"));
  final parameter Real C_w(unit="J/K") = if e_w > 0 then 1/e_w else 0 "Heat capacity of the winding (0 while off)";
  final parameter Real G_w(unit="W/K") = C_w/tau_w "Conductance from the winding to its surroundings (0 while off)";
  parameter Real alpha(unit="1/K") = 0.00393 "Temperature coefficient of the resistance (copper)"
    annotation (Dialog(group="Effect"));
  parameter Real e_m(unit="K/J", min=0) = 0 "Heating of the magnets per loss, 1/C_m (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real tau_m(unit="s", min=1e-6) = 100 "Time constant with which the magnets cool, C_m/G_m"
    annotation (Dialog(group="Effect"));
  final parameter Real C_m(unit="J/K") = if e_m > 0 then 1/e_m else 0 "Heat capacity of the magnets (0 while off)";
  final parameter Real G_m(unit="W/K") = C_m/tau_m "Conductance from the magnets to their surroundings (0 while off)";
  parameter Real beta(unit="1/K") = 0.002 "Loss of torque constant per temperature (ferrite magnets)"
    annotation (Dialog(group="Effect"));
  Real dT_w(unit="K", start=0, fixed=true, nominal=10) "Winding over its temperature at the start";
  Real dT_m(unit="K", start=0, fixed=true, nominal=10) "Magnets over their temperature at the start";
  Real P_w(unit="W") "Loss in the winding";
equation
  R_w = R*(1 + alpha*dT_w);
  k_T = k*(1 - beta*dT_m);
  P_w = R_w*i^2;
  der(dT_w) = e_w*P_w - dT_w/tau_w;
  der(dT_m) = e_m*P_w - dT_m/tau_m;
  annotation (
    __Analogon(combines = {
      "Analogon.Effects.ElectricMechanical.SeriesResistance",
      "Analogon.Effects.ElectricMechanical.VoltageDrop",
      "Analogon.Effects.ElectricMechanical.InductanceSaturation",
      "Analogon.Effects.ElectricMechanical.WindingTemperature",
      "Analogon.Effects.ElectricMechanical.FluxTemperature"}),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Text(extent={{-50,40},{50,-40}}, textString="M", textColor={0,0,0}, textStyle={TextStyle.Bold}),
        Rectangle(extent={{30,-50},{110,-100}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=8),
        Text(extent={{34,-56},{106,-94}}, textString="+ +", textColor={213,94,0}, textStyle={TextStyle.Bold})}),
    Documentation(info="<html>
<p>Resistance of leads, drop of brushes, saturation of the inductance, a winding that its loss warms and magnets that it warms too, each with a heat balance of its own, in one machine. What is not asked for is off.</p>
<pre>
  R_w = R*(1 + alpha*dT_w)
  C_w*der(dT_w) = R_w*i^2 - G_w*dT_w
  k_T = k*(1 - beta*dT_m)
  C_m*der(dT_m) = R_w*i^2 - G_m*dT_m
  v = (R_w + R_s)*i + V_b*sign(i) + L/(1 + (i/i_s)^2)*der(i) + k_T*der(flange.phi)
  flange.tau = -k_T*i
</pre>
</html>"));
end CombinedWithWindingAndFlux;
