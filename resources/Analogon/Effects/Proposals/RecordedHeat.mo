within Analogon.Effects.Proposals;
model RecordedHeat "Heat flow that was recorded but not given to the model"
  extends Analogon.Interfaces.PartialOneHeatPort;
  Analogon.Interfaces.RealInput u(unit="W") "Recorded channel"
    annotation (Placement(transformation(origin={0,-100}, extent={{-20,-20},{20,20}}, rotation=90)));
  parameter Real a(unit="1") = 0 "Factor (0: off)"
    annotation (Dialog(group="Effect"));
equation
  port.Q_flow = a*u;
  annotation (
    __Analogon(effect(
      kind = "proposal.heat.recorded",
      proposal = "port.Q_flow = a*channel",
      way = "attach",
      ports = {"port"},
      strength = "a",
      quantity = "W",
      channel = "u")),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, pattern=LinePattern.Dash, radius=10),
        Text(extent={{-70,60},{70,-60}}, textString="u", textColor={213,94,0})}),
    Documentation(info="<html>
<p>Heat flow that was recorded but not given to the model: a multiple of a recorded channel of its unit.</p>
<pre>
  port.Q_flow = a*u
</pre>
</html>"));
end RecordedHeat;
