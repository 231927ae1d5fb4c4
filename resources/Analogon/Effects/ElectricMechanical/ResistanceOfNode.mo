within Analogon.Effects.ElectricMechanical;
model ResistanceOfNode "Resistance that follows a temperature of the model"
  extends Analogon.ElectricMechanical.PartialElectricMechanical;
  parameter Real alpha(unit="1/K", max=0.02) = 0 "Temperature coefficient of the resistance (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real T_ref(unit="K") = 293.15 "Temperature at which the resistance is R"
    annotation (Dialog(group="Effect"));
  Real R_w(unit="Ohm") "Resistance of the winding";
  Analogon.Interfaces.HeatPort_a heatPort "Where the temperature is taken; no heat flows"
    annotation (Placement(transformation(extent={{-10,-110},{10,-90}})));
equation
  R_w = R*(1 + alpha*(heatPort.T - T_ref));
  v = R_w*i + L*der(i) + k*w;
  flange.tau = -k*i;
  heatPort.Q_flow = 0;
  annotation (
    __Analogon(effect(
      kind = "resistance.temperature",
      way = "specialise",
      node = "heatPort",
      strength = "alpha")),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Text(extent={{-50,40},{50,-40}}, textString="M", textColor={0,0,0}, textStyle={TextStyle.Bold}),
        Rectangle(extent={{30,-50},{110,-100}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=8),
        Text(extent={{34,-56},{106,-94}}, textString="R(T)", textColor={213,94,0}, textStyle={TextStyle.Bold})}),
    Documentation(info="<html>
<p>BasicElectricMechanical whose resistance follows the temperature of a heat port that the model already has: a winding with its own heat balance.</p>
<pre>
  R_w = R*(1 + alpha*(heatPort.T - T_ref))
  v = R_w*i + L*der(i) + k*w
  flange.tau = -k*i
</pre>
</html>"));
end ResistanceOfNode;
