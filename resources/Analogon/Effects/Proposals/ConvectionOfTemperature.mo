within Analogon.Effects.Proposals;
model ConvectionOfTemperature "Convection that grows with the temperature of the body"
  extends Analogon.ThermalFluid.PartialThermalFluid;
  parameter Real a(unit="1/K") = 0 "Relative change of the conductance for each kelvin of the body (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real T_ref(unit="K", min=0) = 293.15 "Temperature of the body at which the conductance is that without the effect"
    annotation (Dialog(group="Effect"));
equation
  G_c = c_o*A*(fluid.T/3.6)^0.78*(1 + a*(solid.T - T_ref));
  annotation (
    __Analogon(effect(
      kind = "proposal.convection.temperature",
      proposal = "G_c = c_o*A*(T_fluid/3.6)^0.78*(1 + a*(T - T_ref))",
      way = "specialise",
      strength = "a")),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{30,-50},{110,-100}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, pattern=LinePattern.Dash, radius=8),
        Text(extent={{34,-56},{106,-94}}, textString="?", textColor={213,94,0}, textStyle={TextStyle.Bold})}),
    Documentation(info="<html>
<p>As BasicThermalFluid, with a conductance that is straight in the temperature of the body: the film at its surface, or a coat that conducts better when it is warm.</p>
<pre>
  G_c = c_o*A*(fluid.T/3.6)^0.78*(1 + a*(solid.T - T_ref))
</pre>
</html>"));
end ConvectionOfTemperature;
