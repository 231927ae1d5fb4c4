within Analogon.Effects.Proposals;
model SaturatingField "Torque constant that falls with the current"
  extends Analogon.ElectricMechanical.PartialElectricMechanical;
  parameter Real q(unit="1/A2", min=0) = 0 "1/i_s^2: at the current i_s the torque constant is down to 0.71 (0: off)"
    annotation (Dialog(group="Effect"));
  Real k_i(unit="N.m/A") "Torque constant at the present current";
equation
  k_i = k/sqrt(1 + q*i^2);
  v = R*i + L*der(i) + k_i*w;
  flange.tau = -k_i*i;
  annotation (
    __Analogon(effect(
      kind = "proposal.field.saturation",
      proposal = "k_i = k/sqrt(1 + q*i^2)",
      way = "specialise",
      strength = "q",
      oneSided = true)),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Text(extent={{-50,40},{50,-40}}, textString="M", textColor={0,0,0}, textStyle={TextStyle.Bold}),
        Rectangle(extent={{30,-50},{110,-100}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, pattern=LinePattern.Dash, radius=8),
        Text(extent={{34,-56},{106,-94}}, textString="?", textColor={213,94,0}, textStyle={TextStyle.Bold})}),
    Documentation(info="<html>
<p>A machine whose iron saturates, or whose field the current of the armature weakens.</p>
<pre>
  k_i = k/sqrt(1 + q*i^2)
  v = R*i + L*der(i) + k_i*w
  flange.tau = -k_i*i
</pre>
</html>"));
end SaturatingField;
