within Analogon.Mechanics;
model ReturnSpring "Spring between shaft and housing"
  Analogon.Interfaces.Flange_a flange "Shaft"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  parameter Real c_r(unit="N.m/rad", min=0) = 1 "Stiffness"
    annotation (Dialog(group="Parameters"));
  parameter Real phi_r(unit="rad") = 0 "Angle at which the spring is relaxed"
    annotation (Dialog(group="Parameters"));
  Real phi_rel(unit="rad") "Twist of the spring";
equation
  phi_rel = flange.phi - phi_r;
  flange.tau = c_r*phi_rel;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-100,0},{-60,0},{-50,30},{-30,-30},{-10,30},{10,-30},{30,30},{40,0},{60,0}}, color={95,95,95}, thickness=0.5),
        Line(points={{60,-60},{60,60}}, color={95,95,95}, thickness=0.5),
        Line(points={{60,-60},{85,-40}}, color={95,95,95}, thickness=0.25),
        Line(points={{60,-30},{85,-10}}, color={95,95,95}, thickness=0.25),
        Line(points={{60,0},{85,20}}, color={95,95,95}, thickness=0.25),
        Line(points={{60,30},{85,50}}, color={95,95,95}, thickness=0.25),
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255}),
        Text(extent={{-100,-64},{100,-96}}, textString="c_r = %c_r", textColor={0,0,0})}),
    Documentation(info="<html>
<p>The return spring of a flap or throttle plate.</p>
<pre>
  flange.tau = c_r*(flange.phi - phi_r)
</pre>
</html>"));
end ReturnSpring;
