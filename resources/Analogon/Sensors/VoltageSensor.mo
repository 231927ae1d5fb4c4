within Analogon.Sensors;
model VoltageSensor "Ideal voltage sensor between two pins"
  Analogon.Interfaces.PositivePin p "Positive side"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  Analogon.Interfaces.NegativePin n "Negative side"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  Analogon.Interfaces.RealOutput v(unit="V") "Voltage from p to n"
    annotation (Placement(transformation(origin={0,-100}, extent={{-10,-10},{10,10}}, rotation=-90)));
equation
  v = p.v - n.v;
  p.i = 0;
  n.i = 0;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-100,0},{-50,0}}, color={0,0,255}, thickness=0.5),
        Line(points={{50,0},{100,0}}, color={0,0,255}, thickness=0.5),
        Line(points={{0,-50},{0,-100}}, color={0,0,127}, thickness=0.5),
        Ellipse(extent={{-50,50},{50,-50}}, lineColor={0,0,0}, fillColor={245,245,245}, fillPattern=FillPattern.Solid),
        Text(extent={{-36,30},{36,-30}}, textString="V", textColor={0,0,0}),
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>Reads the voltage between two wires and takes no current.</p>
<pre>
  v = p.v - n.v
  p.i = n.i = 0
</pre>
</html>"));
end VoltageSensor;
