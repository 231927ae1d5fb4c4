within Analogon.ThermalFluid;
model BasicThermalFluid "Body with heat capacity in a stream (convection by the fluid temperature, eq. 8)"
  extends PartialThermalFluid;
equation
  G_c = c_o*A*(fluid.T/3.6)^0.78;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}})),
    Documentation(info="<html>
<p>The basic class of the thermal and fluid domain: a body of uniform temperature exchanges heat with a stream. The conductance follows eq. 8 of the paper as printed, with the fluid temperature in kelvin under the exponent.</p>
<pre>
  Q_flow = G_c*(solid.T - fluid.T)
  G_c    = c_o*A*(fluid.T/3.6)^0.78                    (eq. 8)
  C*der(solid.T) = solid.Q_flow - Q_flow
  fluid.Q_flow   = -Q_flow
  solid.T(0)     = T_start
</pre>
<p>Eq. 8 descends from a law for the speed of the stream in km/h; see ConvectionByFlowSpeed. Only the product c_o*A shows in a measurement: keep one of the two.</p>
</html>"));
end BasicThermalFluid;
