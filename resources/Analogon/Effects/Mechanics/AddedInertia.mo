within Analogon.Effects.Mechanics;
model AddedInertia "Further inertia on the shaft"
  extends Analogon.Interfaces.PartialOneFlange;
  parameter Real J(unit="kg.m2", min=0) = 0 "Moment of inertia (0: off)"
    annotation (Dialog(group="Effect"));
equation
  flange.tau = J*der(w);
  annotation (
    __Analogon(effect(
      kind = "inertia.added",
      way = "attach",
      ports = {"flange"},
      strength = "J",
      oneSided = true)),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=10),
        Rectangle(extent={{-100,8},{-30,-8}}, lineColor={95,95,95}, fillColor={192,198,206}, fillPattern=FillPattern.Solid),
        Rectangle(extent={{-30,60},{40,-60}}, lineColor={95,95,95}, fillColor={192,198,206}, fillPattern=FillPattern.Solid, radius=8),
        Text(extent={{-30,24},{40,-24}}, textString="J", textColor={0,0,0})}),
    Documentation(info="<html>
<p>An inertia that turns with the shaft.</p>
<pre>
  flange.tau = J*der(w)
</pre>
</html>"));
end AddedInertia;
