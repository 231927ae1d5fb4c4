within Analogon.Effects.ElectricMechanical;
model FluxTemperature "Warming of the magnets, which takes torque constant"
  extends Analogon.ElectricMechanical.PartialElectricMechanical;
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
  Real k_T(unit="N.m/A") "Torque constant at the present temperature";
equation
  k_T = k*(1 - beta*dT_m);
  P_w = R*i^2;
  der(dT_m) = e_m*P_w - dT_m/tau_m;
  v = R*i + L*der(i) + k_T*w;
  flange.tau = -k_T*i;
  annotation (
    __Analogon(effect(
      kind = "flux.temperature",
      way = "specialise",
      strength = "e_m",
      oneSided = true,
      reach(tau_m = 10),
      shape(tau_m = {"0.05*duration", "0.25*duration", "duration", "5*duration"}))),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Text(extent={{-50,40},{50,-40}}, textString="M", textColor={0,0,0}, textStyle={TextStyle.Bold}),
        Rectangle(extent={{30,-50},{110,-100}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=8),
        Text(extent={{34,-56},{106,-94}}, textString="k(T)", textColor={213,94,0}, textStyle={TextStyle.Bold})}),
    Documentation(info="<html>
<p>BasicElectricMechanical with magnets that weaken as the loss of the winding warms them. Only beta/C_m shows, so beta keeps a typical value and e_m = 1/C_m is the strength.</p>
<pre>
  k_T = k*(1 - beta*dT_m)
  C_m*der(dT_m) = R*i^2 - C_m/tau_m*dT_m
  v = R*i + L*der(i) + k_T*der(flange.phi)
  flange.tau = -k_T*i
</pre>
</html>"));
end FluxTemperature;
