within Analogon.Effects.Signals;
partial block PartialLag "A signal that lags by one pole"
  extends Analogon.Interfaces.PartialSignal;
  parameter Real T(unit="s", min=0) = 0 "Time constant (0: off)"
    annotation (Dialog(group="Effect"));
initial equation
  y = u;
equation
  T*der(y) = u - y;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-80,-70},{85,-70}}, color={128,128,128}),
        Line(points={{-70,80},{-70,-80}}, color={128,128,128}),
        Line(points={{-70,-70},{-60,-30},{-44,4},{-24,30},{8,48},{40,56},{80,58}}, color={0,0,127}, thickness=0.75, smooth=Smooth.Bezier)}),
    Documentation(info="<html>
<p>Shared by the effects of sensors and actuators.</p>
<pre>
  T*der(y) = u - y,  y(0) = u(0)
</pre>
</html>"));
end PartialLag;
