within Analogon.Effects.Thermal;
model RadiationToUnknown "Radiation to constant surroundings of unknown temperature"
  extends Analogon.Effects.Thermal.Radiation;
  annotation (
    __Analogon(effect(
      kind = "thermal.radiation",
      way = "attach",
      ports = {"port"},
      strength = "k_r",
      oneSided = true,
      reach(T_amb = 1.4),
      shape(T_amb = {"start(T)", "minimum(T)", "maximum(T)"}))),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=10),
        Line(points={{-100,0},{-60,0}}, color={191,0,0}, thickness=0.5),
        Rectangle(extent={{-60,50},{-20,-50}}, lineColor={191,0,0}, fillColor={250,224,216}, fillPattern=FillPattern.Solid),
        Line(points={{-16,-32},{-8,-23},{0,-31.9857},{8,-41},{16,-32.0287},{24,-23.0001},{32,-31.957},{40,-40.9999},{48,-32.0573},{56,-23.0002}}, color={191,0,0}, thickness=0.5, smooth=Smooth.Bezier),
        Line(points={{-16,0},{-8,9},{0,0.0143339},{8,-8.99997},{16,-0.0286677},{24,8.99993},{32,0.0430015},{40,-8.99986},{48,-0.0573351},{56,8.99977}}, color={191,0,0}, thickness=0.5, smooth=Smooth.Bezier),
        Line(points={{-16,32},{-8,41},{0,32.0143},{8,23},{16,31.9713},{24,40.9999},{32,32.043},{40,23.0001},{48,31.9427},{56,40.9998}}, color={191,0,0}, thickness=0.5, smooth=Smooth.Bezier),
        Text(extent={{60,-50},{88,-88}}, textString="?", textColor={213,94,0})}),
    Documentation(info="<html>
<p>Heat radiated to surroundings at a constant temperature that is fitted, too.</p>
<pre>
  port.Q_flow = k_r*(port.T^4 - T_amb^4)
</pre>
</html>"));
end RadiationToUnknown;
