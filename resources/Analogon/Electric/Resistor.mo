within Analogon.Electric;
model Resistor "Resistor"
  extends Analogon.Interfaces.PartialTwoPins;
  parameter Real R(unit="Ohm", min=0) = 1 "Resistance"
    annotation (Dialog(group="Parameters"));
equation
  v = R*i;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-100,0},{-60,0}}, color={0,0,255}, thickness=0.5),
        Line(points={{60,0},{100,0}}, color={0,0,255}, thickness=0.5),
        Rectangle(extent={{-60,24},{60,-24}}, lineColor={0,0,255}, fillColor={255,255,255}, fillPattern=FillPattern.Solid),
        Text(extent={{-100,-34},{100,-68}}, textString="R = %R", textColor={0,0,0})}),
    Documentation(info="<html>
<p>A resistor at a constant temperature.</p>
<pre>
  v = R*i
</pre>
</html>"));
end Resistor;
