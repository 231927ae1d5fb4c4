within Analogon.Mechanics;
model QuadraticLoad "Load torque with the square of the speed: pump, fan"
  extends Analogon.Interfaces.PartialOneFlange;
  parameter Real k_q(unit="N.m.s2/rad2", min=0) = 1e-6 "Torque per square of the speed"
    annotation (Dialog(group="Parameters"));
equation
  flange.tau = k_q*w*noEvent(abs(w));
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Ellipse(extent={{-62,62},{62,-62}}, lineColor={95,95,95}, fillColor={240,240,240}, fillPattern=FillPattern.Solid),
        Polygon(points={{0,0},{12,30},{0,58},{-22,46},{-14,20}}, lineColor={95,95,95}, fillColor={192,198,206}, fillPattern=FillPattern.Solid),
        Polygon(points={{0,0},{30,-12},{58,0},{46,22},{20,14}}, lineColor={95,95,95}, fillColor={192,198,206}, fillPattern=FillPattern.Solid),
        Polygon(points={{0,0},{-12,-30},{0,-58},{22,-46},{14,-20}}, lineColor={95,95,95}, fillColor={192,198,206}, fillPattern=FillPattern.Solid),
        Polygon(points={{0,0},{-30,12},{-58,0},{-46,-22},{-20,-14}}, lineColor={95,95,95}, fillColor={192,198,206}, fillPattern=FillPattern.Solid),
        Ellipse(extent={{-10,10},{10,-10}}, lineColor={95,95,95}, fillColor={255,255,255}, fillPattern=FillPattern.Solid)}),
    Documentation(info="<html>
<p>The torque of an impeller or fan at a constant circuit. It always opposes the motion.</p>
<pre>
  flange.tau = k_q*w*abs(w)
</pre>
</html>"));
end QuadraticLoad;
