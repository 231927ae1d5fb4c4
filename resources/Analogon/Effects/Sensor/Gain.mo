within Analogon.Effects.Sensor;
block Gain "Gain error of a measured channel"
  extends Analogon.Effects.Signals.PartialGain;
  annotation (
    __Analogon(effect(
      kind = "sensor.gain",
      way = "insert",
      ports = {"u", "y"},
      at = "output",
      strength = "g")),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}})),
    Documentation(info="<html>
<p>An error of a sensor: inserted in front of a measured output.</p>
<pre>
  y = (1 + g)*u
</pre>
</html>"));
end Gain;
