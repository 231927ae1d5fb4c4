within Analogon.Effects.Signals;
partial block PartialGain "A signal that is off by a factor"
  extends Analogon.Interfaces.PartialSignal;
  parameter Real g(unit="1", min=-0.5, max=0.5) = 0 "Relative error of the gain (0: off)"
    annotation (Dialog(group="Effect"));
equation
  y = (1 + g)*u;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-80,-70},{85,-70}}, color={128,128,128}),
        Line(points={{-70,80},{-70,-80}}, color={128,128,128}),
        Line(points={{-70,-70},{60,70}}, color={0,0,127}, thickness=0.75),
        Line(points={{-70,-70},{80,20}}, color={128,128,128}, thickness=0.25, pattern=LinePattern.Dash)}),
    Documentation(info="<html>
<p>Shared by the effects of sensors and actuators.</p>
<pre>
  y = (1 + g)*u
</pre>
</html>"));
end PartialGain;
