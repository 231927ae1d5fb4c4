within Analogon.Effects.Signals;
partial block PartialOffset "A signal that is off by a constant"
  extends Analogon.Interfaces.PartialSignal;
  parameter Real b = 0 "Offset (0: off)"
    annotation (Dialog(group="Effect"));
equation
  y = u + b;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-80,-70},{85,-70}}, color={128,128,128}),
        Line(points={{-70,80},{-70,-80}}, color={128,128,128}),
        Line(points={{-70,-40},{80,60}}, color={0,0,127}, thickness=0.75),
        Line(points={{-70,-70},{80,30}}, color={128,128,128}, thickness=0.25, pattern=LinePattern.Dash)}),
    Documentation(info="<html>
<p>Shared by the effects of sensors and actuators.</p>
<pre>
  y = u + b
</pre>
</html>"));
end PartialOffset;
