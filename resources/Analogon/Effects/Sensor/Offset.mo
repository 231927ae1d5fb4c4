within Analogon.Effects.Sensor;
block Offset "Offset of a measured channel"
  extends Analogon.Effects.Signals.PartialOffset;
  annotation (
    __Analogon(effect(
      kind = "sensor.offset",
      way = "insert",
      ports = {"u", "y"},
      at = "output",
      strength = "b",
      inSignalUnit = {"b"})),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}})),
    Documentation(info="<html>
<p>An error of a sensor: inserted in front of a measured output.</p>
<pre>
  y = u + b
</pre>
</html>"));
end Offset;
