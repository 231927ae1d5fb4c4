within Analogon.Effects.Proposals;
model CurvedResistance "Resistance that is not straight in the temperature"
  extends Analogon.ElectricThermal.PartialElectricThermal;
  parameter Real beta(unit="1/K2") = 0 "Relative change with the square of the temperature above T_ref"
    annotation (Dialog(group="Effect"));
  Real R_q(unit="Ohm", start=1) "Resistance at the present temperature";
equation
  R_q = R_T + R*beta*(heatPort.T - T_ref)^2;
  v = R_q*i;
  heatPort.Q_flow = -R_q*i^2;
  annotation (
    __Analogon(effect(
      kind = "proposal.resistance.curve",
      proposal = "R_T = R*(1 + alpha*(T - T_ref) + beta*(T - T_ref)^2)",
      way = "specialise",
      strength = "beta")),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{30,-50},{110,-100}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, pattern=LinePattern.Dash, radius=8),
        Text(extent={{34,-56},{106,-94}}, textString="?", textColor={213,94,0}, textStyle={TextStyle.Bold})}),
    Documentation(info="<html>
<p>A heater whose resistance bends over a wide range of temperature, as that of platinum or of a ceramic does.</p>
<pre>
  R_q = R*(1 + alpha*(T - T_ref) + beta*(T - T_ref)^2)
  v = R_q*i
  heatPort.Q_flow = -R_q*i^2
</pre>
</html>"));
end CurvedResistance;
