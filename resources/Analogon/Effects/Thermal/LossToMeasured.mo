within Analogon.Effects.Thermal;
model LossToMeasured "Heat loss to surroundings whose temperature was recorded"
  extends Analogon.Interfaces.PartialOneHeatPort;
  Analogon.Interfaces.RealInput T_surround(unit="K") "Recorded temperature of the surroundings"
    annotation (Placement(transformation(origin={0,-100}, extent={{-20,-20},{20,20}}, rotation=90)));
  parameter Real G(unit="W/K", min=0) = 0 "Conductance to the surroundings (0: off)"
    annotation (Dialog(group="Effect"));
equation
  port.Q_flow = G*(T - T_surround);
  annotation (
    __Analogon(effect(
      kind = "thermal.loss",
      way = "attach",
      ports = {"port"},
      strength = "G",
      oneSided = true,
      quantity = "K",
      channel = "T_surround",
      orInput = true)),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=10),
        Line(points={{-100,0},{-60,0}}, color={191,0,0}, thickness=0.5),
        Rectangle(extent={{-60,50},{-20,-50}}, lineColor={191,0,0}, fillColor={250,224,216}, fillPattern=FillPattern.Solid),
        Line(points={{-20,-30},{60,-30}}, color={191,0,0}, thickness=0.5, arrow={Arrow.None,Arrow.Filled}),
        Line(points={{-20,0},{60,0}}, color={191,0,0}, thickness=0.5, arrow={Arrow.None,Arrow.Filled}),
        Line(points={{-20,30},{60,30}}, color={191,0,0}, thickness=0.5, arrow={Arrow.None,Arrow.Filled}),
        Line(points={{0,-100},{0,-90}}, color={0,0,127}, thickness=0.5)}),
    Documentation(info="<html>
<p>Conduction or convection to surroundings whose temperature is a recorded channel that the model does not use.</p>
<pre>
  port.Q_flow = G*(port.T - T_surround)
</pre>
</html>"));
end LossToMeasured;
