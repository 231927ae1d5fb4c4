within Analogon.Interfaces;
partial model PartialOneFlange "One flange with its angle and speed"
  Analogon.Interfaces.Flange_a flange "Shaft on which the component acts"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  Real phi(unit="rad") "Angle of the flange";
  Real w(unit="rad/s") "Speed of the flange";
equation
  phi = flange.phi;
  w = der(phi);
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-100,0},{-60,0}}, color={95,95,95}, thickness=0.5),
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>Base of loads and of effects that act on a shaft. A class that extends it adds one equation for flange.tau.</p>
<pre>
  phi = flange.phi
  w = der(phi)
</pre>
</html>"));
end PartialOneFlange;
