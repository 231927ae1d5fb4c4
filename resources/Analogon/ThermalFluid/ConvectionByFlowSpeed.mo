within Analogon.ThermalFluid;
model ConvectionByFlowSpeed "Body with heat capacity in a stream of measured speed"
  extends PartialThermalFluid;
  Analogon.Interfaces.RealInput speed(unit="km/h") "Speed of the stream"
    annotation (Placement(transformation(origin={0,-100}, extent={{-20,-20},{20,20}}, rotation=90)));
equation
  G_c = c_o*A*noEvent(if speed > 0 then (speed/3.6)^0.78 else 0);
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Line(points={{0,-100},{0,-80},{40,-80}}, color={0,0,127}, arrow={Arrow.None,Arrow.Filled})}),
    Documentation(info="<html>
<p>As BasicThermalFluid, with the speed of the stream under the exponent: the law of Juerges. The speed is in km/h, so speed/3.6 is in m/s. A stream that stands still takes no heat; a negative speed counts as 0.</p>
<pre>
  G_c = c_o*A*(speed/3.6)^0.78
</pre>
</html>"));
end ConvectionByFlowSpeed;
