within Analogon.Effects.Proposals;
model ConductionOfTemperature "Conduction that changes with its temperature"
  extends Analogon.Thermal.PartialThermalConductor;
  parameter Real a(unit="1/K") = 0 "Relative change of the conductance for each kelvin of its mean temperature (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real T_ref(unit="K", displayUnit="degC", min=0) = 293.15 "Mean temperature at which the conductance is G"
    annotation (Dialog(group="Effect"));
equation
  Q_flow = G*(1 + a*((port_a.T + port_b.T)/2 - T_ref))*dT;
  annotation (
    __Analogon(effect(
      kind = "proposal.conduction.temperature",
      proposal = "G_T = G*(1 + a*(T_mean - T_ref))",
      way = "specialise",
      strength = "a")),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{30,-50},{110,-100}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, pattern=LinePattern.Dash, radius=8),
        Text(extent={{34,-56},{106,-94}}, textString="?", textColor={213,94,0}, textStyle={TextStyle.Bold})}),
    Documentation(info="<html>
<p>A bond, a paste or a gap that conducts better or worse when it is warm.</p>
<pre>
  Q_flow = G*(1 + a*((port_a.T + port_b.T)/2 - T_ref))*(port_a.T - port_b.T)
</pre>
</html>"));
end ConductionOfTemperature;
