within Analogon.Effects.Actuator;
block Delay "Dead time of an input channel"
  extends Analogon.Effects.Signals.PartialDelay;
  annotation (
    __Analogon(effect(
      kind = "actuator.delay",
      way = "insert",
      ports = {"u", "y"},
      at = "input",
      strength = "T",
      oneSided = true,
      secant = {"0.25*sample", "2*sample", "8*sample", "32*sample"})),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}})),
    Documentation(info="<html>
<p>An error of an actuator or its driver: inserted behind an input.</p>
<pre>
  y(t) = u(t - T)
</pre>
</html>"));
end Delay;
