within Analogon.Interfaces;
connector HeatPort_b "Heat port (open)"
  Real T(unit="K", displayUnit="degC", start=293.15, nominal=300) "Temperature of the port";
  flow Real Q_flow(unit="W") "Heat flow into the component";
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-100,-100},{100,100}}, lineColor={191,0,0}, fillColor={255,255,255}, fillPattern=FillPattern.Solid, lineThickness=0.5)}),
    Documentation(info="<html>
<p>A place that exchanges heat: the temperature T is the same for all that is connected, the heat flows Q_flow into the components sum to zero.</p>
</html>"));
end HeatPort_b;
