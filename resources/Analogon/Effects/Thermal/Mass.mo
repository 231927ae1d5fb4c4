within Analogon.Effects.Thermal;
model Mass "Second mass behind a conductance"
  extends Analogon.Interfaces.PartialOneHeatPort;
  parameter Real C2(unit="J/K", min=0) = 0 "Heat capacity of the second mass (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real tau_2(unit="s", min=1e-9) = 1 "Time constant with which the second mass follows"
    annotation (Dialog(group="Effect"));
  final parameter Real G2(unit="W/K") = C2/tau_2 "Conductance between the masses: follows from the two above"
    annotation (Dialog(group="Effect"));
  Real T2(unit="K", displayUnit="degC", start=293.15, nominal=300) "Temperature of the second mass";
initial equation
  T2 = port.T;
equation
  tau_2*der(T2) = T - T2;
  port.Q_flow = C2*der(T2);
  annotation (
    __Analogon(effect(
      kind = "thermal.mass",
      way = "attach",
      ports = {"port"},
      strength = "C2",
      oneSided = true,
      shape(tau_2 = {"0.01*duration", "0.04*duration", "0.15*duration", "0.5*duration"}))),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=10),
        Line(points={{-100,0},{-60,0}}, color={191,0,0}, thickness=0.5),
        Rectangle(extent={{-60,40},{-16,-40}}, lineColor={191,0,0}, fillColor={250,224,216}, fillPattern=FillPattern.Solid),
        Line(points={{-16,0},{14,0}}, color={191,0,0}, thickness=0.75),
        Rectangle(extent={{14,60},{74,-60}}, lineColor={191,0,0}, fillColor={250,224,216}, fillPattern=FillPattern.Solid),
        Text(extent={{14,24},{74,-24}}, textString="C2", textColor={191,0,0})}),
    Documentation(info="<html>
<p>A part that is heated through a conductance G2 and stores heat: a holder, a housing, a layer. It starts at the temperature of the port. The conductance is given by the time constant, G2 = C2/tau_2.</p>
<pre>
  C2*der(T2)  = port.Q_flow
  port.Q_flow = G2*(port.T - T2)
  T2(0)       = port.T(0)
</pre>
</html>"));
end Mass;
