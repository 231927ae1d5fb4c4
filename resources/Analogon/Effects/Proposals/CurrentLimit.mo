within Analogon.Effects.Proposals;
model CurrentLimit "Driver that limits the current"
  extends Analogon.ElectricMechanical.PartialElectricMechanical;
  parameter Real s(unit="1/A", min=0) = 0 "1/limit (0: no limit)"
    annotation (Dialog(group="Effect"));
  final parameter Real limit(unit="A") = if s > 0 then 1/s else 0 "Largest current (0 while off)";
  Real v_i(unit="V") "Voltage that is left for the current";
equation
  v_i = (v - k*w)/(1 + (s*(v - k*w)/R)^32)^(1/32);
  v_i = R*i + L*der(i);
  flange.tau = -k*i;
  annotation (
    __Analogon(effect(
      kind = "proposal.current.limit",
      proposal = "abs(i) <= limit",
      way = "specialise",
      strength = "s",
      oneSided = true,
      secant = {"1/(0.25*maxabs(i))", "1/(0.45*maxabs(i))", "1/(0.65*maxabs(i))", "1/(0.8*maxabs(i))", "1/(0.93*maxabs(i))"})),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Text(extent={{-50,40},{50,-40}}, textString="M", textColor={0,0,0}, textStyle={TextStyle.Bold}),
        Rectangle(extent={{30,-50},{110,-100}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, pattern=LinePattern.Dash, radius=8),
        Text(extent={{34,-56},{106,-94}}, textString="?", textColor={213,94,0}, textStyle={TextStyle.Bold})}),
    Documentation(info="<html>
<p>A driver that takes voltage back where the current would pass its limit; the recorded voltage is the command.</p>
<pre>
  v_i = v - k*w, within R*limit on either side, with a rounded corner
  v_i = R*i + L*der(i)
  flange.tau = -k*i
</pre>
</html>"));
end CurrentLimit;
