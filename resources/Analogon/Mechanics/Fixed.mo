within Analogon.Mechanics;
model Fixed "Flange held at a fixed angle"
  Analogon.Interfaces.Flange_b flange "Held flange"
    annotation (Placement(transformation(extent={{-10,-10},{10,10}})));
  parameter Real phi0(unit="rad") = 0 "Angle"
    annotation (Dialog(group="Parameters"));
equation
  flange.phi = phi0;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-80,-40},{80,-40}}, color={95,95,95}, thickness=0.5),
        Line(points={{0,-40},{0,-10}}, color={95,95,95}, thickness=0.5),
        Line(points={{-80,-80},{-40,-40}}, color={95,95,95}, thickness=0.5),
        Line(points={{-40,-80},{0,-40}}, color={95,95,95}, thickness=0.5),
        Line(points={{0,-80},{40,-40}}, color={95,95,95}, thickness=0.5),
        Line(points={{40,-80},{80,-40}}, color={95,95,95}, thickness=0.5),
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>The housing: the flange does not turn.</p>
<pre>
  flange.phi = phi0
</pre>
</html>"));
end Fixed;
