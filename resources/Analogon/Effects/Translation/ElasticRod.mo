within Analogon.Effects.Translation;
model ElasticRod "Rod that gives way"
  extends Analogon.Interfaces.PartialTwoTranslationalFlanges;
  parameter Real e(unit="m/N", min=0) = 0 "Compliance 1/c (0: rigid)"
    annotation (Dialog(group="Effect"));
  parameter Real d(unit="N.s/m", min=0) = 0 "Damping"
    annotation (Dialog(group="Effect"));
  final parameter Real c(unit="N/m") = if e > 0 then 1/e else 0 "Stiffness 1/e (0 while the rod is rigid)";
  Real s_rel(unit="m") "Elongation: flange_b against flange_a";
  Real v_rel(unit="m/s") "Rate of elongation";
  Real f(unit="N") "Force in the rod";
  Real v(unit="m/s") "Velocity of flange_a";
initial equation
  v_rel = 0;
equation
  s_rel = flange_b.s - flange_a.s;
  v_rel = der(s_rel);
  v = der(flange_a.s);
  e*(f - d*v_rel) = s_rel;
  flange_b.f = f;
  flange_a.f = -f;
  annotation (
    __Analogon(effect(
      kind = "compliance.rod",
      way = "insert",
      ports = {"flange_a", "flange_b"},
      strength = "e",
      oneSided = true,
      states = 2,
      shape(d = {"0.2*sqrt(maxabs(f)/rate(v)/e)", "sqrt(maxabs(f)/rate(v)/e)"}),
      secant = {"(6*sample)^2*rate(v)/maxabs(f)", "(24*sample)^2*rate(v)/maxabs(f)", "(96*sample)^2*rate(v)/maxabs(f)", "0.1*sample*rms(v)/maxabs(f)"})),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=10),
        Line(points={{-100,0},{-50,0},{-40,30},{-20,-30},{0,30},{20,-30},{40,30},{50,0},{100,0}}, color={95,95,95}, thickness=0.75)}),
    Documentation(info="<html>
<p>An elastic, damped rod where the model had a rigid one. The strength is the compliance e = 1/c, so that 0 is the rigid rod.</p>
<pre>
  s_rel = flange_b.s - flange_a.s
  f     = s_rel/e + d*der(s_rel)
  flange_b.f = f,  flange_a.f = -f
</pre>
</html>"));
end ElasticRod;
