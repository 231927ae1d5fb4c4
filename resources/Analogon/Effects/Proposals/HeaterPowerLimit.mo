within Analogon.Effects.Proposals;
model HeaterPowerLimit "Driver that limits the power of a heater"
  extends Analogon.ElectricThermal.PartialElectricThermal;
  parameter Real s(unit="1/W", min=0) = 0 "1/limit (0: no limit)"
    annotation (Dialog(group="Effect"));
  final parameter Real limit(unit="W") = if s > 0 then 1/s else 0 "Largest power (0 while off)";
  Real P_c(unit="W") "Power at the voltage that is commanded";
equation
  P_c = v^2/R_T;
  i = v/R_T/(1 + (s*P_c)^32)^(1/64);
  heatPort.Q_flow = -R_T*i^2;
  annotation (
    __Analogon(effect(
      kind = "proposal.power.limit",
      proposal = "R_T*i^2 <= limit",
      way = "specialise",
      strength = "s",
      oneSided = true,
      secant = {"1/(0.25*maxabs(P_c))", "1/(0.45*maxabs(P_c))", "1/(0.65*maxabs(P_c))", "1/(0.8*maxabs(P_c))", "1/(0.93*maxabs(P_c))"})),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{30,-50},{110,-100}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, pattern=LinePattern.Dash, radius=8),
        Text(extent={{34,-56},{106,-94}}, textString="?", textColor={213,94,0}, textStyle={TextStyle.Bold})}),
    Documentation(info="<html>
<p>A driver that takes voltage back where the heater would take more than so much power; the recorded voltage is the command.</p>
<pre>
  P_c = v^2/R_T
  R_T*i^2 = min(P_c, limit), with a rounded corner
  heatPort.Q_flow = -R_T*i^2
</pre>
</html>"));
end HeaterPowerLimit;
