within Analogon.ElectricThermal;
model BasicElectricThermal "Heating resistor whose resistance rises with its temperature"
  extends PartialElectricThermal;
equation
  v = R_T*i;
  heatPort.Q_flow = -R_T*i^2;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}})),
    Documentation(info="<html>
<p>The basic class of the electrical and thermal domain: a resistor with a linear temperature coefficient gives all its loss to the heat port.</p>
<pre>
  R_T = R*(1 + alpha*(heatPort.T - T_ref))
  v = R_T*i
  heatPort.Q_flow = -R_T*i^2
</pre>
</html>"));
end BasicElectricThermal;
