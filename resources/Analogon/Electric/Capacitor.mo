within Analogon.Electric;
model Capacitor "Capacitor"
  extends Analogon.Interfaces.PartialTwoPins;
  parameter Real C(unit="F", min=0) = 1e-6 "Capacitance"
    annotation (Dialog(group="Parameters"));
equation
  i = C*der(v);
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{-100,0},{-12,0}}, color={0,0,255}, thickness=0.5),
        Line(points={{12,0},{100,0}}, color={0,0,255}, thickness=0.5),
        Line(points={{-12,40},{-12,-40}}, color={0,0,255}, thickness=1),
        Line(points={{12,40},{12,-40}}, color={0,0,255}, thickness=1),
        Text(extent={{-100,-50},{100,-84}}, textString="C = %C", textColor={0,0,0})}),
    Documentation(info="<html>
<p>A capacitor.</p>
<pre>
  i = C*der(v)
</pre>
</html>"));
end Capacitor;
