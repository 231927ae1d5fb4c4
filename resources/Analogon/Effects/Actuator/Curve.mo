within Analogon.Effects.Actuator;
block Curve "Curved characteristic of an input channel"
  extends Analogon.Interfaces.PartialSignal;
  parameter Real p(unit="1", min=-0.9, max=3) = 0 "Exponent beyond that of proportion (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real u_ref(min=1e-12) = 1 "Command that passes unchanged"
    annotation (Dialog(group="Effect"));
  parameter Real u_eps(min=1e-12) = 1e-3 "Command below which the power is smoothed"
    annotation (Dialog(group="Numerics"));
equation
  y = u*((u^2 + u_eps^2)/(u_ref^2 + u_eps^2))^(p/2);
  annotation (
    __Analogon(effect(
      kind = "actuator.curve",
      way = "insert",
      ports = {"u", "y"},
      at = "input",
      strength = "p",
      flexible = true,
      inSignalUnit = {"u_ref", "u_eps"},
      fixed(u_ref = "maxabs(u)", u_eps = "0.003*maxabs(u)"))),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-80,0},{85,0}}, color={128,128,128}),
        Line(points={{0,80},{0,-80}}, color={128,128,128}),
        Line(points={{-70,-70},{70,70}}, color={128,128,128}, thickness=0.25, pattern=LinePattern.Dash),
        Line(points={{-70,-70},{-50,-36},{-30,-13},{-12,-2},{0,0},{12,2},{30,13},{50,36},{70,70}}, color={0,0,127}, thickness=0.75)}),
    Documentation(info="<html>
<p>A torque, a power or a flow that is no multiple of the command: a heater behind a voltage gives the square (p = 1), a valve or a lamp driver another power. Inserted behind an input.</p>
<pre>
  y = u*(abs(u)/u_ref)^p
</pre>
<p>The power is smoothed below u_eps so that it has a slope at 0. At u_ref the command passes unchanged.</p>
</html>"));
end Curve;
