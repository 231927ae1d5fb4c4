within Analogon.Sensors;
model TorqueSensor "Ideal torque sensor between two flanges"
  extends Analogon.Interfaces.PartialTwoFlanges;
  Analogon.Interfaces.RealOutput tau(unit="N.m") "Torque from flange_a to flange_b"
    annotation (Placement(transformation(origin={0,-100}, extent={{-10,-10},{10,10}}, rotation=270)));
equation
  flange_a.phi = flange_b.phi;
  flange_a.tau + flange_b.tau = 0;
  tau = flange_a.tau;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-100,0},{-70,0}}, color={95,95,95}, thickness=0.5),
        Line(points={{70,0},{100,0}}, color={95,95,95}, thickness=0.5),
        Line(points={{0,-70},{0,-100}}, color={0,0,127}),
        Ellipse(extent={{-70,70},{70,-70}}, lineColor={0,0,0}, fillColor={245,245,245}, fillPattern=FillPattern.Solid),
        Line(points={{0,70},{0,52}}, color={0,0,0}),
        Line(points={{50,50},{37,37}}, color={0,0,0}),
        Line(points={{-50,50},{-37,37}}, color={0,0,0}),
        Line(points={{70,0},{52,0}}, color={0,0,0}),
        Line(points={{-70,0},{-52,0}}, color={0,0,0}),
        Line(points={{0,0},{28,40}}, color={0,0,0}, thickness=0.75),
        Ellipse(extent={{-7,7},{7,-7}}, lineColor={0,0,0}, fillColor={0,0,0}, fillPattern=FillPattern.Solid),
        Text(extent={{-50,-14},{50,-50}}, textString="tau", textColor={0,0,0})}),
    Documentation(info="<html>
<p>A rigid shaft that tells the torque it carries.</p>
<pre>
  flange_a.phi = flange_b.phi
  flange_a.tau + flange_b.tau = 0
  tau = flange_a.tau
</pre>
</html>"));
end TorqueSensor;
