within Analogon.Sensors;
model CurrentSensor "Ideal current sensor in a wire"
  Analogon.Interfaces.PositivePin p "Side into which the current counts"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  Analogon.Interfaces.NegativePin n "Other side"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  Analogon.Interfaces.RealOutput i(unit="A") "Current from p to n"
    annotation (Placement(transformation(origin={0,-100}, extent={{-10,-10},{10,10}}, rotation=-90)));
equation
  p.v = n.v;
  p.i + n.i = 0;
  i = p.i;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-100,0},{-50,0}}, color={0,0,255}, thickness=0.5),
        Line(points={{50,0},{100,0}}, color={0,0,255}, thickness=0.5),
        Line(points={{0,-50},{0,-100}}, color={0,0,127}, thickness=0.5),
        Ellipse(extent={{-50,50},{50,-50}}, lineColor={0,0,0}, fillColor={245,245,245}, fillPattern=FillPattern.Solid),
        Text(extent={{-36,30},{36,-30}}, textString="A", textColor={0,0,0}),
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>Passes the current on without a drop and tells it.</p>
<pre>
  p.v = n.v
  i = p.i = -n.i
</pre>
</html>"));
end CurrentSensor;
