within Analogon.Effects.Translation;
model Backlash "Play between two rods"
  extends Analogon.Interfaces.PartialTwoTranslationalFlanges;
  parameter Real b(unit="m", min=0) = 0 "Width of the play (0: none)"
    annotation (Dialog(group="Effect"));
  parameter Real c(unit="N/m", min=1e-9) = 1e7 "Stiffness in contact"
    annotation (Dialog(group="Effect"));
  parameter Real d(unit="N.s/m", min=0) = 100 "Damping in contact"
    annotation (Dialog(group="Effect"));
  parameter Real s_eps(unit="m", min=1e-15) = 1e-6 "Distance over which the contact sets in"
    annotation (Dialog(group="Numerics"));
  Real s_rel(unit="m") "Distance: flange_b against flange_a";
  Real v_rel(unit="m/s") "Its rate";
  Real s_c(unit="m") "Deflection in contact";
  Real contact(unit="1") "1 in contact, 0 in the play";
  Real f(unit="N") "Force that is passed on";
  Real v(unit="m/s") "Velocity of flange_a";
equation
  s_rel = flange_b.s - flange_a.s;
  v_rel = der(s_rel);
  v = der(flange_a.s);
  s_c = s_rel + (sqrt((s_rel - b/2)^2 + s_eps^2) - sqrt((s_rel + b/2)^2 + s_eps^2))/2;
  contact = 1 + ((s_rel - b/2)/sqrt((s_rel - b/2)^2 + s_eps^2) - (s_rel + b/2)/sqrt((s_rel + b/2)^2 + s_eps^2))/2;
  b*(f - c*s_c - d*contact*v_rel) = 1e-9*c*s_eps*s_rel;
  flange_b.f = f;
  flange_a.f = -f;
  annotation (
    __Analogon(effect(
      kind = "backlash",
      way = "insert",
      ports = {"flange_a", "flange_b"},
      strength = "b",
      oneSided = true,
      fixed(s_eps = "0.01*sample*rms(v)"),
      sharper(s_eps = 0.25),
      shape(c = {"5*maxabs(f)/(sample*rms(v))"}, d = {"0.3*maxabs(f)/rms(v)"}),
      secant = {"2*sample*rms(v)", "10*sample*rms(v)", "50*sample*rms(v)"})),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=10),
        Line(points={{-100,0},{-40,0}}, color={95,95,95}, thickness=0.75),
        Line(points={{-10,0},{100,0}}, color={95,95,95}, thickness=0.75),
        Line(points={{40,40},{-40,40},{-40,-40},{40,-40}}, color={95,95,95}, thickness=0.75),
        Rectangle(extent={{-10,20},{30,-20}}, lineColor={0,127,0}, fillColor={214,232,214}, fillPattern=FillPattern.Solid)}),
    Documentation(info="<html>
<p>A fork that holds a pin with play, a nut on a spindle: within the play of width b no force is passed on, beyond it the contact is elastic and damped. Without play the connection is rigid.</p>
<pre>
  s_rel = flange_b.s - flange_a.s
  f     = c*(s_rel - b/2) + d*der(s_rel)    beyond  b/2
  f     = 0                                 within  the play
  f     = c*(s_rel + b/2) + d*der(s_rel)    beyond -b/2
</pre>
<p>The corners are rounded over s_eps. The equation is multiplied by b, so that b = 0 leaves s_rel = 0, the rigid rod; a stiffness of less than c/1e9 keeps the play from drifting.</p>
</html>"));
end Backlash;
