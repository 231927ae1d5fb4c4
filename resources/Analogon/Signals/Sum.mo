within Analogon.Signals;
block Sum "Sum of two signals"
  Analogon.Interfaces.RealInput u1 "First signal in"
    annotation (Placement(transformation(extent={{-120,40},{-80,80}})));
  Analogon.Interfaces.RealInput u2 "Second signal in"
    annotation (Placement(transformation(extent={{-120,-80},{-80,-40}})));
  Analogon.Interfaces.RealOutput y "Signal out"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
equation
  y = u1 + u2;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-100,100},{100,-100}}, lineColor={0,0,127}, fillColor={255,255,255}, fillPattern=FillPattern.Solid),
        Line(points={{-100,60},{-60,60},{-34,26}}, color={0,0,127}),
        Line(points={{-100,-60},{-60,-60},{-34,-26}}, color={0,0,127}),
        Ellipse(extent={{-44,44},{44,-44}}, lineColor={0,0,127}, fillColor={255,255,255}, fillPattern=FillPattern.Solid),
        Text(extent={{-36,36},{36,-36}}, textString="+", textColor={0,0,127}),
        Line(points={{44,0},{100,0}}, color={0,0,127}),
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>Sum of two signals.</p>
<pre>
  y = u1 + u2
</pre>
</html>"));
end Sum;
