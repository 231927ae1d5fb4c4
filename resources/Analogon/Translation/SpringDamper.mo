within Analogon.Translation;
model SpringDamper "Linear spring and damper in parallel between two translational flanges"
  extends Analogon.Interfaces.PartialTwoTranslationalFlanges;
  parameter Real c(unit="N/m", min=0) = 1e4 "Stiffness"
    annotation (Dialog(group="Parameters"));
  parameter Real d(unit="N.s/m", min=0) = 1 "Damping"
    annotation (Dialog(group="Parameters"));
  parameter Real s_rel0(unit="m") = 0 "Length of the relaxed spring"
    annotation (Dialog(group="Parameters"));
  Real s_rel(unit="m") "Distance: flange_b against flange_a";
  Real v_rel(unit="m/s") "Rate of the distance";
  Real f(unit="N") "Force of spring and damper";
equation
  s_rel = flange_b.s - flange_a.s;
  v_rel = der(s_rel);
  f = c*(s_rel - s_rel0) + d*v_rel;
  flange_b.f = f;
  flange_a.f = -f;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-100,0},{-60,0},{-60,40},{-40,40},{-30,60},{-15,20},{0,60},{15,20},{30,60},{40,40},{60,40},{60,0},{100,0}}, color={0,127,0}, thickness=0.5),
        Line(points={{-60,0},{-60,-40},{0,-40}}, color={0,127,0}, thickness=0.5),
        Line(points={{60,0},{60,-40},{20,-40}}, color={0,127,0}, thickness=0.5),
        Line(points={{40,-65},{-10,-65},{-10,-15},{40,-15}}, color={0,127,0}, thickness=0.5),
        Rectangle(extent={{0,-20},{20,-60}}, lineColor={0,127,0}, fillColor={214,232,214}, fillPattern=FillPattern.Solid),
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>A massless elastic and damped rod.</p>
<pre>
  s_rel = flange_b.s - flange_a.s
  flange_b.f = c*(s_rel - s_rel0) + d*der(s_rel)
  flange_a.f = -flange_b.f
</pre>
</html>"));
end SpringDamper;
