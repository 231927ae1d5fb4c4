within Analogon.Electric;
model Ground "Ground: the potential 0"
  Analogon.Interfaces.PositivePin p "Grounded wire"
    annotation (Placement(transformation(extent={{-10,90},{10,110}})));
equation
  p.v = 0;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{0,100},{0,20}}, color={0,0,255}, thickness=0.5),
        Line(points={{-60,20},{60,20}}, color={0,0,255}, thickness=0.5),
        Line(points={{-40,-10},{40,-10}}, color={0,0,255}, thickness=0.5),
        Line(points={{-20,-40},{20,-40}}, color={0,0,255}, thickness=0.5),
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>Every circuit needs one: potentials are counted from here.</p>
<pre>
  p.v = 0
</pre>
</html>"));
end Ground;
