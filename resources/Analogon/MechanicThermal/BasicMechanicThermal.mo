within Analogon.MechanicThermal;
model BasicMechanicThermal "Bearing with viscous friction that heats"
  extends PartialMechanicThermal;
equation
  tau_f = b*w;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}})),
    Documentation(info="<html>
<p>The basic class of the mechanical and thermal domain: one rigid shaft runs through; its friction is proportional to the speed, and the loss goes to the heat port.</p>
<pre>
  phi = flange_a.phi = flange_b.phi,  w = der(phi)
  flange_a.tau + flange_b.tau = tau_f
  tau_f = b*der(phi)
  heatPort.Q_flow = -tau_f*der(phi)
</pre>
</html>"));
end BasicMechanicThermal;
