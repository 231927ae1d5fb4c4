within Analogon.Effects.Mechanics;
model CoggingTorque "Torque that repeats n times per turn"
  extends Analogon.Interfaces.PartialOneFlange;
  parameter Real tau_n(unit="N.m") = 0 "Largest torque (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real n(unit="1", min=1) = 4 "Periods per turn"
    annotation (Dialog(group="Effect"));
  parameter Real phi_0(unit="rad") = 0 "Phase"
    annotation (Dialog(group="Effect"));
equation
  flange.tau = tau_n*sin(n*phi - phi_0);
  annotation (
    __Analogon(effect(
      kind = "torque.cogging",
      way = "attach",
      ports = {"flange"},
      strength = "tau_n",
      valid = "n*range(phi) - 3.141593",
      whole = {"n"},
      phase = "phi_0",
      along = "phi",
      waves = "n",
      reach(n = 1.3),
      shape(n = {"2", "3", "4", "5", "6", "7", "8", "9", "10", "12"}))),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-90,90},{90,-90}}, lineColor={213,94,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, radius=10),
        Line(points={{-100,0},{-90,0}}, color={95,95,95}, thickness=0.5),
        Line(points={{-70,0},{80,0}}, color={128,128,128}),
        Line(points={{-70,0},{-65,28.057},{-60,43.8717},{-55,40.5436},{-50,19.5249},{-45,-10.0133},{-40,-35.1823},{-35,-45},{-30,-35.1825},{-25,-10.0137},{-20,19.5245},{-15,40.5435},{-10,43.8718},{-5,28.0573},{0,0.000358235},{5,-28.0567},{10,-43.8717},{15,-40.5438},{20,-19.5252},{25,10.013},{30,35.1821},{35,45},{40,35.1828},{45,10.014},{50,-19.5242},{55,-40.5433},{60,-43.8719},{65,-28.0576},{70,-0.000716469}}, color={95,95,95}, thickness=0.75, smooth=Smooth.Bezier)}),
    Documentation(info="<html>
<p>The pull of the slots of a motor with permanent magnets, or the teeth of a gear.</p>
<pre>
  flange.tau = tau_n*sin(n*phi - phi_0)
</pre>
</html>"));
end CoggingTorque;
