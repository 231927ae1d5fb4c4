within Analogon.Translation;
model Fixed "Flange held at a fixed position"
  Analogon.Interfaces.TranslationalFlange_b flange "Held flange"
    annotation (Placement(transformation(extent={{-10,-10},{10,10}})));
  parameter Real s0(unit="m") = 0 "Position"
    annotation (Dialog(group="Parameters"));
equation
  flange.s = s0;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-80,-40},{80,-40}}, color={0,127,0}, thickness=0.5),
        Line(points={{0,-40},{0,-10}}, color={0,127,0}, thickness=0.5),
        Line(points={{-80,-80},{-40,-40}}, color={0,127,0}, thickness=0.5),
        Line(points={{-40,-80},{0,-40}}, color={0,127,0}, thickness=0.5),
        Line(points={{0,-80},{40,-40}}, color={0,127,0}, thickness=0.5),
        Line(points={{40,-80},{80,-40}}, color={0,127,0}, thickness=0.5),
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>The housing: the flange does not move.</p>
<pre>
  flange.s = s0
</pre>
</html>"));
end Fixed;
