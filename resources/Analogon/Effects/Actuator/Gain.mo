within Analogon.Effects.Actuator;
block Gain "Gain error of an input channel"
  extends Analogon.Effects.Signals.PartialGain;
  annotation (
    __Analogon(effect(
      kind = "actuator.gain",
      way = "insert",
      ports = {"u", "y"},
      at = "input",
      strength = "g")),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}})),
    Documentation(info="<html>
<p>An error of an actuator or its driver: inserted behind an input.</p>
<pre>
  y = (1 + g)*u
</pre>
</html>"));
end Gain;
