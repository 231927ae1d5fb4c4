within Analogon.Effects.Sensor;
block Lag "Lag of a measured channel"
  extends Analogon.Effects.Signals.PartialLag;
  annotation (
    __Analogon(effect(
      kind = "sensor.lag",
      way = "insert",
      ports = {"u", "y"},
      at = "output",
      strength = "T",
      oneSided = true,
      secant = {"0.25*sample", "2*sample", "12*sample", "60*sample"})),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}})),
    Documentation(info="<html>
<p>An error of a sensor: inserted in front of a measured output.</p>
<pre>
  T*der(y) = u - y,  y(0) = u(0)
</pre>
</html>"));
end Lag;
