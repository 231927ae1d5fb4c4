within Analogon.Effects.Sensor;
block Delay "Dead time of a measured channel"
  extends Analogon.Effects.Signals.PartialDelay;
  annotation (
    __Analogon(effect(
      kind = "sensor.delay",
      way = "insert",
      ports = {"u", "y"},
      at = "output",
      strength = "T",
      oneSided = true,
      secant = {"0.25*sample", "2*sample", "8*sample", "32*sample"})),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}})),
    Documentation(info="<html>
<p>An error of a sensor: inserted in front of a measured output.</p>
<pre>
  y(t) = u(t - T)
</pre>
</html>"));
end Delay;
