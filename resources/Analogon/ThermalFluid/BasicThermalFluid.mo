within Analogon.ThermalFluid;
model BasicThermalFluid "Body with heat capacity in a stream (convection by the fluid temperature)"
  extends PartialThermalFluid;
equation
  G_c = c_o*A*(fluid.T/3.6)^0.78;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}})),
    Documentation(info="<html>
<p>The basic class of the thermal and fluid domain: a body of uniform temperature exchanges heat with a stream. The conductance grows with the temperature of the fluid: in kelvin, it stands under the exponent.</p>
<pre>
  Q_flow = G_c*(solid.T - fluid.T)
  G_c    = c_o*A*(fluid.T/3.6)^0.78
  C*der(solid.T) = solid.Q_flow - Q_flow
  fluid.Q_flow   = -Q_flow
  solid.T(0)     = T_start
</pre>
<p>It descends from the law of Juerges, which has the speed of the stream in km/h in that place; see ConvectionByFlowSpeed. Only the product c_o*A shows in a measurement: keep one of the two.</p>
</html>"));
end BasicThermalFluid;
