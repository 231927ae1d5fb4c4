within Analogon.Effects.Translation;
model AddedMass "Further mass on the rod"
  extends Analogon.Interfaces.PartialOneTranslationalFlange;
  parameter Real m(unit="kg", min=0) = 0 "Mass (0: off)"
    annotation (Dialog(group="Effect"));
equation
  flange.f = m*der(v);
  annotation (
    __Analogon(effect(
      kind = "mass.added",
      way = "attach",
      ports = {"flange"},
      strength = "m",
      oneSided = true)),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=10),
        Line(points={{-100,0},{-50,0}}, color={0,127,0}, thickness=0.5),
        Rectangle(extent={{-50,40},{50,-40}}, lineColor={0,127,0}, fillColor={214,232,214}, fillPattern=FillPattern.Solid),
        Text(extent={{-40,24},{40,-24}}, textString="m", textColor={0,0,0})}),
    Documentation(info="<html>
<p>A mass that moves with the rod.</p>
<pre>
  flange.f = m*der(v)
</pre>
</html>"));
end AddedMass;
