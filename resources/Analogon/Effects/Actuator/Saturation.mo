within Analogon.Effects.Actuator;
block Saturation "Limit of an input channel"
  extends Analogon.Interfaces.PartialSignal;
  parameter Real s(min=0) = 0 "1/limit (0: no limit)"
    annotation (Dialog(group="Effect"));
  final parameter Real limit = if s > 0 then 1/s else 0 "Limit, in the unit of the signal (0 while there is none)";
  parameter Real n(min=1) = 16 "How sharply the limit sets in"
    annotation (Dialog(group="Numerics"));
equation
  y = u/(1 + ((s*u)^2)^n)^(1/(2*n));
  annotation (
    __Analogon(effect(
      kind = "actuator.saturation",
      way = "insert",
      ports = {"u", "y"},
      at = "input",
      strength = "s",
      oneSided = true,
      fixed(n = "16"),
      sharper(n = 4),
      reach(s = 1.05),
      inSignalUnit = {"limit"},
      secant = {"1/(0.98*maxabs(u))", "1/(0.92*maxabs(u))", "1/(0.75*maxabs(u))"})),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-80,0},{85,0}}, color={128,128,128}),
        Line(points={{0,80},{0,-80}}, color={128,128,128}),
        Line(points={{-75,-50},{-40,-50},{40,50},{75,50}}, color={0,0,127}, thickness=0.75)}),
    Documentation(info="<html>
<p>An error of an actuator or its driver: inserted behind an input.</p>
<pre>
  y = u          up to the limit 1/s
  y = +-1/s       beyond
</pre>
</html>"));
end Saturation;
