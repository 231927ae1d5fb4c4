within Analogon.Electric;
model Switch "Switch that a signal closes"
  extends Analogon.Interfaces.PartialTwoPins;
  Analogon.Interfaces.RealInput control(unit="1") "Closed where above 0.5"
    annotation (Placement(transformation(extent={{-20,80},{20,120}})));
  parameter Real R_on(unit="Ohm", min=1e-12) = 1e-3 "Resistance of the closed switch"
    annotation (Dialog(group="Parameters"));
  parameter Real G_off(unit="S", min=0) = 1e-8 "Conductance of the open switch"
    annotation (Dialog(group="Parameters"));
equation
  i = noEvent(if control > 0.5 then 1/R_on else G_off)*v;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-100,0},{-60,0}}, color={0,0,255}, thickness=0.5),
        Line(points={{60,0},{100,0}}, color={0,0,255}, thickness=0.5),
        Line(points={{-60,0},{44,40}}, color={0,0,255}, thickness=0.5),
        Ellipse(extent={{-66,6},{-54,-6}}, lineColor={0,0,255}, fillColor={0,0,255}, fillPattern=FillPattern.Solid),
        Ellipse(extent={{54,6},{66,-6}}, lineColor={0,0,255}, fillColor={0,0,255}, fillPattern=FillPattern.Solid),
        Line(points={{0,100},{0,22}}, color={0,0,127}, thickness=0.5),
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>A switch, a transistor driven hard: closed where the signal is above 0.5.</p>
<pre>
  i = v/R_on   closed
  i = v*G_off  open
</pre>
</html>"));
end Switch;
