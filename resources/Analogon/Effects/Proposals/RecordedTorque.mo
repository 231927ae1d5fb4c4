within Analogon.Effects.Proposals;
model RecordedTorque "Torque that was recorded but not given to the model"
  extends Analogon.Interfaces.PartialOneFlange;
  Analogon.Interfaces.RealInput u(unit="N.m") "Recorded channel"
    annotation (Placement(transformation(origin={0,-100}, extent={{-20,-20},{20,20}}, rotation=90)));
  parameter Real a(unit="1") = 0 "Factor (0: off)"
    annotation (Dialog(group="Effect"));
equation
  flange.tau = a*u;
  annotation (
    __Analogon(effect(
      kind = "proposal.torque.recorded",
      proposal = "flange.tau = a*channel",
      way = "attach",
      ports = {"flange"},
      strength = "a",
      quantity = "N.m",
      channel = "u")),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, pattern=LinePattern.Dash, radius=10),
        Text(extent={{-70,60},{70,-60}}, textString="u", textColor={213,94,0})}),
    Documentation(info="<html>
<p>Torque that was recorded but not given to the model: a multiple of a recorded channel of its unit.</p>
<pre>
  flange.tau = a*u
</pre>
</html>"));
end RecordedTorque;
