within Analogon.Electric;
model Diode "Diode with an exponential characteristic"
  extends Analogon.Interfaces.PartialTwoPins;
  parameter Real I_s(unit="A", min=1e-30) = 1e-9 "Saturation current"
    annotation (Dialog(group="Parameters"));
  parameter Real V_t(unit="V", min=1e-6) = 0.04 "Emission coefficient times thermal voltage"
    annotation (Dialog(group="Parameters"));
  parameter Real R_p(unit="Ohm", min=1) = 1e8 "Resistance in parallel"
    annotation (Dialog(group="Parameters"));
  Real x(unit="1") "v/V_t, up to where the exponential goes on as its tangent";
equation
  x = noEvent(min(v/V_t, 40));
  i = I_s*(exp(x)*(1 + v/V_t - x) - 1) + v/R_p;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-100,0},{-60,0}}, color={0,0,255}, thickness=0.5),
        Line(points={{60,0},{100,0}}, color={0,0,255}, thickness=0.5),
        Line(points={{-60,0},{60,0}}, color={0,0,255}, thickness=0.5),
        Polygon(points={{-35,40},{-35,-40},{35,0}}, lineColor={0,0,255}, fillColor={255,255,255}, fillPattern=FillPattern.Solid),
        Line(points={{35,40},{35,-40}}, color={0,0,255}, thickness=0.75),
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>Conducts from p to n. The characteristic has a slope everywhere, so that its parameters can be fitted.</p>
<pre>
  i = I_s*(exp(v/V_t) - 1) + v/R_p
</pre>
<p>Beyond v = 40*V_t the exponential goes on as its tangent.</p>
</html>"));
end Diode;
