within Analogon.Translation;
model Rack "Ideal rack and pinion, or spindle"
  Analogon.Interfaces.Flange_a flange_a "Shaft of the pinion"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  Analogon.Interfaces.TranslationalFlange_b flange_b "Rack"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  parameter Real r(unit="m/rad") = 0.01 "Travel per angle (radius of the pinion; pitch/(2*pi) of a spindle)"
    annotation (Dialog(group="Parameters"));
equation
  flange_b.s = r*flange_a.phi;
  flange_a.tau + r*flange_b.f = 0;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-100,0},{-70,0}}, color={95,95,95}, thickness=0.5),
        Ellipse(extent={{-70,60},{10,-20}}, lineColor={95,95,95}, fillColor={192,198,206}, fillPattern=FillPattern.Solid),
        Rectangle(extent={{-80,-24},{80,-50}}, lineColor={0,127,0}, fillColor={214,232,214}, fillPattern=FillPattern.Solid),
        Line(points={{80,-37},{100,-37},{100,0}}, color={0,127,0}, thickness=0.5),
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>Joins a shaft and a rod without mass, loss or play.</p>
<pre>
  flange_b.s = r*flange_a.phi
  flange_a.tau + r*flange_b.f = 0
</pre>
</html>"));
end Rack;
