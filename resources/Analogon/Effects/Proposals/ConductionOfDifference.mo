within Analogon.Effects.Proposals;
model ConductionOfDifference "Conduction that changes with the temperature difference"
  extends Analogon.Thermal.PartialThermalConductor;
  parameter Real n(unit="1", min=-1, max=3) = 0 "Exponent of the temperature difference (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real dT_ref(unit="K", min=1e-6) = 10 "Difference at which the conductance is G"
    annotation (Dialog(group="Effect"));
  parameter Real dT_eps(unit="K", min=1e-9) = 0.1 "Difference below which the power is smoothed"
    annotation (Dialog(group="Numerics"));
equation
  Q_flow = G*((dT^2 + dT_eps^2)/dT_ref^2)^(n/2)*dT;
  annotation (
    __Analogon(effect(
      kind = "proposal.conduction.difference",
      proposal = "G_T = G*(abs(dT)/dT_ref)^n",
      way = "specialise",
      strength = "n",
      fixed(dT_ref = "rms(dT)", dT_eps = "0.01*rms(dT)"))),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{30,-50},{110,-100}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, pattern=LinePattern.Dash, radius=8),
        Text(extent={{34,-56},{106,-94}}, textString="?", textColor={213,94,0}, textStyle={TextStyle.Bold})}),
    Documentation(info="<html>
<p>A layer of air or liquid that moves by itself, the more the warmer one side is: natural convection where the model has a mere conductance.</p>
<pre>
  Q_flow = G*(abs(port_a.T - port_b.T)/dT_ref)^n*(port_a.T - port_b.T)
</pre>
</html>"));
end ConductionOfDifference;
