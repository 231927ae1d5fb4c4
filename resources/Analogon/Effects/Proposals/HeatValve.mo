within Analogon.Effects.Proposals;
model HeatValve "Loss that sets in above a temperature"
  extends Analogon.Interfaces.PartialOneHeatPort;
  parameter Real a(unit="W/K", min=0) = 0 "Conductance beyond (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real T_o(unit="K", min=0) = 300 "Temperature where it sets in"
    annotation (Dialog(group="Effect"));
  parameter Real T_e(unit="K", min=1e-9) = 0.1 "Rounding of the onset"
    annotation (Dialog(group="Effect"));
equation
  port.Q_flow = 0.5*a*(port.T - T_o + sqrt((port.T - T_o)^2 + T_e^2));
  annotation (
    __Analogon(effect(
      kind = "proposal.heat.valve",
      proposal = "port.Q_flow = a*max(0, T - T_o)",
      way = "attach",
      ports = {"port"},
      strength = "a",
      oneSided = true,
      fixed(T_e = "0.005*range(T)"),
      shape(T_o = {"minimum(T) + 0.35*range(T)", "minimum(T) + 0.55*range(T)", "minimum(T) + 0.75*range(T)"}))),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, pattern=LinePattern.Dash, radius=10),
        Text(extent={{-70,60},{70,-60}}, textString="?", textColor={213,94,0})}),
    Documentation(info="<html>
<p>A thermostat that opens, a liquid that begins to boil, a fan that is switched on: from a temperature on the body loses more.</p>
<pre>
  port.Q_flow = a*max(0, T - T_o)
</pre>
</html>"));
end HeatValve;
