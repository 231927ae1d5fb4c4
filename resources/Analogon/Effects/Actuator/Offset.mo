within Analogon.Effects.Actuator;
block Offset "Offset of an input channel"
  extends Analogon.Effects.Signals.PartialOffset;
  annotation (
    __Analogon(effect(
      kind = "actuator.offset",
      way = "insert",
      ports = {"u", "y"},
      at = "input",
      strength = "b",
      inSignalUnit = {"b"})),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}})),
    Documentation(info="<html>
<p>An error of an actuator or its driver: inserted behind an input.</p>
<pre>
  y = u + b
</pre>
</html>"));
end Offset;
