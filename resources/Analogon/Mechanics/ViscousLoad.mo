within Analogon.Mechanics;
model ViscousLoad "Load torque proportional to the speed"
  extends Analogon.Interfaces.PartialOneFlange;
  parameter Real b(unit="N.m.s/rad", min=0) = 1e-3 "Torque per speed"
    annotation (Dialog(group="Parameters"));
equation
  flange.tau = b*w;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-60,0},{10,0}}, color={95,95,95}, thickness=0.5),
        Rectangle(extent={{-10,30},{10,-30}}, lineColor={95,95,95}, fillColor={192,198,206}, fillPattern=FillPattern.Solid),
        Line(points={{50,45},{-40,45},{-40,-45},{50,-45}}, color={95,95,95}, thickness=0.5),
        Line(points={{50,-70},{50,70}}, color={95,95,95}, thickness=0.5),
        Text(extent={{-100,-74},{100,-100}}, textString="b = %b", textColor={0,0,0})}),
    Documentation(info="<html>
<p>A damper between shaft and housing.</p>
<pre>
  flange.tau = b*w
</pre>
</html>"));
end ViscousLoad;
