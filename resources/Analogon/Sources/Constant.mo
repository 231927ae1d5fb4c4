within Analogon.Sources;
block Constant "A constant signal"
  Analogon.Interfaces.RealOutput y "Signal"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  parameter Real k = 1 "Value, in the unit of what is connected"
    annotation (Dialog(group="Parameters"));
equation
  y = k;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-100,100},{100,-100}}, lineColor={0,0,127}, fillColor={255,255,255}, fillPattern=FillPattern.Solid),
        Line(points={{-70,70},{-70,-70},{80,-70}}, color={128,128,128}),
        Line(points={{-70,20},{70,20}}, color={0,0,127}, thickness=0.75),
        Text(extent={{-80,-20},{90,-60}}, textString="k = %k", textColor={0,0,0}),
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>Gives out the same value at all times.</p>
<pre>
  y = k
</pre>
</html>"));
end Constant;
