within Analogon.MechanicThermal;
partial model PartialMechanicThermal "Shaft whose friction heats a place, without the law of friction"
  extends Analogon.Interfaces.PartialTwoFlanges;
  Analogon.Interfaces.HeatPort_b heatPort "Place that is heated"
    annotation (Placement(transformation(extent={{-10,-110},{10,-90}})));
  parameter Real b(unit="N.m.s/rad", min=0) = 1e-4 "Friction torque per speed"
    annotation (Dialog(group="Parameters"));
  Real phi(unit="rad") "Angle";
  Real w(unit="rad/s") "Speed";
  Real tau_f(unit="N.m") "Friction torque";
equation
  phi = flange_a.phi;
  phi = flange_b.phi;
  w = der(phi);
  flange_a.tau + flange_b.tau = tau_f;
  heatPort.Q_flow = -tau_f*w;
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-100,8},{100,-8}}, lineColor={95,95,95}, fillColor={192,198,206}, fillPattern=FillPattern.Solid),
        Polygon(points={{-60,60},{60,60},{40,14},{-40,14}}, lineColor={0,0,0}, fillColor={222,206,196}, fillPattern=FillPattern.Solid),
        Polygon(points={{-60,-60},{60,-60},{40,-14},{-40,-14}}, lineColor={0,0,0}, fillColor={222,206,196}, fillPattern=FillPattern.Solid),
        Line(points={{0,-60},{0,-100}}, color={191,0,0}, thickness=0.5),
        Line(points={{-36,-62},{-42,-72},{-30,-82},{-36,-94}}, color={191,0,0}, thickness=0.5, smooth=Smooth.Bezier),
        Line(points={{36,-62},{30,-72},{42,-82},{36,-94}}, color={191,0,0}, thickness=0.5, smooth=Smooth.Bezier)}),
    Documentation(info="<html>
<p>Base of bearings and brakes. A class that extends it adds one equation for the friction torque tau_f.</p>
<pre>
  flange_a.tau + flange_b.tau = tau_f
  heatPort.Q_flow = -tau_f*w
</pre>
</html>"));
end PartialMechanicThermal;
