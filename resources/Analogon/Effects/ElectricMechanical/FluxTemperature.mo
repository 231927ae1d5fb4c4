within Analogon.Effects.ElectricMechanical;
model FluxTemperature "Warming of the magnets, which takes torque constant"
  extends Analogon.ElectricMechanical.PartialElectricMechanical;
  parameter Real e_w(unit="K/J", min=0) = 0 "Heating of the winding per loss, 1/C_w (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real tau_w(unit="s", min=1e-6) = 100 "Time constant with which the winding cools, C_w/G_w"
    annotation (Dialog(group="Effect"));
  final parameter Real C_w(unit="J/K") = if e_w > 0 then 1/e_w else 0 "Heat capacity of the winding (0 while off)";
  final parameter Real G_w(unit="W/K") = C_w/tau_w "Conductance from the winding to its surroundings (0 while off)";
  parameter Real beta(unit="1/K") = 0.002 "Loss of torque constant per temperature (ferrite magnets)"
    annotation (Dialog(group="Effect"));
  Real dT_w(unit="K", start=0, fixed=true, nominal=10) "Winding over its temperature at the start";
  Real P_w(unit="W") "Loss in the winding";
  Real k_T(unit="N.m/A") "Torque constant at the present temperature";
equation
  k_T = k*(1 - beta*dT_w);
  P_w = R*i^2;
  der(dT_w) = e_w*P_w - dT_w/tau_w;
  v = R*i + L*der(i) + k_T*w;
  flange.tau = -k_T*i;
  annotation (
    __Analogon(effect(
      kind = "flux.temperature",
      way = "specialise",
      strength = "e_w",
      oneSided = true,
      reach(tau_w = 10),
      shape(tau_w = {"0.05*duration", "0.25*duration", "duration", "5*duration"}))),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Text(extent={{-50,40},{50,-40}}, textString="M", textColor={0,0,0}, textStyle={TextStyle.Bold}),
        Rectangle(extent={{30,-50},{110,-100}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=8),
        Text(extent={{34,-56},{106,-94}}, textString="k(T)", textColor={213,94,0}, textStyle={TextStyle.Bold})}),
    Documentation(info="<html>
<p>BasicElectricMechanical with magnets that weaken as the loss of the winding warms them. Only beta/C_w shows, so beta keeps a typical value and e_w = 1/C_w is the strength.</p>
<pre>
  k_T = k*(1 - beta*dT_w)
  C_w*der(dT_w) = R*i^2 - C_w/tau_w*dT_w
  v = R*i + L*der(i) + k_T*der(flange.phi)
  flange.tau = -k_T*i
</pre>
</html>"));
end FluxTemperature;
