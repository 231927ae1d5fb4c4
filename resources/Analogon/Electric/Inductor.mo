within Analogon.Electric;
model Inductor "Inductor"
  extends Analogon.Interfaces.PartialTwoPins;
  parameter Real L(unit="H", min=0) = 1e-3 "Inductance"
    annotation (Dialog(group="Parameters"));
equation
  v = L*der(i);
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-100,0},{-60,0}}, color={0,0,255}, thickness=0.5),
        Line(points={{60,0},{100,0}}, color={0,0,255}, thickness=0.5),
        Line(points={{-60,0},{-52,24},{-38,24},{-30,0},{-22,24},{-8,24},{0,0},{8,24},{22,24},{30,0},{38,24},{52,24},{60,0}}, color={0,0,255}, thickness=0.5, smooth=Smooth.Bezier),
        Text(extent={{-100,-34},{100,-68}}, textString="L = %L", textColor={0,0,0})}),
    Documentation(info="<html>
<p>A coil without resistance or saturation.</p>
<pre>
  v = L*der(i)
</pre>
</html>"));
end Inductor;
