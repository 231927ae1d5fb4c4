within Analogon.Thermal;
model ThermalConductor "Heat conduction between two places"
  extends PartialThermalConductor;
equation
  Q_flow = G*dT;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}})),
    Documentation(info="<html>
<p>A wall, a bond or a wire that conducts heat and stores none.</p>
<pre>
  Q_flow = G*(port_a.T - port_b.T)
  port_a.Q_flow = Q_flow,  port_b.Q_flow = -Q_flow
</pre>
</html>"));
end ThermalConductor;
