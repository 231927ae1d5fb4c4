within Analogon.Thermal;
partial model PartialThermalConductor "Heat conduction between two places, without its law"
  Analogon.Interfaces.HeatPort_a port_a "One side"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  Analogon.Interfaces.HeatPort_b port_b "Other side"
    annotation (Placement(transformation(extent={{90,-10},{110,10}})));
  parameter Real G(unit="W/K", min=0) = 1 "Conductance"
    annotation (Dialog(group="Parameters"));
  Real dT(unit="K") "port_a against port_b";
  Real Q_flow(unit="W") "Heat from port_a to port_b";
equation
  dT = port_a.T - port_b.T;
  port_a.Q_flow = Q_flow;
  port_b.Q_flow = -Q_flow;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,60},{90,-60}}, lineColor={191,0,0}, fillColor={250,224,216}, fillPattern=FillPattern.Solid),
        Line(points={{-90,60},{-90,-60}}, color={191,0,0}, thickness=1),
        Line(points={{90,60},{90,-60}}, color={191,0,0}, thickness=1),
        Line(points={{-60,0},{60,0}}, color={191,0,0}, thickness=0.5, arrow={Arrow.None,Arrow.Filled}),
        Text(extent={{-80,-20},{80,-54}}, textString="G = %G", textColor={0,0,0}),
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>Base of what conducts heat and stores none. A class that extends it adds one equation for Q_flow.</p>
<pre>
  dT = port_a.T - port_b.T
  port_a.Q_flow = Q_flow,  port_b.Q_flow = -Q_flow
</pre>
</html>"));
end PartialThermalConductor;
