within Analogon.Effects.Proposals;
block SensorPeriodic "Reading with a hum of its own"
  extends Analogon.Interfaces.PartialSignal;
  parameter Real a = 0 "Sine part (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real b = 0 "Cosine part"
    annotation (Dialog(group="Effect"));
  parameter Real P(unit="s", min=1e-9) = 1 "Period"
    annotation (Dialog(group="Effect"));
equation
  y = u + a*sin(6.283185307179586*time/P) + b*cos(6.283185307179586*time/P);
  annotation (
    __Analogon(effect(
      kind = "proposal.sensor.periodic",
      proposal = "y = u + a*sin(2*pi*time/P) + b*cos(2*pi*time/P)",
      way = "insert",
      ports = {"u", "y"},
      at = "output",
      strength = "a",
      linear = {"b"},
      inSignalUnit = {"a", "b"},
      reach(P = 1.3),
      shape(P = {"min(period, 0.1*duration)"}))),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, pattern=LinePattern.Dash, radius=10),
        Text(extent={{-70,60},{70,-60}}, textString="?", textColor={213,94,0})}),
    Documentation(info="<html>
<p>The mains, a fan or a beat with the sampling that reaches the cable or the amplifier and not the component.</p>
<pre>
  y = u + a*sin(2*pi*time/P) + b*cos(2*pi*time/P)
</pre>
</html>"));
end SensorPeriodic;
