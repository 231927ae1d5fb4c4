within Analogon.Effects.Thermal;
model LossToUnknown "Heat loss to constant surroundings of unknown temperature"
  extends Analogon.Effects.Thermal.Loss;
  annotation (
    __Analogon(effect(
      kind = "thermal.loss",
      way = "attach",
      ports = {"port"},
      strength = "G",
      oneSided = true,
      reach(T_amb = 1.4),
      shape(T_amb = {"start(T)", "minimum(T)", "maximum(T)"}))),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=10),
        Line(points={{-100,0},{-60,0}}, color={191,0,0}, thickness=0.5),
        Rectangle(extent={{-60,50},{-20,-50}}, lineColor={191,0,0}, fillColor={250,224,216}, fillPattern=FillPattern.Solid),
        Line(points={{-20,-30},{60,-30}}, color={191,0,0}, thickness=0.5, arrow={Arrow.None,Arrow.Filled}),
        Line(points={{-20,0},{60,0}}, color={191,0,0}, thickness=0.5, arrow={Arrow.None,Arrow.Filled}),
        Line(points={{-20,30},{60,30}}, color={191,0,0}, thickness=0.5, arrow={Arrow.None,Arrow.Filled}),
        Text(extent={{60,-50},{88,-88}}, textString="?", textColor={213,94,0})}),
    Documentation(info="<html>
<p>Conduction or convection to surroundings at a constant temperature that is fitted, too: a climate chamber, a cold
start, the air around a hot engine.</p>
<pre>
  port.Q_flow = G*(port.T - T_amb)
</pre>
</html>"));
end LossToUnknown;
