within Analogon.Effects.Sensor;
block Absolute "Measured channel without its sign"
  extends Analogon.Interfaces.PartialSignal;
  parameter Real s(unit="1", min=0, max=2) = 0 "Share of the sign that is lost (0: off, 1: a sensor without sign)"
    annotation (Dialog(group="Effect"));
  parameter Real u_eps(min=1e-12) = 1e-3 "Rounding of the corner"
    annotation (Dialog(group="Numerics"));
equation
  y = u + s*(sqrt(u^2 + u_eps^2) - u);
  annotation (
    __Analogon(effect(
      kind = "sensor.absolute",
      way = "insert",
      ports = {"u", "y"},
      at = "output",
      strength = "s",
      oneSided = true,
      inSignalUnit = {"u_eps"},
      fixed(u_eps = "0.003*maxabs(u)"),
      sharper(u_eps = 0.25),
      secant = {"1"},
      reach(s = 1.2))),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-80,-40},{85,-40}}, color={128,128,128}),
        Line(points={{0,80},{0,-80}}, color={128,128,128}),
        Line(points={{-70,40},{0,-40},{70,40}}, color={0,0,127}, thickness=0.75)}),
    Documentation(info="<html>
<p>A tachometer, a flow meter or a rectifying transducer that tells the size of a quantity and not its sign. Inserted in front of a measured output.</p>
<pre>
  y = (1 - s)*u + s*abs(u),  s = 1 for a sensor without sign
</pre>
</html>"));
end Absolute;
