within Analogon.Sensors;
model SpeedSensor "Ideal speed sensor"
  Analogon.Interfaces.Flange_a flange "Shaft that is observed"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  Analogon.Interfaces.RealOutput w(unit="rad/s") "Speed of the flange"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
equation
  w = der(flange.phi);
  flange.tau = 0;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-100,0},{-70,0}}, color={95,95,95}, thickness=0.5),
        Line(points={{70,0},{100,0}}, color={0,0,127}),
        Ellipse(extent={{-70,70},{70,-70}}, lineColor={0,0,0}, fillColor={245,245,245}, fillPattern=FillPattern.Solid),
        Line(points={{0,70},{0,52}}, color={0,0,0}),
        Line(points={{50,50},{37,37}}, color={0,0,0}),
        Line(points={{-50,50},{-37,37}}, color={0,0,0}),
        Line(points={{70,0},{52,0}}, color={0,0,0}),
        Line(points={{-70,0},{-52,0}}, color={0,0,0}),
        Line(points={{0,0},{28,40}}, color={0,0,0}, thickness=0.75),
        Ellipse(extent={{-7,7},{7,-7}}, lineColor={0,0,0}, fillColor={0,0,0}, fillPattern=FillPattern.Solid),
        Text(extent={{-50,-14},{50,-50}}, textString="w", textColor={0,0,0}),
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>Reads the speed of a flange and takes no torque.</p>
<pre>
  w = der(flange.phi)
  flange.tau = 0
</pre>
</html>"));
end SpeedSensor;
