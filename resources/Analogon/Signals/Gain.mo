within Analogon.Signals;
block Gain "Signal times a constant"
  Analogon.Interfaces.RealInput u "Signal in"
    annotation (Placement(transformation(extent={{-120,-20},{-80,20}})));
  Analogon.Interfaces.RealOutput y "Signal out"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  parameter Real k = 1 "Factor, in the unit of y over u"
    annotation (Dialog(group="Parameters"));
equation
  y = k*u;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Polygon(points={{-100,-100},{-100,100},{100,0}}, lineColor={0,0,127}, fillColor={255,255,255}, fillPattern=FillPattern.Solid),
        Text(extent={{-90,24},{50,-24}}, textString="%k", textColor={0,0,0}),
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>Multiplies by a constant.</p>
<pre>
  y = k*u
</pre>
</html>"));
end Gain;
