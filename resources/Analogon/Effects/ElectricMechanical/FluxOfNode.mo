within Analogon.Effects.ElectricMechanical;
model FluxOfNode "Torque constant that follows a temperature of the model"
  extends Analogon.ElectricMechanical.PartialElectricMechanical;
  parameter Real beta(unit="1/K", min=-0.005, max=0.02) = 0 "Fall of the torque constant per kelvin (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real T_ref(unit="K") = 293.15 "Temperature at which the torque constant is k"
    annotation (Dialog(group="Effect"));
  Real k_T(unit="N.m/A") "Torque constant";
  Analogon.Interfaces.HeatPort_a heatPort "Where the temperature is taken; no heat flows"
    annotation (Placement(transformation(extent={{-10,-110},{10,-90}})));
equation
  k_T = k*(1 - beta*(heatPort.T - T_ref));
  v = R*i + L*der(i) + k_T*w;
  flange.tau = -k_T*i;
  heatPort.Q_flow = 0;
  annotation (
    __Analogon(effect(
      kind = "flux.temperature",
      way = "specialise",
      node = "heatPort",
      strength = "beta")),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Text(extent={{-50,40},{50,-40}}, textString="M", textColor={0,0,0}, textStyle={TextStyle.Bold}),
        Rectangle(extent={{30,-50},{110,-100}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=8),
        Text(extent={{34,-56},{106,-94}}, textString="k(T)", textColor={213,94,0}, textStyle={TextStyle.Bold})}),
    Documentation(info="<html>
<p>BasicElectricMechanical whose magnet weakens with the temperature of a heat port that the model already has.</p>
<pre>
  k_T = k*(1 - beta*(heatPort.T - T_ref))
  v = R*i + L*der(i) + k_T*w
  flange.tau = -k_T*i
</pre>
</html>"));
end FluxOfNode;
