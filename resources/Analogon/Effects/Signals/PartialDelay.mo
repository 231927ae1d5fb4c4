within Analogon.Effects.Signals;
partial block PartialDelay "A signal that comes late by a dead time"
  extends Analogon.Interfaces.PartialSignal;
  parameter Real T(unit="s", min=0) = 0 "Dead time (0: off)"
    annotation (Dialog(group="Effect"));
equation
  y = delay(u, T);
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-80,-70},{85,-70}}, color={128,128,128}),
        Line(points={{-70,80},{-70,-80}}, color={128,128,128}),
        Line(points={{-70,-70},{-20,-70},{-20,50},{80,50}}, color={0,0,127}, thickness=0.75),
        Line(points={{-70,-20},{-24,-20}}, color={213,94,0}, thickness=0.5, arrow={Arrow.None,Arrow.Filled})}),
    Documentation(info="<html>
<p>Shared by the effects of sensors and actuators.</p>
<pre>
  y(t) = u(t - T)
</pre>
</html>"));
end PartialDelay;
