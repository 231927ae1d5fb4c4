within Analogon.Effects.Actuator;
block CelsiusGain "Gain error of a commanded or recorded temperature that is right at 0 degC"
  extends Analogon.Effects.Signals.PartialCelsiusGain;
  annotation (
    __Analogon(effect(
      kind = "actuator.gain",
      way = "insert",
      ports = {"u", "y"},
      at = "input",
      quantity = "K",
      strength = "g")),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}})),
    Documentation(info="<html>
<p>An error of what sets or records a temperature that drives the model: inserted behind an input.</p>
<pre>
  y = u + g*(u - 273.15)
</pre>
</html>"));
end CelsiusGain;
