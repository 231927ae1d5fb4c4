within Analogon.Sensors;
model VelocitySensor "Ideal velocity sensor"
  Analogon.Interfaces.TranslationalFlange_a flange "Rod that is observed"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  Analogon.Interfaces.RealOutput v(unit="m/s") "Velocity of the flange"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
equation
  v = der(flange.s);
  flange.f = 0;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-100,0},{-50,0}}, color={0,127,0}, thickness=0.5),
        Line(points={{50,0},{100,0}}, color={0,0,127}, thickness=0.5),
        Ellipse(extent={{-50,50},{50,-50}}, lineColor={0,0,0}, fillColor={245,245,245}, fillPattern=FillPattern.Solid),
        Text(extent={{-36,30},{36,-30}}, textString="v", textColor={0,0,0}),
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>Reads the velocity of a flange and takes no force.</p>
<pre>
  v = der(flange.s)
  flange.f = 0
</pre>
</html>"));
end VelocitySensor;
