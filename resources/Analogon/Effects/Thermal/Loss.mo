within Analogon.Effects.Thermal;
model Loss "Heat loss to constant surroundings"
  extends Analogon.Interfaces.PartialOneHeatPort;
  parameter Real G(unit="W/K", min=0) = 0 "Conductance to the surroundings (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real T_amb(unit="K", displayUnit="degC", min=0) = 293.15 "Temperature of the surroundings"
    annotation (Dialog(group="Effect"));
equation
  port.Q_flow = G*(T - T_amb);
  annotation (
    __Analogon(effect(
      kind = "thermal.loss",
      way = "attach",
      ports = {"port"},
      strength = "G",
      oneSided = true)),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=10),
        Line(points={{-100,0},{-60,0}}, color={191,0,0}, thickness=0.5),
        Rectangle(extent={{-60,50},{-20,-50}}, lineColor={191,0,0}, fillColor={250,224,216}, fillPattern=FillPattern.Solid),
        Line(points={{-20,-30},{60,-30}}, color={191,0,0}, thickness=0.5, arrow={Arrow.None,Arrow.Filled}),
        Line(points={{-20,0},{60,0}}, color={191,0,0}, thickness=0.5, arrow={Arrow.None,Arrow.Filled}),
        Line(points={{-20,30},{60,30}}, color={191,0,0}, thickness=0.5, arrow={Arrow.None,Arrow.Filled})}),
    Documentation(info="<html>
<p>Conduction or convection to surroundings at the constant temperature T_amb.</p>
<pre>
  port.Q_flow = G*(port.T - T_amb)
</pre>
</html>"));
end Loss;
