within Analogon.Effects.Thermal;
model Bridge "Heat exchange between places that are not neighbours"
  Analogon.Interfaces.HeatPort_a port_a "One place"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  Analogon.Interfaces.HeatPort_b port_b "Other place"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  parameter Real G(unit="W/K", min=0) = 0 "Conductance between the places (0: off)"
    annotation (Dialog(group="Effect"));
  Real dT(unit="K") "port_a against port_b";
  Real Q_flow(unit="W") "Heat from port_a to port_b";
equation
  dT = port_a.T - port_b.T;
  Q_flow = G*dT;
  port_a.Q_flow = Q_flow;
  port_b.Q_flow = -Q_flow;
  annotation (
    __Analogon(effect(
      kind = "thermal.bridge",
      way = "bridge",
      ports = {"port_a", "port_b"},
      strength = "G",
      oneSided = true)),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=10),
        Line(points={{-100,0},{-60,0}}, color={191,0,0}, thickness=0.5),
        Line(points={{60,0},{100,0}}, color={191,0,0}, thickness=0.5),
        Rectangle(extent={{-60,40},{-30,-40}}, lineColor={191,0,0}, fillColor={250,224,216}, fillPattern=FillPattern.Solid),
        Rectangle(extent={{30,40},{60,-40}}, lineColor={191,0,0}, fillColor={250,224,216}, fillPattern=FillPattern.Solid),
        Line(points={{-30,16},{30,16}}, color={191,0,0}, thickness=0.5, arrow={Arrow.None,Arrow.Filled}),
        Line(points={{30,-16},{-30,-16}}, color={191,0,0}, thickness=0.5, arrow={Arrow.None,Arrow.Filled}),
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>Heat that passes between two places that the model does not join: through a board, a housing, the air between them.</p>
<pre>
  Q_flow = G*(port_a.T - port_b.T)
  port_a.Q_flow = Q_flow,  port_b.Q_flow = -Q_flow
</pre>
</html>"));
end Bridge;
