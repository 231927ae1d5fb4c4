within Analogon.Effects.ThermalFluid;
model NaturalConvection "Convection that depends on the temperature difference"
  extends Analogon.ThermalFluid.PartialThermalFluid;
  parameter Real n(unit="1", min=0, max=3) = 0 "Exponent of the temperature difference (0: off)"
    annotation (Dialog(group="Effect"));
  parameter Real dT_ref(unit="K", min=1e-6) = 10 "Difference at which the conductance is that without the effect"
    annotation (Dialog(group="Effect"));
  parameter Real dT_eps(unit="K", min=1e-9) = 0.1 "Difference below which the power is smoothed"
    annotation (Dialog(group="Numerics"));
equation
  G_c = c_o*A*(fluid.T/3.6)^0.78*((dT^2 + dT_eps^2)/dT_ref^2)^(n/2);
  annotation (
    __Analogon(effect(
      kind = "convection.exponent",
      way = "specialise",
      strength = "n",
      fixed(dT_ref = "rms(dT)", dT_eps = "0.01*rms(dT)"))),
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Text(extent={{-66,-72},{70,-100}}, textString="dT^n", textColor={213,94,0}, textStyle={TextStyle.Bold})}),
    Documentation(info="<html>
<p>As BasicThermalFluid, with the conductance multiplied by a power of the difference between body and stream, as natural convection has it (n about 0.25 to 0.33).</p>
<pre>
  G_c = c_o*A*(fluid.T/3.6)^0.78*(abs(solid.T - fluid.T)/dT_ref)^n
</pre>
<p>The difference is smoothed below dT_eps so that the power has a slope at 0.</p>
</html>"));
end NaturalConvection;
