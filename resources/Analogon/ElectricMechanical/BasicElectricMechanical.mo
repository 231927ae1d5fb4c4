within Analogon.ElectricMechanical;
model BasicElectricMechanical "Direct-current machine with permanent field"
  extends PartialElectricMechanical;
equation
  v = R*i + L*der(i) + k*w;
  flange.tau = -k*i;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Text(extent={{-50,40},{50,-40}}, textString="M", textColor={0,0,0}, textStyle={TextStyle.Bold})}),
    Documentation(info="<html>
<p>The basic class of the electrical and mechanical domain: winding with resistance R and inductance L, voltage induced by the turning rotor, torque from the current. The rotor's inertia is not in it; put an inertia on the shaft. The current starts at 0.</p>
<pre>
  v = R*i + L*der(i) + k*der(flange.phi)
  flange.tau = -k*i
</pre>
<p>L = 0 is legal: the current then follows the voltage at once.</p>
</html>"));
end BasicElectricMechanical;
