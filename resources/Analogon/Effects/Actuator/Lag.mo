within Analogon.Effects.Actuator;
block Lag "Lag of an input channel"
  extends Analogon.Effects.Signals.PartialLag;
  annotation (
    __Analogon(effect(
      kind = "actuator.lag",
      way = "insert",
      ports = {"u", "y"},
      at = "input",
      strength = "T",
      oneSided = true,
      secant = {"0.25*sample", "2*sample", "12*sample", "60*sample"})),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}})),
    Documentation(info="<html>
<p>An error of an actuator or its driver: inserted behind an input.</p>
<pre>
  T*der(y) = u - y,  y(0) = u(0)
</pre>
</html>"));
end Lag;
