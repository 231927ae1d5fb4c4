within Analogon.Interfaces;
partial model PartialOneTranslationalFlange "One translational flange with its position and velocity"
  Analogon.Interfaces.TranslationalFlange_a flange "Rod on which the component acts"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  Real s(unit="m") "Position of the flange";
  Real v(unit="m/s") "Velocity of the flange";
equation
  s = flange.s;
  v = der(s);
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-100,0},{-60,0}}, color={0,127,0}, thickness=0.5),
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>Base of effects that act on a rod. A class that extends it adds one equation for flange.f.</p>
<pre>
  s = flange.s
  v = der(s)
</pre>
</html>"));
end PartialOneTranslationalFlange;
