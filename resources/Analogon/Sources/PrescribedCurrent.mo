within Analogon.Sources;
model PrescribedCurrent "Imposes a current given by a signal"
  Analogon.Interfaces.PositivePin p "Positive side"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  Analogon.Interfaces.NegativePin n "Negative side"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  Analogon.Interfaces.RealInput i(unit="A") "Current from p to n through the source"
    annotation (Placement(transformation(extent={{-20,80},{20,120}})));
  Real v(unit="V") "Voltage from p to n";
equation
  v = p.v - n.v;
  p.i = i;
  p.i + n.i = 0;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-100,0},{-50,0}}, color={0,0,255}, thickness=0.5),
        Line(points={{50,0},{100,0}}, color={0,0,255}, thickness=0.5),
        Ellipse(extent={{-50,50},{50,-50}}, lineColor={0,0,255}, fillColor={255,255,255}, fillPattern=FillPattern.Solid),
        Line(points={{0,50},{0,-50}}, color={0,0,255}, thickness=0.5),
        Line(points={{0,100},{0,50}}, color={0,0,127}, thickness=0.5),
        Line(points={{-80,24},{-60,24}}, color={0,0,255}, thickness=0.5, arrow={Arrow.None,Arrow.Filled}),
        Text(extent={{-150,-60},{150,-100}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>An ideal source of current: i at any voltage, from p to n through the source.</p>
<pre>
  p.i = i
  p.i + n.i = 0
</pre>
</html>"));
end PrescribedCurrent;
