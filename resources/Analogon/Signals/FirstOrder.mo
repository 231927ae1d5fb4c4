within Analogon.Signals;
block FirstOrder "First-order lag"
  extends Analogon.Interfaces.PartialSignal;
  parameter Real T(unit="s", min=0) = 1 "Time constant"
    annotation (Dialog(group="Parameters"));
equation
  T*der(y) = u - y;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-80,80},{-80,-80},{85,-80}}, color={128,128,128}),
        Line(points={{-80,-80},{-68,-36},{-52,4},{-30,38},{0,58},{40,68},{80,70}}, color={0,0,127}, thickness=0.75, smooth=Smooth.Bezier),
        Text(extent={{-30,-10},{90,-50}}, textString="T = %T s", textColor={0,0,0})}),
    Documentation(info="<html>
<p>The output follows the input with the time constant T; it starts at 0.</p>
<pre>
  T*der(y) = u - y
</pre>
</html>"));
end FirstOrder;
