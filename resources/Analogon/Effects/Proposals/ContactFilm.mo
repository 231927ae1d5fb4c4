within Analogon.Effects.Proposals;
model ContactFilm "Contact whose resistance falls with the current"
  extends Analogon.ElectricMechanical.PartialElectricMechanical;
  parameter Real R_c(unit="Ohm", min=0) = 0 "Resistance at small currents (0: none)"
    annotation (Dialog(group="Effect"));
  parameter Real i_c(unit="A", min=1e-12) = 1 "Current at which half of it is left"
    annotation (Dialog(group="Effect"));
  parameter Real m(unit="1", min=0.1) = 1 "How steeply it falls"
    annotation (Dialog(group="Effect"));
equation
  v = R*i + R_c*i/(1 + (abs(i)/i_c)^m) + L*der(i) + k*w;
  flange.tau = -k*i;
  annotation (
    __Analogon(effect(
      kind = "proposal.contact.film",
      proposal = "v_c = R_c*i/(1 + (abs(i)/i_c)^m)",
      way = "specialise",
      strength = "R_c",
      oneSided = true,
      reach(m = 1.5, i_c = 1.3),
      shape(i_c = {"0.02*maxabs(i)", "0.1*maxabs(i)", "0.4*maxabs(i)"}, m = {"1", "2"}))),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Text(extent={{-50,40},{50,-40}}, textString="M", textColor={0,0,0}, textStyle={TextStyle.Bold}),
        Rectangle(extent={{30,-50},{110,-100}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, pattern=LinePattern.Dash, radius=8),
        Text(extent={{34,-56},{106,-94}}, textString="?", textColor={213,94,0}, textStyle={TextStyle.Bold})}),
    Documentation(info="<html>
<p>The film under a brush or in a plug: it conducts the better the more current flows. With m = 1 its voltage rises to R_c*i_c and stays there, with m = 2 it falls again.</p>
<pre>
  v = R*i + R_c*i/(1 + (abs(i)/i_c)^m) + L*der(i) + k*w
  flange.tau = -k*i
</pre>
</html>"));
end ContactFilm;
