within Analogon.Interfaces;
connector Flange_b "Rotational flange (open: the side that is usually driven)"
  Real phi(unit="rad", displayUnit="rad") "Angle of the shaft";
  flow Real tau(unit="N.m") "Torque into the component";
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Ellipse(extent={{-100,-100},{100,100}}, lineColor={95,95,95}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, lineThickness=0.5)}),
    Documentation(info="<html>
<p>One end of a shaft: the angle phi is the same for all that is connected, the torques tau into the components sum to zero.</p>
</html>"));
end Flange_b;
