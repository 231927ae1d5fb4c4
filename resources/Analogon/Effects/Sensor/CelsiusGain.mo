within Analogon.Effects.Sensor;
block CelsiusGain "Gain error of a thermometer that is right at 0 degC"
  extends Analogon.Effects.Signals.PartialCelsiusGain;
  annotation (
    __Analogon(effect(
      kind = "sensor.gain",
      way = "insert",
      ports = {"u", "y"},
      at = "output",
      quantity = "K",
      strength = "g")),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}})),
    Documentation(info="<html>
<p>An error of a thermometer: inserted in front of a measured temperature.</p>
<pre>
  y = u + g*(u - 273.15)
</pre>
</html>"));
end CelsiusGain;
