within Analogon.Electric;
model EMF "Electromechanical conversion: voltage by speed, torque by current"
  extends Analogon.Interfaces.PartialTwoPins;
  Analogon.Interfaces.Flange_b flange "Shaft"
    annotation (Placement(transformation(extent={{-10,90},{10,110}})));
  parameter Real k(unit="N.m/A") = 0.05 "Torque per current, which is voltage per speed"
    annotation (Dialog(group="Parameters"));
  Real w(unit="rad/s") "Speed of the shaft";
equation
  w = der(flange.phi);
  v = k*w;
  flange.tau = -k*i;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-100,0},{-50,0}}, color={0,0,255}, thickness=0.5),
        Line(points={{50,0},{100,0}}, color={0,0,255}, thickness=0.5),
        Line(points={{0,50},{0,100}}, color={95,95,95}, thickness=0.5),
        Ellipse(extent={{-50,50},{50,-50}}, lineColor={0,0,255}, fillColor={255,255,255}, fillPattern=FillPattern.Solid),
        Text(extent={{-40,30},{40,-30}}, textString="k", textColor={0,0,0}),
        Text(extent={{-150,-60},{150,-100}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>The ideal part of a direct-current machine; resistance, inductance and inertia are blocks of their own. The housing takes the reaction.</p>
<pre>
  v = k*der(flange.phi)
  flange.tau = -k*i
</pre>
</html>"));
end EMF;
