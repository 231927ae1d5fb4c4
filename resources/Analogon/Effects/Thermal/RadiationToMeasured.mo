within Analogon.Effects.Thermal;
model RadiationToMeasured "Radiation to surroundings whose temperature was recorded"
  extends Analogon.Interfaces.PartialOneHeatPort;
  Analogon.Interfaces.RealInput T_surround(unit="K") "Recorded temperature of the surroundings"
    annotation (Placement(transformation(origin={0,-100}, extent={{-20,-20},{20,20}}, rotation=90)));
  parameter Real k_r(unit="W/K4", min=0) = 0 "Net radiation conductance: emissivity times surface times the Stefan-Boltzmann constant (0: off)"
    annotation (Dialog(group="Effect"));
equation
  port.Q_flow = k_r*(T^4 - T_surround^4);
  annotation (
    __Analogon(effect(
      kind = "thermal.radiation",
      way = "attach",
      ports = {"port"},
      strength = "k_r",
      oneSided = true,
      quantity = "K",
      channel = "T_surround",
      orInput = true)),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=10),
        Line(points={{-100,0},{-60,0}}, color={191,0,0}, thickness=0.5),
        Rectangle(extent={{-60,50},{-20,-50}}, lineColor={191,0,0}, fillColor={250,224,216}, fillPattern=FillPattern.Solid),
        Line(points={{-16,-32},{-8,-23},{0,-31.9857},{8,-41},{16,-32.0287},{24,-23.0001},{32,-31.957},{40,-40.9999},{48,-32.0573},{56,-23.0002}}, color={191,0,0}, thickness=0.5, smooth=Smooth.Bezier),
        Line(points={{-16,0},{-8,9},{0,0.0143339},{8,-8.99997},{16,-0.0286677},{24,8.99993},{32,0.0430015},{40,-8.99986},{48,-0.0573351},{56,8.99977}}, color={191,0,0}, thickness=0.5, smooth=Smooth.Bezier),
        Line(points={{-16,32},{-8,41},{0,32.0143},{8,23},{16,31.9713},{24,40.9999},{32,32.043},{40,23.0001},{48,31.9427},{56,40.9998}}, color={191,0,0}, thickness=0.5, smooth=Smooth.Bezier),
        Line(points={{0,-100},{0,-90}}, color={0,0,127}, thickness=0.5)}),
    Documentation(info="<html>
<p>Heat radiated to a wall whose temperature is a recorded channel that the model does not use.</p>
<pre>
  port.Q_flow = k_r*(port.T^4 - T_surround^4)
</pre>
</html>"));
end RadiationToMeasured;
