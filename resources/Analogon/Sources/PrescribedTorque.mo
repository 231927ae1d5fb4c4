within Analogon.Sources;
model PrescribedTorque "Imposes a torque given by a signal"
  Analogon.Interfaces.RealInput tau(unit="N.m") "Torque to give out"
    annotation (Placement(transformation(extent={{-120,-20},{-80,20}})));
  Analogon.Interfaces.Flange_b flange "Shaft that is driven"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
equation
  flange.tau = -tau;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-100,0},{-70,0}}, color={0,0,127}),
        Line(points={{-70,-30},{-50,30},{0,58},{50,30},{64,4}}, color={95,95,95}, thickness=1, smooth=Smooth.Bezier),
        Polygon(points={{78,22},{64,-16},{48,16}}, lineColor={95,95,95}, fillColor={95,95,95}, fillPattern=FillPattern.Solid),
        Line(points={{70,0},{100,0}}, color={95,95,95}, thickness=0.5),
        Text(extent={{-60,0},{40,-60}}, textString="tau", textColor={95,95,95}),
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>Drives the shaft with the torque tau, at any speed; the housing takes the reaction.</p>
<pre>
  flange.tau = -tau
</pre>
</html>"));
end PrescribedTorque;
