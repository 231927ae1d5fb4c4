within Analogon.Effects.Thermal;
model Resistance "Thermal contact resistance"
  Analogon.Interfaces.HeatPort_a port_a "One side"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  Analogon.Interfaces.HeatPort_b port_b "Other side"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  parameter Real R_th(unit="K/W", min=0) = 0 "Resistance 1/G (0: none)"
    annotation (Dialog(group="Effect"));
  final parameter Real G(unit="W/K") = if R_th > 0 then 1/R_th else 0 "Conductance 1/R_th (0 while there is no resistance)";
  Real dT(unit="K") "port_a against port_b";
  Real Q_flow(unit="W") "Heat from port_a to port_b";
  Real T(unit="K", displayUnit="degC", start=293.15, nominal=300) "Temperature of port_a";
equation
  T = port_a.T;
  dT = port_a.T - port_b.T;
  dT = R_th*Q_flow;
  port_a.Q_flow = Q_flow;
  port_b.Q_flow = -Q_flow;
  annotation (
    __Analogon(effect(
      kind = "thermal.resistance",
      way = "insert",
      ports = {"port_a", "port_b"},
      strength = "R_th",
      oneSided = true,
      secant = {"0.03*range(T)/maxabs(Q_flow)", "0.2*range(T)/maxabs(Q_flow)"})),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=10),
        Line(points={{-100,0},{-50,0}}, color={191,0,0}, thickness=0.5),
        Line(points={{50,0},{100,0}}, color={191,0,0}, thickness=0.5),
        Rectangle(extent={{-50,24},{50,-24}}, lineColor={191,0,0}, fillColor={250,224,216}, fillPattern=FillPattern.Solid),
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>A joint, a gap or a layer that heat must pass and that stores none.</p>
<pre>
  port_a.T - port_b.T = R_th*port_a.Q_flow
  port_b.Q_flow = -port_a.Q_flow
</pre>
</html>"));
end Resistance;
