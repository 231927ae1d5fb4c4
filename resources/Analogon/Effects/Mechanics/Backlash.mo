within Analogon.Effects.Mechanics;
model Backlash "Play in the gear"
  extends Analogon.Interfaces.PartialTwoFlanges;
  parameter Real b(unit="rad", min=0) = 0 "Width of the play (0: none)"
    annotation (Dialog(group="Effect"));
  parameter Real c(unit="N.m/rad", min=1e-9) = 1e5 "Stiffness of the teeth in contact"
    annotation (Dialog(group="Effect"));
  parameter Real d(unit="N.m.s/rad", min=0) = 1 "Damping of the teeth in contact"
    annotation (Dialog(group="Effect"));
  parameter Real phi_eps(unit="rad", min=1e-12) = 1e-4 "Angle over which the contact sets in"
    annotation (Dialog(group="Numerics"));
  Real phi_rel(unit="rad") "Angle of flange_b against flange_a";
  Real w_rel(unit="rad/s") "Its rate";
  Real phi_c(unit="rad") "Deflection of the teeth";
  Real contact(unit="1") "1 in contact, 0 in the play";
  Real tau(unit="N.m") "Torque that is passed on";
  Real w(unit="rad/s") "Speed of flange_a";
equation
  phi_rel = flange_b.phi - flange_a.phi;
  w_rel = der(phi_rel);
  w = der(flange_a.phi);
  phi_c = phi_rel + (sqrt((phi_rel - b/2)^2 + phi_eps^2) - sqrt((phi_rel + b/2)^2 + phi_eps^2))/2;
  contact = 1 + ((phi_rel - b/2)/sqrt((phi_rel - b/2)^2 + phi_eps^2) - (phi_rel + b/2)/sqrt((phi_rel + b/2)^2 + phi_eps^2))/2;
  b*(tau - c*phi_c - d*contact*w_rel) = 1e-9*c*phi_eps*phi_rel;
  flange_b.tau = tau;
  flange_a.tau = -tau;
  annotation (
    __Analogon(effect(
      kind = "backlash",
      way = "insert",
      ports = {"flange_a", "flange_b"},
      strength = "b",
      oneSided = true,
      fixed(phi_eps = "0.01*sample*rms(w)"),
      sharper(phi_eps = 0.25),
      shape(c = {"5*maxabs(tau)/(sample*rms(w))"}, d = {"0.3*maxabs(tau)/rms(w)"}),
      secant = {"2*sample*rms(w)", "10*sample*rms(w)", "50*sample*rms(w)"})),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=10),
        Line(points={{-100,0},{-40,0}}, color={95,95,95}, thickness=0.75),
        Line(points={{-10,0},{100,0}}, color={95,95,95}, thickness=0.75),
        Line(points={{40,40},{-40,40},{-40,-40},{40,-40}}, color={95,95,95}, thickness=0.75),
        Polygon(points={{-10,20},{30,20},{30,-20},{-10,-20}}, lineColor={95,95,95}, fillColor={192,198,206}, fillPattern=FillPattern.Solid),
        Line(points={{-40,60},{-10,60}}, color={213,94,0}, thickness=0.5, arrow={Arrow.None,Arrow.Filled})}),
    Documentation(info="<html>
<p>Two toothed wheels that touch on one side only: within the play of width b no torque is passed on, beyond it the teeth are elastic and damped. Without play the connection is rigid.</p>
<pre>
  phi_rel = flange_b.phi - flange_a.phi
  tau     = c*(phi_rel - b/2) + d*der(phi_rel)    beyond  b/2
  tau     = 0                                     within  the play
  tau     = c*(phi_rel + b/2) + d*der(phi_rel)    beyond -b/2
</pre>
<p>The corners are rounded over phi_eps. The equation is multiplied by b, so that b = 0 leaves phi_rel = 0, the rigid shaft; a stiffness of less than c/1e9 keeps the play from drifting.</p>
</html>"));
end Backlash;
