within Analogon.Effects.ElectricMechanical;
model CombinedOfNode "Electric machine with several effects, the temperature of a node among their causes"
  extends PartialCombined;
  parameter Real alpha(unit="1/K", max=0.02) = 0 "Temperature coefficient of the resistance (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real beta(unit="1/K", min=-0.005, max=0.02) = 0 "Fall of the torque constant per kelvin (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real T_ref(unit="K") = 293.15 "Temperature at which resistance and torque constant are R and k"
    annotation (Dialog(group="Effect"));
  Analogon.Interfaces.HeatPort_a heatPort "Where the temperature is taken; no heat flows"
    annotation (Placement(transformation(extent={{-10,-110},{10,-90}})));
equation
  R_w = R*(1 + alpha*(heatPort.T - T_ref));
  k_T = k*(1 - beta*(heatPort.T - T_ref));
  heatPort.Q_flow = 0;
  annotation (
    __Analogon(combines = {
      "Analogon.Effects.ElectricMechanical.SeriesResistance",
      "Analogon.Effects.ElectricMechanical.VoltageDrop",
      "Analogon.Effects.ElectricMechanical.InductanceSaturation",
      "Analogon.Effects.ElectricMechanical.ResistanceOfNode",
      "Analogon.Effects.ElectricMechanical.FluxOfNode"}),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Text(extent={{-50,40},{50,-40}}, textString="M", textColor={0,0,0}, textStyle={TextStyle.Bold}),
        Rectangle(extent={{30,-50},{110,-100}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=8),
        Text(extent={{34,-56},{106,-94}}, textString="+ +", textColor={213,94,0}, textStyle={TextStyle.Bold})}),
    Documentation(info="<html>
<p>Resistance of leads, drop of brushes, saturation of the inductance, and a resistance and a magnet that follow the temperature of a heat port of the model, in one machine. What is not asked for is off.</p>
<pre>
  R_w = R*(1 + alpha*(heatPort.T - T_ref))
  k_T = k*(1 - beta*(heatPort.T - T_ref))
  v = (R_w + R_s)*i + V_b*sign(i) + L/(1 + (i/i_s)^2)*der(i) + k_T*der(flange.phi)
  flange.tau = -k_T*i
</pre>
</html>"));
end CombinedOfNode;
