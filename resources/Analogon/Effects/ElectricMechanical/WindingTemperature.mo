within Analogon.Effects.ElectricMechanical;
model WindingTemperature "Warming of the winding, which gains resistance"
  extends Analogon.ElectricMechanical.PartialElectricMechanical;
  parameter Real e_w(unit="K/J", min=0) = 0 "Heating of the winding per loss, 1/C_w (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real tau_w(unit="s", min=1e-6) = 100 "Time constant with which the winding cools, C_w/G_w"
    annotation (Dialog(group="Effect"));
  final parameter Real C_w(unit="J/K") = if e_w > 0 then 1/e_w else 0 "Heat capacity of the winding (0 while off)";
  final parameter Real G_w(unit="W/K") = C_w/tau_w "Conductance from the winding to its surroundings (0 while off)";
  parameter Real alpha(unit="1/K") = 0.00393 "Temperature coefficient of the resistance (copper)"
    annotation (Dialog(group="Effect"));
  Real dT_w(unit="K", start=0, fixed=true, nominal=10) "Winding over its temperature at the start";
  Real P_w(unit="W") "Loss in the winding";
  Real R_w(unit="Ohm") "Resistance of the winding";
equation
  R_w = R*(1 + alpha*dT_w);
  P_w = R_w*i^2;
  der(dT_w) = e_w*P_w - dT_w/tau_w;
  v = R_w*i + L*der(i) + k*w;
  flange.tau = -k*i;
  annotation (
    __Analogon(effect(
      kind = "resistance.temperature",
      way = "specialise",
      strength = "e_w",
      oneSided = true,
      reach(tau_w = 10),
      shape(tau_w = {"0.05*duration", "0.25*duration", "duration", "5*duration"}))),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Text(extent={{-50,40},{50,-40}}, textString="M", textColor={0,0,0}, textStyle={TextStyle.Bold}),
        Rectangle(extent={{30,-50},{110,-100}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=8),
        Text(extent={{34,-56},{106,-94}}, textString="R(T)", textColor={213,94,0}, textStyle={TextStyle.Bold})}),
    Documentation(info="<html>
<p>BasicElectricMechanical with a winding that is heated by its own loss. Only alpha/C_w and C_w/G_w show in current and speed, so alpha keeps the value of copper, and heat capacity and conductance are given by e_w and tau_w: C_w = 1/e_w, G_w = C_w/tau_w.</p>
<pre>
  R_w = R*(1 + alpha*dT_w)
  C_w*der(dT_w) = R_w*i^2 - G_w*dT_w
  v = R_w*i + L*der(i) + k*der(flange.phi)
  flange.tau = -k*i
</pre>
</html>"));
end WindingTemperature;
