within Analogon.Effects.Proposals;
model HeaterCurrentLimit "Driver that limits the current of a heater"
  extends Analogon.ElectricThermal.PartialElectricThermal;
  parameter Real s(unit="1/A", min=0) = 0 "1/limit (0: no limit)"
    annotation (Dialog(group="Effect"));
  final parameter Real limit(unit="A") = if s > 0 then 1/s else 0 "Largest current (0 while off)";
equation
  i = v/R_T/(1 + (s*v/R_T)^32)^(1/32);
  heatPort.Q_flow = -R_T*i^2;
  annotation (
    __Analogon(effect(
      kind = "proposal.current.limit",
      proposal = "abs(i) <= limit",
      way = "specialise",
      strength = "s",
      oneSided = true,
      secant = {"1/(0.25*maxabs(i))", "1/(0.45*maxabs(i))", "1/(0.65*maxabs(i))", "1/(0.8*maxabs(i))", "1/(0.93*maxabs(i))"})),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{30,-50},{110,-100}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, pattern=LinePattern.Dash, radius=8),
        Text(extent={{34,-56},{106,-94}}, textString="?", textColor={213,94,0}, textStyle={TextStyle.Bold})}),
    Documentation(info="<html>
<p>A driver that takes voltage back where the current of a cold heater would pass its limit; the recorded voltage is the command.</p>
<pre>
  i = min(v/R_T, limit), with a rounded corner
  heatPort.Q_flow = -R_T*i^2
</pre>
</html>"));
end HeaterCurrentLimit;
