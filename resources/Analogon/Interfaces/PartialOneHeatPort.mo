within Analogon.Interfaces;
partial model PartialOneHeatPort "One heat port"
  Analogon.Interfaces.HeatPort_a port "Place at which heat is exchanged"
    annotation (Placement(transformation(extent={{-110,-10},{-90,10}})));
  Real T(unit="K", displayUnit="degC", start=293.15, nominal=300) "Temperature of the port";
equation
  T = port.T;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Text(extent={{-150,150},{150,110}}, textString="%name", textColor={0,0,255})}),
    Documentation(info="<html>
<p>Base of effects that take heat from one place. A class that extends it adds one equation for port.Q_flow.</p>
<pre>
  T = port.T
</pre>
</html>"));
end PartialOneHeatPort;
