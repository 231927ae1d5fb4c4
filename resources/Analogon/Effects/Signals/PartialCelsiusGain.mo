within Analogon.Effects.Signals;
partial block PartialCelsiusGain "A temperature that is off by a factor, counted from 0 degC"
  extends Analogon.Interfaces.PartialSignal;
  parameter Real g(unit="1", min=-0.5, max=0.5) = 0 "Relative error of the gain (0: off)"
    annotation (Dialog(group="Effect"));
equation
  y = u + g*(u - 273.15);
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-80,-70},{85,-70}}, color={128,128,128}),
        Line(points={{-40,80},{-40,-80}}, color={128,128,128}),
        Line(points={{-75,-80},{60,70}}, color={0,0,127}, thickness=0.75),
        Line(points={{-80,-80},{80,10}}, color={128,128,128}, thickness=0.25, pattern=LinePattern.Dash)}),
    Documentation(info="<html>
<p>Shared by the effects of sensors and actuators. A thermometer is adjusted in ice water and amplifies what it reads in degrees Celsius, so that its error vanishes there and not at 0 K.</p>
<pre>
  y = u + g*(u - 273.15)
</pre>
</html>"));
end PartialCelsiusGain;
