within Analogon.Sources;
model PrescribedForce "Imposes a force given by a signal"
  Analogon.Interfaces.RealInput f(unit="N") "Force to give out"
    annotation (Placement(transformation(extent={{-120,-20},{-80,20}})));
  Analogon.Interfaces.TranslationalFlange_b flange "Rod that is driven"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
equation
  flange.f = -f;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-100,0},{-70,0}}, color={0,0,127}, thickness=0.5),
        Rectangle(extent={{-70,14},{40,-14}}, lineColor={0,127,0}, fillColor={214,232,214}, fillPattern=FillPattern.Solid),
        Polygon(points={{40,36},{90,0},{40,-36}}, lineColor={0,127,0}, fillColor={214,232,214}, fillPattern=FillPattern.Solid),
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>Drives the rod with the force f, at any velocity; the housing takes the reaction.</p>
<pre>
  flange.f = -f
</pre>
</html>"));
end PrescribedForce;
