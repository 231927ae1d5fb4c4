within Analogon.Effects.Proposals;
block SensorLimit "Upper limit of a measured channel"
  extends Analogon.Interfaces.PartialSignal;
  parameter Real s(min=0) = 0 "1/limit (0: no limit)"
    annotation (Dialog(group="Effect"));
equation
  y = u/(1 + (abs(s*u))^32)^(1/32);
  annotation (
    __Analogon(effect(
      kind = "proposal.sensor.limit",
      proposal = "y = min(u, y_max)",
      way = "insert",
      ports = {"u", "y"},
      at = "output",
      strength = "s",
      oneSided = true,
      secant = {"1/(0.98*maxabs(u))", "1/(0.92*maxabs(u))", "1/(0.75*maxabs(u))"})),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, pattern=LinePattern.Dash, radius=10),
        Text(extent={{-70,60},{70,-60}}, textString="?", textColor={213,94,0})}),
    Documentation(info="<html>
<p>A sensor or an amplifier that runs into its limit.</p>
<pre>
  y = min(u, 1/s)
</pre>
</html>"));
end SensorLimit;
