within Analogon.Effects.Proposals;
model FieldOfAngle "Torque constant that changes with the angle"
  extends Analogon.ElectricMechanical.PartialElectricMechanical;
  parameter Real a(unit="1/rad") = 0 "Relative change per angle (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real b(unit="1/rad2") = 0 "Relative change per square of the angle"
    annotation (Dialog(group="Effect"));
  Real phi(unit="rad") "Angle of the shaft";
  Real k_phi(unit="N.m/A") "Torque constant at the present angle";
equation
  phi = flange.phi;
  k_phi = k*(1 + a*phi + b*phi^2);
  v = R*i + L*der(i) + k_phi*w;
  flange.tau = -k_phi*i;
  annotation (
    __Analogon(effect(
      kind = "proposal.field.angle",
      proposal = "k_phi = k*(1 + a*phi + b*phi^2)",
      way = "specialise",
      strength = "a",
      linear = {"b"},
      valid = "20 - range(phi)")),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Text(extent={{-50,40},{50,-40}}, textString="M", textColor={0,0,0}, textStyle={TextStyle.Bold}),
        Rectangle(extent={{30,-50},{110,-100}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, pattern=LinePattern.Dash, radius=8),
        Text(extent={{34,-56},{106,-94}}, textString="?", textColor={213,94,0}, textStyle={TextStyle.Bold})}),
    Documentation(info="<html>
<p>A rotary magnet or a torque motor that leaves the angle at which it pulls best.</p>
<pre>
  k_phi = k*(1 + a*phi + b*phi^2)
  v = R*i + L*der(i) + k_phi*w
  flange.tau = -k_phi*i
</pre>
</html>"));
end FieldOfAngle;
