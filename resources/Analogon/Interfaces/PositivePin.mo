within Analogon.Interfaces;
connector PositivePin "Electrical pin (filled: the positive side)"
  Real v(unit="V") "Potential at the pin";
  flow Real i(unit="A") "Current into the component";
  annotation (
    Icon(coordinateSystem(extent={{-100,-100},{100,100}}), graphics={
        Rectangle(extent={{-100,-100},{100,100}}, lineColor={0,0,255}, fillColor={0,0,255}, fillPattern=FillPattern.Solid)}),
    Documentation(info="<html>
<p>One end of a wire: the potential v is the same for all that is connected, the currents i into the components sum to zero.</p>
</html>"));
end PositivePin;
