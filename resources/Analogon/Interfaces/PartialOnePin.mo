within Analogon.Interfaces;
partial model PartialOnePin "One pin with its potential"
  Analogon.Interfaces.PositivePin pin "Wire on which the component acts"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  Real v(unit="V") "Potential of the pin against ground";
equation
  v = pin.v;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-100,0},{-60,0}}, color={0,0,255}, thickness=0.5),
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>Base of effects between a wire and ground. A class that extends it adds one equation for pin.i.</p>
<pre>
  v = pin.v
</pre>
</html>"));
end PartialOnePin;
