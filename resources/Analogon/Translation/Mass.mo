within Analogon.Translation;
model Mass "Rigid body that slides"
  extends Analogon.Interfaces.PartialTwoTranslationalFlanges;
  parameter Real m(unit="kg", min=0) = 1 "Mass"
    annotation (Dialog(group="Parameters"));
  Real s(unit="m") "Position";
  Real v(unit="m/s") "Velocity";
  Real a(unit="m/s2") "Acceleration";
equation
  s = flange_a.s;
  s = flange_b.s;
  v = der(s);
  a = der(v);
  m*a = flange_a.f + flange_b.f;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-100,0},{-60,0}}, color={0,127,0}, thickness=0.5),
        Line(points={{60,0},{100,0}}, color={0,127,0}, thickness=0.5),
        Rectangle(extent={{-60,40},{60,-40}}, lineColor={0,127,0}, fillColor={214,232,214}, fillPattern=FillPattern.Solid),
        Text(extent={{-100,-50},{100,-84}}, textString="m = %m", textColor={0,0,0})}),
    Documentation(info="<html>
<p>A mass on a rigid rod; both flanges are the same place.</p>
<pre>
  s = flange_a.s = flange_b.s
  v = der(s),  a = der(v)
  m*a = flange_a.f + flange_b.f
</pre>
</html>"));
end Mass;
